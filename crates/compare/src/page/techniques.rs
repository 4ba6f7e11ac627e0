//! The section of the page on what each technique of bdpt and each path length bring.

use crate::chart::lengths;
use crate::number::percent;
use crate::page::image::picture;
use crate::pictures::ScenePictures;
use crate::results::{LengthShare, SceneResults};
use maud::{Markup, html};
use traylib_integrators::Technique;
use traylib_math::{Grid, Rgb};

/// The pyramid and the shares by length, as far as they are known.
pub(crate) fn techniques(scene: &SceneResults, pictures: Option<&ScenePictures>) -> Markup {
    let shown = pictures.filter(|pictures| !pictures.techniques.is_empty());
    if shown.is_none() && scene.lengths.is_empty() {
        return html! {};
    }
    html! {
        h3 { "Inside bdpt" }
        @if let Some(pictures) = shown { (pyramids(pictures)) }
        @if !scene.lengths.is_empty() { (shares(scene)) }
    }
}

fn pyramids(pictures: &ScenePictures) -> Markup {
    html! {
        figure {
            (pyramid(pictures, true))
            figcaption {
                "A row for each path length of k = s + t − 1 edges; (s, t) is made of s vertices \
                 from the light and t from the camera. Weighted, so that all of them add up to \
                 the picture; each row brightened by the factor beside it, or longer paths \
                 would be black."
            }
            details {
                summary { "The same unweighted: what each technique finds by itself" }
                (pyramid(pictures, false))
            }
        }
    }
}

fn pyramid(pictures: &ScenePictures, weighted: bool) -> Markup {
    let kind: Vec<_> = pictures.techniques.iter().filter(|(t, _)| t.weighted == weighted).collect();
    html! {
        div.scroll { div.pyramid {
            @for row in kind.chunk_by(|a, b| edges(a.0) == edges(b.0)) {
                (pyramid_row(row, pictures.exposure))
            }
        } }
    }
}

fn pyramid_row(row: &[&(Technique, Grid<Rgb>)], exposure: f32) -> Markup {
    let factor = brightened(row, exposure);
    html! {
        div.row {
            @if let Some((technique, _)) = row.first() {
                span { "k = " (edges(*technique)) @if factor > 1.0 { br; "× " (factor) } }
            }
            @for (technique, grid) in row { (tile(*technique, grid, exposure * factor)) }
        }
    }
}

/// Mean luminance that the brightest picture of a row is brought up to.
const BRIGHT: f32 = 0.2;

/// The power of two, one at least, that makes a row about as bright as that.
fn brightened(row: &[&(Technique, Grid<Rgb>)], exposure: f32) -> f32 {
    let mean = |grid: &Grid<Rgb>| {
        let sum: f32 = grid.values().iter().map(|light| light.luminance()).sum();
        sum / grid.values().len().max(1) as f32
    };
    let brightest = row.iter().map(|(_, grid)| mean(grid)).fold(0.0, f32::max) * exposure;
    // Nothing, or nothing that is a number, stays as it is.
    if brightest > 0.0 { (BRIGHT / brightest).log2().floor().clamp(0.0, 12.0).exp2() } else { 1.0 }
}

fn edges(technique: Technique) -> u32 {
    (u32::from(technique.s) + u32::from(technique.t)).saturating_sub(1)
}

fn tile(technique: Technique, grid: &Grid<Rgb>, exposure: f32) -> Markup {
    let Technique { s, t, by_mirror, .. } = technique;
    let way = if by_mirror { " by way of a mirror" } else { "" };
    html! {
        figure.tile {
            (picture(grid, exposure, &format!("Technique s = {s}, t = {t}{way}"), None))
            figcaption { "(" (s) ", " (t) ")" @if by_mirror { " mirror" } }
        }
    }
}

