//! Names of methods with their colour and marker.

use crate::chart::MethodStyles;
use crate::chart::marker::{HOLE, corners};
use crate::results::{MethodResults, SceneResults};
use maud::{Markup, html};

/// A method's marker and name; hollow and with its badge if it does not see all light.
pub(crate) fn name(styles: &MethodStyles, method: &MethodResults) -> Markup {
    html! {
        (swatch_and_name(styles, &method.name, method.badge().is_some()))
        @if let Some(badge) = method.badge() { " " span.tag { (badge) } }
    }
}

/// A marker and a name by themselves.
pub(crate) fn plain(styles: &MethodStyles, name: &str) -> Markup {
    swatch_and_name(styles, name, false)
}

fn swatch_and_name(styles: &MethodStyles, name: &str, hollow: bool) -> Markup {
    let style = styles.style(name);
    html! {
        span.method {
            svg.swatch viewBox="-8 -8 16 16" aria-hidden="true" {
                polygon points=(points(style.shape, 5.5)) style={ "fill:var(--m" (style.slot) ")" } {}
                @if hollow {
                    polygon points=(points(style.shape, HOLE * 5.5)) style="fill:var(--paper)" {}
                }
            }
            (name)
        }
    }
}

fn points(shape: usize, radius: f64) -> String {
    let corners = corners(shape, radius);
    let texts: Vec<String> = corners.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect();
    texts.join(" ")
}

/// All methods of a scene, and what is not quite right with some.
pub(crate) fn legend(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    html! {
        ul.legend {
            @for method in &scene.methods {
                li data-method=(styles.style(&method.name).slot) {
                    (name(styles, method))
                }
            }
        }
    }
}
