//! Plane polygons into triangles, whatever file they come from.

mod ears;
mod projection;

pub(crate) use projection::{Projection, turn};

use traylib_math::glam::DVec3;

/// Returns twice the area of a loop times its unit normal, after Newell. It points to
/// where the loop goes counter-clockwise.
pub(crate) fn newell(outline: impl Iterator<Item = DVec3> + Clone) -> DVec3 {
    let Some(first) = outline.clone().next() else { return DVec3::ZERO };
    let pairs = outline.clone().zip(outline.skip(1));
    pairs.fold(DVec3::ZERO, |sum, (a, b)| sum + (a - first).cross(b - first))
}

/// Cuts a polygon whose [`newell`] normal this is into triangles that face the same way,
/// as numbers of its corners. Those without area are left out.
///
/// Takes time with the square of the number of corners.
pub(crate) fn cut(outline: impl Iterator<Item = DVec3>, normal: DVec3) -> Vec<[usize; 3]> {
    let projection = Projection::along(normal);
    let points: Vec<_> = outline.map(|point| projection.point(point)).collect();
    ears::cut(&points)
}
