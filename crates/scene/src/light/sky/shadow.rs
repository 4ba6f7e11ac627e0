//! The shadow of the scene's box, over which light of one direction enters.

use traylib_geometry::{Aabb, Vec3};
use traylib_math::Vec2;

/// So much of its diagonal the box is larger on all sides than what it holds: no surface is
/// where a ray starts.
const MARGIN: f32 = 1.0 / 1024.0;

/// The shadow that a box around the scene throws, from any direction.
///
/// Seen from afar three sides of a box cover one another nowhere and all of it together. A
/// point of them, each in proportion to how large it looks, is uniform across the direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct BoxShadow {
    bounds: Aabb,
    /// Areas of the sides across x, y and z.
    sides: Vec3,
}

impl BoxShadow {
    pub(super) fn of(bounds: &Aabb) -> Self {
        // Of a scene without any surface it does not matter.
        let bounds =
            if bounds.is_empty() { Aabb::around([Vec3::ZERO, Vec3::ONE]) } else { *bounds };
        let margin = MARGIN * bounds.extent().length();
        let bounds = bounds.grown(Vec3::splat(margin.max(f32::MIN_POSITIVE)));
        let Vec3 { x, y, z } = bounds.extent();
        Self { bounds, sides: Vec3::new(y * z, z * x, x * y) }
    }

    /// The area of the shadow across a unit direction.
    pub(super) fn area(&self, direction: Vec3) -> f32 {
        self.sides.dot(direction.abs())
    }

    /// The mean of that over all directions: a quarter of the surface, as of all convex bodies.
    pub(super) fn mean_area(&self) -> f32 {
        0.5 * self.sides.element_sum()
    }

    /// A point of the box's surface that the light `toward` this unit direction reaches first,
    /// uniform across it; `u` is uniform on the unit square.
    pub(super) fn sample(&self, toward: Vec3, u: Vec2) -> Vec3 {
        let looks = self.sides * toward.abs();
        // One number for the side and the first coordinate on it.
        let mut rest = u.x * looks.element_sum();
        let mut side = 0;
        while side < 2 && rest >= looks[side] {
            rest -= looks[side];
            side += 1;
        }
        let first = if looks[side] > 0.0 { (rest / looks[side]).min(1.0) } else { 0.0 };
        let mut part = Vec3::ZERO;
        part[side] = if toward[side] > 0.0 { 1.0 } else { 0.0 };
        part[(side + 1) % 3] = first;
        part[(side + 2) % 3] = u.y;
        self.bounds.min + part * self.bounds.extent()
    }
}
