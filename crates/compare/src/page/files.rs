//! Charts as files of their own, for a paper or a talk.

use crate::chart::alone::{Key, alone, curves, methods};
use crate::chart::{Palette, Quantity, convergence, front, lengths, oracle, pareto};
use crate::page::efficiency;
use crate::results::{Oracle, Results, SceneResults};
use maud::Markup;

/// Every chart by the name of its file, `SCENE-CHART.svg`: a whole SVG document with its
/// legend inside.
pub fn charts(results: &Results) -> Vec<(String, String)> {
    let palette = Palette::of(results);
    let scenes = results.scenes.iter().filter(|scene| !scene.methods.is_empty());
    let mut files: Vec<_> = scenes.flat_map(|scene| of_scene(scene, &palette)).collect();
    files.extend(results.oracle.iter().flat_map(|found| of_oracle(found, &palette)));
    files
}

fn of_scene(scene: &SceneResults, palette: &Palette) -> Vec<(String, String)> {
    let keys = methods(scene, palette);
    let mut charts: Vec<(&str, Markup, &[Key])> = vec![
        ("error", convergence(scene, palette), &keys),
        ("settings", pareto(scene, &front(scene), palette), &keys),
    ];
    // These name what they show beside it.
    if scene.verdict.best.is_some() {
        charts.push(("efficiency", efficiency::whole(scene, palette), &[]));
    }
    if !scene.lengths.is_empty() {
        charts.push(("lengths", lengths(&scene.name, &scene.lengths), &[]));
    }
    named(&scene.name, charts)
}

fn of_oracle(found: &Oracle, palette: &Palette) -> Vec<(String, String)> {
    let keys = curves(&found.curves, palette);
    let chart = |quantity| oracle(found, quantity, palette);
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
