//! Measurement against theory.

use crate::chart::{MethodStyles, Quantity, oracle as chart};
use crate::number::{interval_of, prefixed, significant};
use crate::page::legend;
use crate::results::{Oracle, OracleCrossing};
use maud::{Markup, html};

/// Both charts and both crossings.
pub(crate) fn oracle(found: &Oracle, styles: &MethodStyles) -> Markup {
    html! {
        section id="oracle" {
            h2 { "Against theory" }
            p {
                "A disk lamp of radius R above a matt plane at height h, where the noise of one \
                 sample has a closed form. Points on the lines show that the noise on this page \
                 is measured rightly."
            }
            ul.legend {
                @for curve in &found.curves { li { (legend::plain(styles, &curve.method)) } }
            }
            div.pair {
                figure {
                    div.chart { (chart(found, Quantity::Variance, styles)) }
                    figcaption { (variance_caption(found)) }
                }
                figure {
                    div.chart { (chart(found, Quantity::Cost, styles)) }
                    figcaption {
                        "The same times the seconds that a sample takes: what an error costs. \
                         Lines are theory with the measured seconds."
                    }
                }
            }
            p { (crossing("puremc and directlight are equally noisy", found.crossing, "95 %")) }
            p {
                (crossing("They cost the same, time included,", found.crossing_in_time, "95 %"))
            }
        }
    }
}

fn variance_caption(found: &Oracle) -> String {
    format!(
        "Variance of one sample. Lines are theory, points are measured over {} samples with \
         intervals of 99.9 %; the upright line is the measured crossing.",
        prefixed(found.samples as f64)
    )
}

fn crossing(what: &str, found: OracleCrossing, level: &str) -> String {
    let OracleCrossing { measured, theory } = found;
    let inside = (measured.low..=measured.high).contains(&theory);
    format!(
        "{what} at R/h = {} by measurement ({level} interval) and {} by theory, which is {} the \
         interval.",
        interval_of(measured, 4),
        significant(theory, 4),
        if inside { "inside" } else { "outside" }
    )
}