fn shares(scene: &SceneResults) -> Markup {
    html! {
        p { (sentence(&scene.lengths)) }
        figure { div.chart { (lengths(&scene.name, &scene.lengths)) } }
        div.scroll { table {
            caption { "Shares by path length, and those of all lengths so far" }
            thead { tr {
                th scope="col" { "edges" }
                @for what in ["light", "noise", "rays"] {
                    th scope="col" { (what) } th scope="col" { "so far" }
                }
            } }
            tbody { @for (i, share) in scene.lengths.iter().enumerate() { tr {
                th scope="row" { @if i + 1 == scene.lengths.len() { "≥ " } (share.edges) }
                @for (of, sum) in sums(&scene.lengths[..=i]) {
                    td { (percent(of)) } td { (percent(sum)) }
                }
            } } }
        } }
    }
}

/// Light, noise and rays of the last length, and of all.
fn sums(so_far: &[LengthShare]) -> [(f64, f64); 3] {
    let kinds: [fn(&LengthShare) -> f64; 3] = [|s| s.light, |s| s.variance, |s| s.rays];
    kinds.map(|of| (so_far.last().map_or(0.0, of), so_far.iter().map(of).sum()))
}

/// Less light than this is taken for invisible.
const INVISIBLE: f64 = 0.01;

/// After which length no light to speak of is left.
fn sentence(shares: &[LengthShare]) -> String {
    let left = |i: usize| shares[i + 1..].iter().map(|share| share.light).sum::<f64>();
    let listed = shares.len().saturating_sub(1);
    match (0..listed).find(|&i| left(i) < INVISIBLE) {
        Some(i) => format!(
            "Paths of more than {} bring less than 1 % of the light ({}). The paper holds that \
             beyond 4 to 8 steps nothing visible is added: {}.",
            edges_in_words(shares[i].edges),
            percent(left(i)),
            judged(shares[i].edges),
        ),
        None => format!(
            "Paths of {} and more still bring {} of the light. The paper holds that beyond 4 to \
             8 steps nothing visible is added: {}.",
            shares.last().map_or_else(String::new, |last| edges_in_words(last.edges)),
            percent(shares.last().map_or(0.0, |last| last.light)),
            if shares.last().is_some_and(|last| last.edges > 8) {
                "not so here"
            } else {
                "the lengths looked at do not reach far enough to tell"
            },
        ),
    }
}

fn edges_in_words(edges: u32) -> String {
    format!("{edges} {}", if edges == 1 { "edge" } else { "edges" })
}

fn judged(edges: u32) -> &'static str {
    match edges {
        0..4 => "so it is here, even sooner",
        4..=8 => "so it is here",
        _ => "not so here",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shares(light: &[f64]) -> Vec<LengthShare> {
        let share = |(light, edges): (&f64, u32)| LengthShare {
            edges,
            light: *light,
            variance: 0.1,
            rays: 0.1,
        };
        light.iter().zip(1..).map(share).collect()
    }

    #[test]
    fn dark_rows_are_brightened_by_powers_of_two() {
        let technique = Technique { s: 0, t: 2, by_mirror: false, weighted: true };
        let cases = [(0.5, 1.0), (0.2, 1.0), (0.04, 4.0), (0.0, 1.0), (1e-9, 4096.0)];
        for (light, factor) in cases {
            let picture = (technique, Grid::filled(2, 2, Rgb::splat(light)));
            assert_eq!(brightened(&[&picture], 1.0), factor, "{light}");
        }
    }

    #[test]
    fn the_sentence_names_the_length_and_judges_it() {
        let cases: [(&[f64], &str, &str); 4] = [
            (&[0.9, 0.096, 0.004], "more than 2 edges", "even sooner"),
            (&[0.3, 0.3, 0.2, 0.1, 0.095, 0.005], "more than 5 edges", "so it is here"),
            (&[0.1; 10], "Paths of 10 edges and more still bring 10.0\u{a0}%", "not so here"),
            (&[0.5, 0.5], "still bring 50.0\u{a0}%", "do not reach far enough"),
        ];
        for (light, length, judgement) in cases {
            let text = sentence(&shares(light));
            assert!(text.contains(length) && text.contains(judgement), "{text}");
        }
    }
}
