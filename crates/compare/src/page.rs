//! The page of a comparison: one HTML file that asks nothing of anybody.
//!
//! Everything on it can be read without its script, which adds the wipe between two
//! pictures and nothing else.

mod anchor;
mod efficiency;
mod files;
mod headline;
mod heat;
mod how;
mod image;
mod legend;
mod oracle;
mod pictures;
mod scene;
mod settings;
mod speed;
mod stability;
mod techniques;

pub use files::charts;

use crate::chart::{MethodStyles, colour};
use crate::pictures::ScenePictures;
use crate::results::Results;
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("page/page.css");
const SCRIPT: &str = include_str!("page/page.js");
/// The browser's own guard: the page loads nothing from outside.
const POLICY: &str =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

/// The page: a whole HTML document with its style, script and pictures inside.
///
/// `pictures` stand in the order of `results.scenes`; a scene without pictures is
/// shown without.
pub fn page(results: &Results, pictures: &[ScenePictures]) -> String {
    let styles = MethodStyles::of(results);
    let alone = results.scenes.len() == 1;
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head { (head(results)) }
            body {
                (headline::headline(results))
                main {
                    @for (i, found) in results.scenes.iter().enumerate() {
                        (scene::scene(i, (found, alone), pictures.get(i), &styles))
                    }
                    @if let Some(found) = &results.oracle { (oracle::oracle(found, &styles)) }
                    (how::how(results))
                }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    page.into_string()
}

fn head(results: &Results) -> Markup {
    let names: Vec<&str> = results.scenes.iter().map(|scene| scene.name.as_str()).collect();
    html! {
        meta charset="utf-8";
        meta http-equiv="Content-Security-Policy" content=(POLICY);
        meta name="viewport" content="width=device-width, initial-scale=1";
        meta name="color-scheme" content="light dark";
        title { "Which method reaches which error in which time: " (names.join(", ")) }
        style { (PreEscaped(colour::style())) (PreEscaped(STYLE)) }
    }
}
