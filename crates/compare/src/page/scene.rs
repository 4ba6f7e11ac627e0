//! The part of the page on one scene.

use crate::chart::MethodStyles;
use crate::number::{prefixed, short};
use crate::page::anchor::anchor;
use crate::page::{efficiency, pictures, settings, speed, stability, techniques};
use crate::pictures::ScenePictures;
use crate::results::SceneResults;
use maud::{Markup, html};

/// The section of a scene; `alone` if the verdict above the page is its own.
pub(crate) fn scene(
    index: usize,
    (found, alone): (&SceneResults, bool),
    pictures: Option<&ScenePictures>,
    styles: &MethodStyles,
) -> Markup {
    html! {
        section.scene id=(anchor(index)) {
            h2 { (found.name) }
            p.facts { (facts(found)) }
            @if !alone { p.verdict { (found.verdict.sentence) } }
            @if found.methods.is_empty() {
                p.note { "No run was made: there is nothing to hold a picture against." }
            } @else {
                (compared(index, found, pictures, styles))
            }
        }
    }
}

fn compared(
    index: usize,
    found: &SceneResults,
    pictures: Option<&ScenePictures>,
    styles: &MethodStyles,
) -> Markup {
    html! {
        (speed::speed(found, styles))
        (efficiency::efficiency(found, styles))
        (settings::settings(found, styles))
        (techniques::techniques(found, pictures))
        @if let Some(pictures) = pictures {
            (pictures::pictures(index, found, pictures, styles))
        }
        (stability::stability(found, styles))
    }
}

fn facts(scene: &SceneResults) -> String {
    format!(
        "{} × {} pixels · {} · {} · {} · ε = {}",
        scene.width,
        scene.height,
        counted(scene.primitives, "primitive"),
        counted(scene.area_lights, "area light"),
        counted(scene.point_lights, "point light"),
        short(scene.epsilon),
    )
}

fn counted(count: u64, what: &str) -> String {
    let number = if count < 10_000 { count.to_string() } else { prefixed(count as f64) };
    format!("{number} {what}{}", if count == 1 { "" } else { "s" })
}
