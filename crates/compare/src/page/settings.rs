//! The section on settings that are worth using.

use crate::chart::{MethodStyles, front, pareto};
use crate::page::legend;
use crate::results::{MethodResults, SceneResults};
use maud::{Markup, html};

/// All settings, and the staircase of those that nothing beats.
pub(crate) fn settings(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    let front = front(scene);
    html! {
        h3 { "Settings worth using" }
        figure {
            div.chart { (pareto(scene, &front, styles)) }
            figcaption {
                "Every method after every time, averaged runs included. Grey: something else is \
                 both faster and more exact. Hollow: the reference is too noisy here, or the method \
                 does not see all light of the scene. Unbeaten, from the fastest: "
                @for (i, method) in unbeaten(scene, &front.names()).into_iter().enumerate() {
                    @if i > 0 { ", " }
                    (legend::name(styles, method))
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

fn unbeaten<'a>(scene: &'a SceneResults, names: &[&str]) -> Vec<&'a MethodResults> {
    let named = |name: &&str| scene.methods.iter().find(|method| method.name == **name);
    names.iter().filter_map(named).collect()
}

fn alarmed(scene: &SceneResults, name: &str) -> bool {
    scene.methods.iter().any(|method| method.name == name && method.stability.alarm)
}
