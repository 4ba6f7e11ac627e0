//! The section of the page on the cost of an error, and its factors.

use crate::chart::{Bar, Baseline, MethodStyles, bars};
use crate::number::{bytes, interval, percent, prefixed, ratio, seconds_interval, short};
use crate::page::legend;
use crate::results::{Estimate, MethodResults, SceneResults};
use maud::{Markup, html};

const CAPTION: &str = "Above: how much less a given error costs than elsewhere; longer is better, \
    and the intervals of all methods hold together with 95 %. Below, why: a method is slow because \
    a pass is noisy (left) or because a pass takes long (right); bars to the left of one are better \
    than the best. Noise alone, without the light that a method loses. Hollow: the method does not \
    see all light of the scene, and no bar says how much it is worth.";

/// Bars of efficiency, bars of its two factors, and a table of both.
pub(crate) fn efficiency(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    let best = scene.methods.iter().find(|m| Some(&m.name) == scene.verdict.best.as_ref());
    html! {
        h3 { "Efficiency" }
        @if let Some(best) = best {
            figure {
                div.chart { (whole(scene, styles)) }
                div.pair { (factors(scene, best, styles)) }
                figcaption { (CAPTION) }
            }
        } @else { p.note { "Without a best method there are no factors to draw." } }
        (costs(scene, styles))
        (metrics(scene, styles))
    }
}

/// Efficiency over that of the best, a bar each method.
pub(crate) fn whole(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    let label = format!("Efficiency on {} relative to the best, logarithmic", scene.name);
    let row = |method: &MethodResults| (inverse(method.cost_ratio), ratio(method).as_long());
    let rows = rows(scene, styles, row);
    bars(&label, "1/(error × seconds), best = 1", &rows, Baseline::Left)
}

/// Error and time of a pass, each over that of the best.
fn factors(scene: &SceneResults, best: &MethodResults, styles: &MethodStyles) -> Markup {
    let chart = |what: &str, of: fn(&MethodResults) -> Estimate| {
        let label = format!("{what} of a pass over that of {}", best.name);
        let axis = format!("{what} of a pass, best = 1");
        let row = |method: &MethodResults| {
            let over = over(of(method), of(best).value);
            (over, short(over.value))
        };
        let rows = rows(scene, styles, row);
        html! { div.chart { (bars(&label, &axis, &rows, Baseline::One)) } }
    };
    html! {
        (chart("error", |method| method.error_per_pass))
        (chart("time", |method| method.seconds_per_pass))
    }
}

fn rows(
    scene: &SceneResults,
    styles: &MethodStyles,
    of: impl Fn(&MethodResults) -> (Estimate, String),
) -> Vec<Bar> {
    let bar = |method: &MethodResults| {
        let (estimate, words) = of(method);
        Bar {
            name: method.marked_name(),
            colour: styles.style(&method.name).colour(),
            hollow: method.badge().is_some(),
            estimate,
            words,
        }
    };
    scene.methods.iter().map(bar).collect()
}

fn ratio_cell(method: &MethodResults, scene: &SceneResults) -> String {
    scene.verdict.best.as_ref().map_or_else(|| "–".into(), |_| ratio(method).cell())
}

fn inverse(Estimate { value, low, high }: Estimate) -> Estimate {
    Estimate { value: 1.0 / value, low: 1.0 / high, high: 1.0 / low }
}

fn over(Estimate { value, low, high }: Estimate, divisor: f64) -> Estimate {
    Estimate { value: value / divisor, low: low / divisor, high: high / divisor }
}

fn costs(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    html! {
        div.scroll {
            table {
                caption { "Costs: intervals of 95 %; time of a pass as median and range" }
                thead { tr {
                    th scope="col" { "method" } th scope="col" { "cost over the best's" }
                    th scope="col" { "error a pass" } th scope="col" { "time a pass" }
                    th scope="col" { "rays a second" } th scope="col" { "camera rays a pass" }
                    th scope="col" { "bounce rays" } th scope="col" { "shadow rays" }
                    th scope="col" { "peak memory" }
                } }
                tbody { @for method in &scene.methods { tr {
                    th scope="row" { (legend::name(styles, method)) }
                    td { (ratio_cell(method, scene)) }
                    td { (interval(method.error_per_pass)) }
                    td { (seconds_interval(method.seconds_per_pass)) }
                    td { (prefixed(method.rays.per_second)) }
                    td { (prefixed(method.rays.camera)) }
                    td { (prefixed(method.rays.bounce)) }
                    td { (prefixed(method.rays.shadow)) }
                    td { (bytes(method.peak_bytes)) }
                } } }
            }
        }
    }
}

fn metrics(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    html! {
        div.scroll {
            table {
                caption { "Pictures after the longest budget: means over the runs" }
                thead { tr {
                    th scope="col" { "method" } th scope="col" { "relMSE" }
                    th scope="col" { "without the worst 0.1 %" } th scope="col" { "SMAPE" }
                    th scope="col" { "brightness" } th scope="col" { "in standard errors" }
                    th scope="col" { "share of noise in the error" }
                } }
                tbody { @for method in &scene.methods { @let m = method.metrics; tr {
                    th scope="row" { (legend::name(styles, method)) }
                    td { (short(m.rel_mse)) }
                    td { (short(m.trimmed_rel_mse)) }
                    td { (short(m.smape)) }
                    td { (signed(m.bias)) }
                    td { (z(m.bias_z)) }
                    td { (percent(m.noise_share)) }
                } } }
            }
        }
    }
}

fn signed(share: f64) -> String {
    format!("{}{}", if share > 0.0 { "+" } else { "" }, percent(share))
}

/// One digit behind the point: nobody needs more, and zero is zero.
fn z(value: f64) -> String {
    if value.is_finite() { format!("{value:+.1}").replace('-', "−") } else { "–".into() }
}
