//! Pictures at equal time, where they err, and a wipe between any two.

use crate::chart::MethodStyles;
use crate::number::{seconds, short};
use crate::page::anchor::anchor;
use crate::page::heat::Scale;
use crate::page::image::picture;
use crate::page::legend;
use crate::pictures::ScenePictures;
use crate::results::{MethodResults, OutsidePoint, SceneResults};
use maud::{Markup, html};
use traylib_math::{Grid, Rgb};

/// Names pictures of a scene for the wipe: the reference is the first.
#[derive(Clone, Copy)]
struct Ids(usize);

impl Ids {
    fn of(self, picture: usize) -> String {
        format!("{}-picture-{picture}", anchor(self.0))
    }
}

/// All pictures of a scene.
pub(crate) fn pictures(
    index: usize,
    scene: &SceneResults,
    pictures: &ScenePictures,
    styles: &MethodStyles,
) -> Markup {
    let ids = Ids(index);
    let scale = Scale::of(&pictures.errors);
    let names = names(scene);
    let outside_from = 1 + scene.methods.len();
    html! {
        h3 { "Pictures at equal time" }
        p { "After the longest budget, radiance × " (short(f64::from(pictures.exposure))) "." }
        (wipe(ids, &names))
        div.gallery {
            (reference(&pictures.reference, pictures.exposure, ids))
            @for (i, method) in scene.methods.iter().enumerate() {
                (method_pictures(i, method, pictures, (ids, scale, styles)))
            }
            @for (i, (point, grid)) in scene.outside.iter().zip(&pictures.outside).enumerate() {
                (outside(point, grid, pictures.exposure, ids.of(outside_from + i)))
            }
        }
        @if !pictures.errors.is_empty() {
            figure.scale-box {
                (scale.bar())
                figcaption {
                    "Scale of all error maps above: (x − r)²/(r² + ε) of each pixel, mean of \
                     bands and runs after the longest budget."
                }
            }
        }
    }
}

fn names(scene: &SceneResults) -> Vec<String> {
    let methods = scene.methods.iter().map(MethodResults::marked_name);
    let outside = scene.outside.iter().map(|point| point.name.clone());
    [String::from("reference")].into_iter().chain(methods).chain(outside).collect()
}

fn wipe(ids: Ids, names: &[String]) -> Markup {
    let options = |chosen: usize| {
        html! {
            @for (i, name) in names.iter().enumerate() {
                option value=(ids.of(i)) selected[i == chosen] { (name) }
            }
        }
    };
    html! {
        div.wipe hidden {
            div.choices {
                label { "Left " select.left { (options(0)) } }
                label { "Right " select.right { (options(1.min(names.len() - 1))) } }
            }
            div.stage {}
            input type="range" min="0" max="100" value="50" step="1"
                aria-label="Share of the left picture";
        }
    }
}

fn reference(grid: &Grid<Rgb>, exposure: f32, ids: Ids) -> Markup {
    html! {
        figure {
            (picture(grid, exposure, "The reference", Some(ids.of(0))))
            figcaption { b { "reference" } }
        }
    }
}

fn method_pictures(
    i: usize,
    method: &MethodResults,
    pictures: &ScenePictures,
    (ids, scale, styles): (Ids, Scale, &MethodStyles),
) -> Markup {
    let Some(grid) = pictures.methods.get(i) else { return html! {} };
    let alt = format!("The picture of {}", method.name);
    html! {
        figure {
            (picture(grid, pictures.exposure, &alt, Some(ids.of(1 + i))))
            @if let Some(errors) = pictures.errors.get(i) { (scale.map(errors, &method.name)) }
            figcaption {
                (legend::name(styles, method)) ", relMSE " (short(method.metrics.rel_mse))
            }
        }
    }
}

fn outside(point: &OutsidePoint, grid: &Grid<Rgb>, exposure: f32, id: String) -> Markup {
    html! {
        figure {
            (picture(grid, exposure, &format!("The picture of {}", point.name), Some(id)))
            figcaption { b { (point.name) } ", " (seconds(point.seconds)) ", relMSE " (short(point.error)) }
        }
    }
}
