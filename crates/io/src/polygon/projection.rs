//! Polygons projected along an axis of coordinates.

use traylib_math::glam::{DVec2, DVec3};

/// The two axes that keep most of a plane, ordered so that what is
/// counter-clockwise seen from its front stays so.
#[derive(Clone, Copy)]
pub(crate) struct Projection {
    u: usize,
    v: usize,
}

impl Projection {
    /// Leaves out the axis nearest to the normal. Coordinates stay as they are,
    /// so what coincides still does.
    pub(crate) fn along(normal: DVec3) -> Self {
        let axis = normal.abs().max_position();
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        if normal[axis] < 0.0 { Self { u: v, v: u } } else { Self { u, v } }
    }

    pub(crate) fn point(self, point: DVec3) -> DVec2 {
        DVec2::new(point[self.u], point[self.v])
    }
}

/// Returns twice the area of a triangle, positive counter-clockwise.
pub(crate) fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}
