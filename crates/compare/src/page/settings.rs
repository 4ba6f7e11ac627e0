//! Which settings are worth using.

use crate::chart::{Palette, front, pareto};
use crate::page::legend;
use crate::results::SceneResults;
use maud::{Markup, html};

/// All settings, and the staircase of those that nothing beats.
pub(crate) fn settings(scene: &SceneResults, palette: &Palette) -> Markup {
    let front = front(scene);
    html! {
        h3 { "Settings worth using" }
        figure {
            div.chart { (pareto(scene, &front, palette)) }
            figcaption {
                "Every method after every time, averaged runs included. Grey: something else is \
                 both faster and more exact. Unbeaten, from the fastest: "
                @for (i, name) in front.names().iter().enumerate() {
                    @if i > 0 { ", " }
                    (legend::name(palette, name))
                }
                @if front.names().is_empty() { "none" }
                "."
                @for name in front.names().into_iter().filter(|name| alarmed(scene, name)) {
                    " The values of " (name) " seem to have no variance: its points may be luck."
                }
            }
        }
    }
}

fn alarmed(scene: &SceneResults, name: &str) -> bool {
    scene.methods.iter().any(|method| method.name == name && method.stability.alarm)
}
