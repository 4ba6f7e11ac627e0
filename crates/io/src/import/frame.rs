//! A camera for what has none.
//!
//! Up is where the light comes from, y or z; both are customary in MGF, and z in
//! 3DS. In a room the camera stands inside, far along the way from the middle that is
//! longest and has room to both sides, and looks back across it. An object it sees as a
//! whole from outside, above one corner.

mod surroundings;

use super::imported_object::ImportedObject;
use super::model_camera::{Fov, ModelCamera};
use std::f32::consts::{PI, TAU};
use surroundings::Tree;
use traylib_geometry::{Aabb, Ray, Vec2, Vec3};
use traylib_math::glam::DVec3;
use traylib_scene::PointLight;

/// Horizontal ways that are tried.
const WAYS: u32 = 16;
/// Height of the middle, of that of the whole.
const EYE_HEIGHT: f32 = 0.55;
/// Part of the free way that is gone.
const NEAR_THE_END: f32 = 0.9;
const FOV_INSIDE: f32 = 70.0;
const FOV_OUTSIDE: f32 = 40.0;

/// The box around all objects, without what is absurdly far off.
///
/// Real files have a few vertices that belong nowhere, at 10¹¹ in a model of 10.
/// Those are told by being further from the middle than ten times the extent of
/// the middle 99.8 %, axis by axis.
pub(super) fn bounds(items: &[ImportedObject]) -> Aabb {
    let points: Vec<Vec3> = items.iter().flat_map(ImportedObject::extremes).collect();
    let finite = || points.iter().copied().filter(|point| point.is_finite());
    let ranges = [0, 1, 2].map(|axis| sound_range(finite().map(|point| point[axis]).collect()));
    let [lows, highs] = [0, 1].map(|end| Vec3::from(ranges.map(|range| range[end])));
    let sound = Aabb { min: lows, max: highs };
    Aabb::around(finite().filter(|point| sound.contains(*point)))
}

/// Returns the range in which coordinates make sense.
fn sound_range(mut values: Vec<f32>) -> [f32; 2] {
    let aside = values.len() / 1000;
    let Some(last) = values.len().checked_sub(1 + aside) else { return [0.0; 2] };
    values.sort_unstable_by(f32::total_cmp);
    let (low, high) = (values[aside], values[last]);
    let (middle, extent) = (0.5 * low + 0.5 * high, high - low);
    [middle - 10.0 * extent, middle + 10.0 * extent]
}

/// Returns the one of y and z that is up: that along which lamps are nearer to the top of the
/// box, and shine more downward. z where that does not tell.
pub(super) fn up(items: &[ImportedObject], bounds: &Aabb) -> Vec3 {
    let (centre, half) = (bounds.centre(), 0.5 * bounds.extent());
    let mut evidence = DVec3::ZERO;
    for lamp in items.iter().filter(|item| !item.emission.is_black()) {
        for primitive in lamp.primitives().map(|sided| sided.primitive) {
            let site = primitive.sample_area(Vec2::splat(0.5));
            let is_round = primitive.normals().half_angle > 0.0;
            let downward = if is_round { Vec3::ZERO } else { -site.normal };
            let sign = (site.position - centre) / half + downward;
            let power = primitive.area() * lamp.emission.luminance();
            evidence += (sign * power).as_dvec3();
        }
    }
    if evidence.y > evidence.z { Vec3::Y } else { Vec3::Z }
}

/// The camera, for a picture this much wider than high.
pub(super) fn camera(
    items: &[ImportedObject],
    lights: &[PointLight],
    bounds: &Aabb,
    up: Vec3,
    aspect: f32,
) -> ModelCamera {
    let shines = surroundings::shines(items, lights);
    let room = shines.then(|| surroundings::tree(items)).flatten();
    let room = room.filter(|tree| surroundings::is_room(tree, items, lights, bounds, up));
    let inside = room.and_then(|tree| inside(&tree, bounds, up));
    inside.unwrap_or_else(|| outside(bounds, up, aspect))
}

/// A camera in a room; `None` if there is no place for one.
fn inside(tree: &Tree, bounds: &Aabb, up: Vec3) -> Option<ModelCamera> {
    let centre = bounds.centre();
    let middle = centre + up * ((EYE_HEIGHT - 0.5) * bounds.extent().dot(up));
    let horizontal = |index: u32| horizontal(TAU * index as f32 / WAYS as f32, up);
    let free = |index: u32| {
        let ray = Ray::new(middle, horizontal(index));
        tree.nearest(&ray).map_or_else(|| way_out(&ray, bounds), |hit| hit.t)
    };
    let ways: Vec<f32> = (0..WAYS).map(free).collect();
    let at = |index: u32| ways[(index % WAYS) as usize];
    let room = |index: &u32| at(*index).min(at(index + 1)).min(at(index + WAYS - 1));
    let best = (0..WAYS).max_by(|a, b| room(a).total_cmp(&room(b)))?;
    let position = middle + horizontal(best) * (NEAR_THE_END * at(best));
    let is_view = position != middle && position.is_finite();
    is_view.then_some(ModelCamera {
        position,
        target: middle,
        up,
        fov: Fov::Horizontal(FOV_INSIDE),
        aspect: None,
        resolution: None,
    })
}

/// Returns the distance along the ray to the sides of the box.
fn way_out(ray: &Ray, bounds: &Aabb) -> f32 {
    let ahead = Vec3::select(ray.direction.cmpgt(Vec3::ZERO), bounds.max, bounds.min);
    // Along a side there is no way out through it.
    let ways = ((ahead - ray.origin) / ray.direction)
        .map(|way| if way >= 0.0 { way } else { f32::INFINITY });
    ways.min_element()
}

/// One of `count` directions, on a spiral from pole to pole.
fn direction(index: u32, count: u32, up: Vec3) -> Vec3 {
    let height = 1.0 - (2 * index + 1) as f32 / count as f32;
    let golden_angle = PI * (3.0 - 5.0_f32.sqrt());
    let around = horizontal(golden_angle * index as f32, up);
    around * (1.0 - height * height).sqrt() + up * height
}

/// Returns the axes x, y and z of a frame in which z is up.
fn upright(up: Vec3) -> [Vec3; 3] {
    if up == Vec3::Y { [Vec3::Z, Vec3::X, Vec3::Y] } else { [Vec3::X, Vec3::Y, Vec3::Z] }
}

fn horizontal(angle: f32, up: Vec3) -> Vec3 {
    let [x, y, _] = upright(up);
    x * angle.cos() + y * angle.sin()
}

/// From 30° above, a little off the corner, so near that everything just fits.
fn outside(bounds: &Aabb, up: Vec3, aspect: f32) -> ModelCamera {
    let [x, y, _] = upright(up);
    let level = (x + 1.5 * y).normalize();
    let towards = (up * 0.5 - level * 0.75_f32.sqrt()).normalize();
    let target = bounds.centre();
    let distance = 1.05 * distance_to_see(bounds, towards, up, aspect);
    let position = target + towards * if distance > 0.0 { distance } else { 1.0 };
    ModelCamera {
        position,
        target,
        up,
        fov: Fov::Horizontal(FOV_OUTSIDE),
        aspect: None,
        resolution: None,
    }
}

/// Returns the distance from the middle, in the direction `towards`, from which all corners are in
/// view.
fn distance_to_see(bounds: &Aabb, towards: Vec3, up: Vec3, aspect: f32) -> f32 {
    let right = up.cross(towards).normalize();
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
