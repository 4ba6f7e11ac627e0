//! The section of the page on how steady each method is, and what it cannot see.

use crate::chart::MethodStyles;
use crate::number::{interval, short};
use crate::page::legend;
use crate::results::{MethodResults, SceneResults, Stability};
use maud::{Markup, html};

/// Red boxes for blind methods, then the figures of all.
pub(crate) fn stability(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    html! {
        h3 { "Stability" }
        @for method in scene.methods.iter().filter(|method| !method.blind.is_empty()) {
            (blind(method, styles))
        }
        div.scroll { table {
            caption { "Steadiness over runs, after the longest budget" }
            thead { tr {
                th scope="col" { "method" } th scope="col" { "tail index (95 %)" }
                th scope="col" { "alarm" } th scope="col" { "fireflies a megapixel" }
                th scope="col" { "worst run over median" } th scope="col" { "samples left out" }
            } }
            tbody { @for method in &scene.methods { (row(method, styles)) } }
        } }
        p.note {
            "A tail index below 2 that does not grow further out in the tail raises the alarm: \
             single samples are so large, so often, that no variance exists, error bars are void \
             and averages do not settle. An index that grows belongs to a tail that ends. A \
             firefly is a pixel off by more than ten deviations and a tenth of the mean. Samples \
             left out were negative or not finite."
        }
    }
}

fn blind(method: &MethodResults, styles: &MethodStyles) -> Markup {
    html! {
        div.box.blind role="note" {
            b { (legend::name(styles, method)) " is blind here." }
            " It cannot produce, however long it renders:"
            ul { @for light in &method.blind { li { (light) } } }
        }
    }
}

fn row(method: &MethodResults, styles: &MethodStyles) -> Markup {
    let Stability { tail, alarm, fireflies, worst_over_median, rejected } = method.stability;
    html! {
        tr {
            th scope="row" { (legend::name(styles, method)) }
            td { @match tail { Some(tail) => (interval(tail)), None => "no tail" } }
            td.alarm[alarm] { @if alarm { "no variance" } @else { "none" } }
            td { (fireflies.map_or_else(|| "—".to_string(), short)) }
            td { (short(worst_over_median)) }
            td.alarm[rejected > 0] { (rejected) }
        }
    }
}
