//! Intersections of a line with a shape, by the formulas of a textbook in double precision, and
//! whether they are certain.

use crate::Primitive;
use crate::testing::shape::{Line, crossings, thickness};
use traylib_math::glam::DVec3;

/// The verdict on a line and a shape, as far as it is certain.
#[derive(Clone, Copy, Debug)]
pub(super) enum Verdict {
    /// They meet at t, give or take.
    Hit { t: f64, within: f64 },
    /// They do not.
    Miss,
    /// Rounding may decide.
    Unsure,
}

/// Certain is what all lines have in common around one: as far away as `noise`, and as what
/// double precision may round by, and as a thousandth of the shape's thickness.
pub(super) fn verdict(shape: &Primitive, line: &Line, noise: f64) -> Verdict {
    let bounds = shape.bounds();
    let (size, thickness) = (f64::from(bounds.extent().length()), thickness(shape));
    let (ahead, line) = line.near(bounds.centre().as_dvec3());
    let speed = line.direction.length();
    let distance = ahead.abs() * speed + line.origin.length();
    let f32_filter = noise + 16.0 * f64::EPSILON * distance;
    let aside = f32_filter + 1e-3 * thickness + 16.0 * f64::from(f32::EPSILON) * reach(shape);
    if aside > 0.2 * thickness {
        return Verdict::Unsure;
    }
    let found: Vec<Option<f64>> =
        beams(&line, aside).iter().map(|beam| first(shape, beam, -ahead)).collect();
    let hits: Vec<f64> = found.iter().flatten().copied().collect();
    if hits.is_empty() {
        // A shape that is not behind the line's start may just so be.
        let behind = beams(&line, aside).iter().any(|beam| first(shape, beam, f64::MIN).is_some());
        return if behind { Verdict::Unsure } else { Verdict::Miss };
    }
    let (least, most) = hits.iter().fold((f64::MAX, f64::MIN), |(a, b), t| (a.min(*t), b.max(*t)));
    let spread = most - least;
    let t = ahead + f64::midpoint(least, most);
    let within = spread + 4.0 * f64::from(f32::EPSILON) * t.abs() + 4.0 * f32_filter / speed;
    let lost = hits.len() < found.len();
    if lost || spread * speed > 0.1 * size || t < 4.0 * within {
        return Verdict::Unsure;
    }
    Verdict::Hit { t, within }
}

/// A line and eight around it.
fn beams(line: &Line, aside: f64) -> Vec<Line> {
    let x = line.direction.any_orthogonal_vector().normalize() * aside;
    let y = line.direction.normalize().cross(x);
    let turns = (0..8).map(|i| f64::from(i) * std::f64::consts::FRAC_PI_4);
    let offsets = turns.map(|turn| turn.cos() * x + turn.sin() * y);
    let moved = |offset| Line { origin: line.origin + offset, ..*line };
    [DVec3::ZERO].into_iter().chain(offsets).map(moved).collect()
}

/// The largest coordinate.
fn reach(shape: &Primitive) -> f64 {
    let bounds = shape.bounds();
    f64::from(bounds.min.abs().max(bounds.max.abs()).max_element())
}

/// The first t above `from` at which a line meets a shape.
fn first(shape: &Primitive, line: &Line, from: f64) -> Option<f64> {
    let all = crossings(shape, line);
    all.into_iter().filter(|&(t, is_there)| is_there && t > from).map(|(t, _)| t).reduce(f64::min)
}
