//! The main chart: error against time.

use crate::chart::axis::{Decades, drawable, visible};
use crate::chart::canvas::{BREADTH, Failed, breadth, svg, text};
use crate::chart::colour::{INK, MUTED};
use crate::chart::crossings::{crossings, write};
use crate::chart::marker::DIAMOND;
use crate::chart::plot::{Plot, Stroke};
use crate::chart::styles::{MethodStyles, Style};
use crate::results::{MethodResults, OutsidePoint, Point, SceneResults};
use maud::Markup;
use plotters::style::text_anchor::{HPos, VPos};

const SIZE: (u32, u32) = (BREADTH, 860);
const BIG: f64 = 9.0;
const SMALL: f64 = 6.0;
/// From a marker's middle to its name.
const BESIDE: i32 = 18;

/// Error against seconds, a line each method.
pub(crate) fn convergence(scene: &SceneResults, styles: &MethodStyles) -> Markup {
    let label =
        format!("Error against time on {}, both logarithmic, a line each method", scene.name);
    svg(&label, SIZE, |area| {
        let (x, y) = axes(scene);
        let targets = targets_within(scene, &y);
        let plot = Plot::new(area, (x.clone(), "seconds"), (y, "relMSE"))?;
        let times = crossings(&plot, scene, styles, &targets, &x)?;
        guide(&plot, scene, &x)?;
        for method in &scene.methods {
            band(&plot, method, styles.style(&method.name))?;
        }
        for method in &scene.methods {
            lines(&plot, method, styles.style(&method.name))?;
        }
        outside(&plot, scene)?;
        // Text comes last, with paper around it: a marker would hide a digit.
        for method in &scene.methods {
            badge(&plot, method, styles.style(&method.name))?;
        }
        write(&plot, &times)?;
        outside_names(&plot, scene)
    })
}

fn axes(scene: &SceneResults) -> (Decades, Decades) {
    let drawn = || scene.methods.iter().flat_map(|m| own(m).chain(averaged(m)));
    let outside = || drawn_outside(scene);
    let seconds = drawn().map(|p| p.seconds).chain(outside().map(|o| o.seconds));
    let errors = drawn().flat_map(|p| [p.error.value, p.high]).chain(outside().map(|o| o.error));
    (Decades::around(seconds), Decades::around(errors))
}

/// Errors that somebody asked for and that the chart shows, largest first.
fn targets_within(scene: &SceneResults, y: &Decades) -> Vec<f64> {
    let all = scene.methods.iter().flat_map(|m| &m.targets).map(|target| target.error);
    let mut shown: Vec<f64> = all.filter(|&error| y.holds(error)).collect();
    shown.sort_by(|a, b| b.total_cmp(a));
    shown.dedup();
    shown
}

fn own(method: &MethodResults) -> impl Iterator<Item = &Point> {
    method.points.iter().filter(|point| visible(point))
}

fn averaged(method: &MethodResults) -> impl Iterator<Item = &Point> {
    method.budgets.iter().filter(|point| point.averaged > 1).filter(|point| visible(point))
}

fn xy(point: &Point) -> (f64, f64) {
    (point.seconds, point.error.value)
}

fn band(plot: &Plot<'_, '_>, method: &MethodResults, style: Style) -> Result<(), Failed> {
    let edge = |of: fn(&Point) -> f64| -> Vec<(f64, f64)> {
        own(method).map(|point| (point.seconds, of(point))).collect()
    };
    plot.band(&edge(|point| point.low), &edge(|point| point.high), style.colour())
}

fn lines(plot: &Plot<'_, '_>, method: &MethodResults, style: Style) -> Result<(), Failed> {
    let main: Vec<_> = own(method).map(xy).collect();
    let longer: Vec<_> = main.last().copied().into_iter().chain(averaged(method).map(xy)).collect();
    let all_seen = method.badge().is_none();
    let stroke = if method.biased { Stroke::Dashed(14) } else { Stroke::Solid };
    plot.line(&main, style.colour(), 4, stroke)?;
    plot.line(&longer, style.colour(), 3, Stroke::Dashed(4))?;
    for point in own(method) {
        plot.marker(xy(point), style.mark(), BIG, point.solid && all_seen)?;
    }
    for point in averaged(method) {
        plot.marker(xy(point), style.mark(), SMALL, point.solid && all_seen)?;
    }
    Ok(())
}

/// The method's badge, over the last point of its own.
fn badge(plot: &Plot<'_, '_>, method: &MethodResults, style: Style) -> Result<(), Failed> {
    let Some((badge, last)) = method.badge().zip(own(method).last()) else { return Ok(()) };
    let (x, y) = plot.place(xy(last));
    let at = (x, y - BESIDE);
    text(plot.area(), badge, at, (HPos::Center, VPos::Bottom), style.colour())
}

/// Error ∝ 1/time, through the last solid point of the best method.
fn guide(plot: &Plot<'_, '_>, scene: &SceneResults, x: &Decades) -> Result<(), Failed> {
    let best = scene.methods.iter().find(|m| Some(&m.name) == scene.verdict.best.as_ref());
    let Some((seconds, error)) = best.and_then(|m| own(m).filter(|p| p.solid).last()).map(xy)
    else {
        return Ok(());
    };
    let (low, high) = plot.y_ends();
    let ends = x.ends();
    // No further than the chart, or clamping would bend the line.
    let from = ends.0.max(error * seconds / high);
    let to = ends.1.min(error * seconds / low);
    let along = [from, to].map(|t| (t, error * seconds / t));
    plot.line(&along, MUTED, 2, Stroke::Solid)
}

/// Pictures of other programs that have a place.
fn drawn_outside(scene: &SceneResults) -> impl Iterator<Item = &OutsidePoint> {
    scene.outside.iter().filter(|o| drawable(o.error) && drawable(o.seconds))
}

fn outside(plot: &Plot<'_, '_>, scene: &SceneResults) -> Result<(), Failed> {
    drawn_outside(scene).try_for_each(|OutsidePoint { seconds, error, solid, .. }| {
        plot.marker((*seconds, *error), (DIAMOND, INK), BIG + 2.0, *solid)
    })
}

fn outside_names(plot: &Plot<'_, '_>, scene: &SceneResults) -> Result<(), Failed> {
    drawn_outside(scene).try_for_each(|OutsidePoint { name, seconds, error, .. }| {
        let (x, y) = plot.place((*seconds, *error));
        let at_right = x + BESIDE + breadth(name) < plot.right_end();
        let (x, h) = if at_right { (x + BESIDE, HPos::Left) } else { (x - BESIDE, HPos::Right) };
        text(plot.area(), name, (x, y), (h, VPos::Center), INK)
    })
}
