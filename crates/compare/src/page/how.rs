//! The section of the page on how the comparison was made.

use crate::number::{bytes, chosen, interval_of, percent, seconds, short};
use crate::results::{How, ReferenceResults, Results, SceneResults};
use maud::{Markup, html};

const METHOD: &str = "Each method renders each scene many times with different seeds, rather than \
    once for long: this shows the error and its spread. All runs take the same time, on the same \
    machine with the same threads, after a run to warm up, and the methods take turns, so that \
    whatever else the machine does meets all of them. Seconds are those of rendering: loading, \
    building the tree, film output and the metrics themselves are left out. The error is relMSE, \
    the mean of (x − r)²/(r² + ε) over pixels and bands, and the reference's own noise is taken \
    off it. Where that noise is 5 % of a point or more, the point is hollow: it says less than \
    it seems to. Averages of several runs stand for one longer run; by \
    quasi-random points that would be better still.";

/// The machine, the command and where the references come from.
pub(crate) fn how(results: &Results) -> Markup {
    html! {
        section id="how" {
            h2 { "How it was made" }
            p { (METHOD) }
            pre { code { (results.how.command) } }
            (facts(&results.how))
            @for scene in &results.scenes { (origin(scene)) }
        }
    }
}

fn facts(how: &How) -> Markup {
    let budgets: Vec<String> =
        how.budgets.iter().map(|budget| format!("{} s", chosen(*budget))).collect();
    let last_seed = how.first_seed.saturating_add(u64::from(how.seeds).saturating_sub(1));
    let facts = [
        ("program", how.program.clone()),
        ("commit", how.commit.clone().unwrap_or_else(|| "unknown".into())),
        ("processor", how.processor.clone()),
        ("threads", how.threads.to_string()),
        ("sampler", how.sampler.clone()),
        ("runs of each method", how.seeds.to_string()),
        ("seeds", format!("{} to {last_seed}", how.first_seed)),
        ("budgets", budgets.join(", ")),
        ("all of it took", seconds(how.seconds)),
    ];
    list(&facts)
}

fn list(facts: &[(&str, String)]) -> Markup {
    html! { dl { @for (what, value) in facts { dt { (what) } dd { (value) } } } }
}

fn origin(scene: &SceneResults) -> Markup {
    let reference = &scene.reference;
    html! {
        h3 { (scene.name) }
        p { "The reference is " (reference.origin) "." }
        (list(&[
            ("its own relMSE", short(reference.own_error)),
            ("rendered in", rendered_in(reference)),
            ("ε of relMSE", short(scene.epsilon)),
            ("loading the scene", seconds(scene.load_seconds)),
            ("the scene in memory", bytes(scene.scene_bytes)),
        ]))
        @if let Some(sentence) = agreement(reference) { p { (sentence) } }
    }
}

fn rendered_in(reference: &ReferenceResults) -> String {
    if reference.seconds > 0.0 { seconds(reference.seconds) } else { "not rendered".into() }
}

fn agreement(reference: &ReferenceResults) -> Option<String> {
    let found = reference.agreement.as_ref()?;
    let [first, second] = &found.methods;
    let ratio = match found.mean_ratio {
        Some(ratio) => {
            let ratio = interval_of(ratio, 4);
            format!("the ratio of their means is {ratio} (99.9 % interval)")
        }
        None => "their means have no ratio, since not both have light".into(),
    };
    Some(format!(
        "{first} and {second} agree on it thus: {ratio}; of {} tiles {} differ, at 0.1 % for all \
         together; {} of the pixels are left out because they see a mirror.",
        found.tiles,
        found.refused,
        percent(found.masked)
    ))
}
