//! A camera for what has none.
//!
//! z is up. Where something is almost all around the middle, the camera stands
//! inside, at the far end of the longest free way from the middle, and looks back
//! across it. Else it stands outside, above one corner, and sees everything.

use super::model::ModelCamera;
use super::thing::Thing;
use std::f32::consts::{PI, TAU};
use traylib_geometry::{Aabb, Bvh, Ray, SidedPrimitive, Vec3};

/// Of all directions from the middle, how many must meet something for it to be
/// inside.
const ENCLOSED: f32 = 0.95;
/// Directions that are tried, evenly over the sphere.
const DIRECTIONS: u32 = 400;
/// Horizontal ways that are tried.
const WAYS: u32 = 16;
/// Height of the middle, of that of the whole.
const EYE_HEIGHT: f32 = 0.55;
/// Part of the free way that is gone.
const NEAR_THE_END: f32 = 0.9;
const FOV_INSIDE: f32 = 70.0;
const FOV_OUTSIDE: f32 = 40.0;

/// The box around things, without what is absurdly far off.
///
/// Real files have a few vertices that belong nowhere, at 10¹¹ in a model of 10.
/// Those are told by being further from the middle than ten times the extent of
/// the middle 99.8 %, axis by axis.
pub(super) fn bounds(things: &[Thing]) -> Aabb {
    let points: Vec<Vec3> = things.iter().flat_map(Thing::extremes).collect();
    let finite = || points.iter().copied().filter(|point| point.is_finite());
    let ranges = [0, 1, 2].map(|axis| sound_range(finite().map(|point| point[axis]).collect()));
    let [lows, highs] = [0, 1].map(|end| Vec3::from(ranges.map(|range| range[end])));
    let sound = Aabb { min: lows, max: highs };
    Aabb::around(finite().filter(|point| sound.contains(*point)))
}

/// Where coordinates make sense.
fn sound_range(mut values: Vec<f32>) -> [f32; 2] {
    let aside = values.len() / 1000;
    let Some(last) = values.len().checked_sub(1 + aside) else { return [0.0; 2] };
    values.sort_unstable_by(f32::total_cmp);
    let (low, high) = (values[aside], values[last]);
    let (middle, extent) = (0.5 * low + 0.5 * high, high - low);
    [middle - 10.0 * extent, middle + 10.0 * extent]
}

/// The camera, for a picture this much wider than high.
pub(super) fn camera(things: &[Thing], bounds: &Aabb, aspect: f32) -> ModelCamera {
    let primitives: Vec<SidedPrimitive> = things.iter().flat_map(Thing::primitives).collect();
    let inside = Bvh::build(primitives).ok().and_then(|shapes| inside(&shapes, bounds));
    inside.unwrap_or_else(|| outside(bounds, aspect))
}

/// A camera among what is all around; `None` if that is not so.
fn inside(shapes: &Bvh<SidedPrimitive>, bounds: &Aabb) -> Option<ModelCamera> {
    let centre = bounds.centre();
    let way = |direction| shapes.nearest(&Ray::new(centre, direction)).map(|hit| hit.t);
    let met = (0..DIRECTIONS).filter(|&index| way(direction(index)).is_some()).count();
    if (met as f32) < ENCLOSED * DIRECTIONS as f32 {
        return None;
    }
    let eye_height = bounds.min.z + EYE_HEIGHT * bounds.extent().z;
    let middle = Vec3::new(centre.x, centre.y, eye_height);
    let free = |direction| shapes.nearest(&Ray::new(middle, direction)).map_or(0.0, |hit| hit.t);
    let ways = (0..WAYS).map(|index| horizontal(TAU * index as f32 / WAYS as f32));
    let (length, direction) =
        ways.map(|direction| (free(direction), direction)).max_by(|a, b| a.0.total_cmp(&b.0))?;
    let position = middle + direction * (NEAR_THE_END * length);
    let is_view = position != middle && position.is_finite();
    is_view.then_some(ModelCamera {
        position,
        target: middle,
        up: Vec3::Z,
        fov_degrees: FOV_INSIDE,
    })
}

/// One of many directions, on a spiral from pole to pole.
fn direction(index: u32) -> Vec3 {
    let z = 1.0 - (2 * index + 1) as f32 / DIRECTIONS as f32;
    let golden_angle = PI * (3.0 - 5.0_f32.sqrt());
    let around = horizontal(golden_angle * index as f32);
    around * (1.0 - z * z).sqrt() + Vec3::Z * z
}

fn horizontal(angle: f32) -> Vec3 {
    Vec3::new(angle.cos(), angle.sin(), 0.0)
}

/// From above the corner of least x and y, so near that everything just fits.
fn outside(bounds: &Aabb, aspect: f32) -> ModelCamera {
    let towards = (Vec3::new(-1.0, -1.5, 0.0).normalize() * 0.866 + Vec3::Z * 0.5).normalize();
    let target = bounds.centre();
    let distance = 1.05 * distance_to_see(bounds, towards, aspect);
    let position = target + towards * if distance > 0.0 { distance } else { 1.0 };
    ModelCamera { position, target, up: Vec3::Z, fov_degrees: FOV_OUTSIDE }
}

/// How far from the middle, in the direction `towards`, all corners are in view.
fn distance_to_see(bounds: &Aabb, towards: Vec3, aspect: f32) -> f32 {
    let right = Vec3::Z.cross(towards).normalize();
    let up = towards.cross(right);
    let wide = (0.5 * FOV_OUTSIDE).to_radians().tan();
    let half = 0.5 * bounds.extent();
    (0..8).fold(0.0, |most: f32, corner| {
        let sign = |bit: u32| if corner >> bit & 1 == 0 { -1.0 } else { 1.0 };
        let corner = half * Vec3::new(sign(0), sign(1), sign(2));
        let sideways = (corner.dot(right).abs() / wide).max(corner.dot(up).abs() * aspect / wide);
        most.max(corner.dot(towards) + sideways)
    })
}

#[cfg(test)]
mod tests;
