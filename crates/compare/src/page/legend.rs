//! Names of methods with their colour and marker.

use crate::chart::Palette;
use crate::chart::marker::corners;
use crate::results::SceneResults;
use maud::{Markup, html};

/// A method's marker and name.
pub(crate) fn name(palette: &Palette, name: &str) -> Markup {
    let look = palette.look(name);
    html! {
        span.method {
            svg.swatch viewBox="-8 -8 16 16" aria-hidden="true" {
                polygon points=(points(look.shape)) style={ "fill:var(--m" (look.slot) ")" } {}
            }
            (name)
        }
    }
}

fn points(shape: usize) -> String {
    let corners = corners(shape, 5.5);
    let texts: Vec<String> = corners.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect();
    texts.join(" ")
}

/// All methods of a scene, and what is not quite right with some.
pub(crate) fn legend(scene: &SceneResults, palette: &Palette) -> Markup {
    html! {
        ul.legend {
            @for method in &scene.methods {
                li data-method=(palette.look(&method.name).slot) {
                    (name(palette, &method.name))
                    @if !method.blind.is_empty() { " " span.tag { "blind" } }
                    @else if method.biased { " " span.tag { "biased" } }
                }
            }
        }
    }
}
