//! The answer, before anything else.

use crate::page::anchor::anchor;
use crate::results::Results;
use maud::{Markup, html};

/// Title, what stands against the whole, one sentence a scene, and where to go.
pub(crate) fn headline(results: &Results) -> Markup {
    html! {
        header {
            p.kicker { "TrayLib · comparison of light transport methods" }
            h1 { "Which method reaches which error in which time" }
            @if !results.complete {
                p.box.warning role="note" {
                    b { "Interrupted. " }
                    "This comparison was stopped before it was done: methods or scenes may be \
                     missing, and intervals are wider than they would be."
                }
            }
            ol.verdicts {
                @for (i, scene) in results.scenes.iter().enumerate() {
                    li { a href={ "#" (anchor(i)) } { (scene.name) } p { (scene.verdict.sentence) } }
                }
            }
            @if results.scenes.len() > 1 || results.oracle.is_some() { (contents(results)) }
        }
    }
}

fn contents(results: &Results) -> Markup {
    html! {
        nav aria-label="Contents" {
            @for (i, scene) in results.scenes.iter().enumerate() {
                a href={ "#" (anchor(i)) } { (scene.name) }
            }
            @if results.oracle.is_some() { a href="#oracle" { "Against theory" } }
            a href="#how" { "How it was made" }
        }
    }
}
