//! Charts as files of their own, for a paper or a talk.

use crate::chart::alone::{Key, alone, curves, methods};
use crate::chart::{MethodStyles, Quantity, convergence, front, lengths, oracle, pareto};
use crate::page::efficiency;
use crate::results::{Oracle, Results, SceneResults};
use maud::Markup;

/// Every chart by the name of its file, `SCENE-CHART.svg`: a whole SVG document with its
/// legend inside.
pub fn charts(results: &Results) -> Vec<(String, String)> {
    let styles = MethodStyles::of(results);
    let scenes = results.scenes.iter().filter(|scene| !scene.methods.is_empty());
    let mut files: Vec<_> = scenes.flat_map(|scene| of_scene(scene, &styles)).collect();
    files.extend(results.oracle.iter().flat_map(|found| of_oracle(found, &styles)));
    files
}

fn of_scene(scene: &SceneResults, styles: &MethodStyles) -> Vec<(String, String)> {
    let keys = methods(scene, styles);
    let mut charts: Vec<(&str, Markup, &[Key])> = vec![
        ("error", convergence(scene, styles), &keys),
        ("settings", pareto(scene, &front(scene), styles), &keys),
    ];
    // These name what they show beside it.
    if scene.verdict.best.is_some() {
        charts.push(("efficiency", efficiency::whole(scene, styles), &[]));
    }
    if !scene.lengths.is_empty() {
        charts.push(("lengths", lengths(&scene.name, &scene.lengths), &[]));
    }
    named(&scene.name, charts)
}

fn of_oracle(found: &Oracle, styles: &MethodStyles) -> Vec<(String, String)> {
    let keys = curves(&found.curves, styles);
    let chart = |quantity| oracle(found, quantity, styles);
    let charts: Vec<(&str, Markup, &[Key])> = vec![
        ("variance", chart(Quantity::Variance), &keys),
        ("cost", chart(Quantity::Cost), &keys),
    ];
    named("oracle", charts)
}

fn named(of: &str, charts: Vec<(&str, Markup, &[Key])>) -> Vec<(String, String)> {
    let file = |(what, chart, keys): (&str, Markup, &[Key])| {
        Some((format!("{of}-{what}.svg"), alone(&chart, keys)?))
    };
    charts.into_iter().filter_map(file).collect()
}
