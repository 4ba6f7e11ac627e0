//! Error against time.

use crate::chart::{MethodStyles, convergence};
use crate::number::{chosen, seconds_interval};
use crate::page::legend;
use crate::results::{MethodResults, SceneResults, Target};
use maud::{Markup, html};

const CAPTION: &str = "relMSE against seconds of rendering, both logarithmic. A marker at each \
    power of two of passes; the band holds nine runs in ten. Dotted, with small markers: runs \
    averaged, as a longer run would be. Dashed: the method loses some light that others \
    find, however long it renders. Hollow: the reference is too noisy here to tell, or, with a \
    badge, the method does not see all light of the scene. The thin straight line falls as \
    1/time, as noise does, through the last sure point of the best method. Level lines are the \
    errors asked for, with a tick and the time where a method reaches them.";

/// The main chart, with the times to the errors that were asked for below.
pub(crate) fn speed(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    html! {
        h3 { "Error against time" }
        figure.main-chart {
            (legend::legend(scene, styles))
            div.chart { (convergence(scene, styles)) }
            figcaption { (CAPTION) }
        }
        (times(scene, styles))
    }
}

fn times(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    let errors = errors(scene);
    if errors.is_empty() {
        return html! {};
    }
    html! {
        div.scroll {
            table {
                caption { "Time to reach an error, with its 95 % interval" }
                thead { tr {
                    th scope="col" { "method" }
                    @for error in &errors { th scope="col" { "relMSE " (chosen(*error)) } }
                } }
                tbody { @for method in &scene.methods { tr {
                    th scope="row" { (legend::name(styles, method)) }
                    @for &error in &errors { td { (time(method, error)) } }
                } } }
            }
        }
    }
}

/// All errors asked for, largest first.
fn errors(scene: &SceneResults) -> Vec<f64> {
    let all = scene.methods.iter().flat_map(|method| &method.targets);
    let mut errors: Vec<f64> = all.map(|target| target.error).collect();
    errors.sort_by(|a, b| b.total_cmp(a));
    errors.dedup();
    errors
}

fn time(method: &MethodResults, error: f64) -> String {
    match method.targets.iter().find(|target| target.error == error) {
        Some(Target { seconds: Some(seconds), .. }) => seconds_interval(*seconds),
        Some(Target { seconds: None, .. }) => "never".into(),
        None => "–".into(),
    }
}
