//! The intersection of a ray with a triangle, in single precision.
//!
//! The formulas of [`watertight`](crate::watertight), which see for the idea, as kernels
//! compute them for many triangles at once, operation by operation in the same order.

use crate::ShapeHit;
use crate::watertight::{self, pick};
use crate::{Ray, Vec3};

/// The map that leaves out one coordinate, the one along which the ray is
/// longest, and shifts the others so that the ray's direction becomes zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shear {
    /// The two coordinates that stay, and the one along which depth is measured.
    /// Kernels read at these places unchecked: they are below three.
    pub(crate) axes: [usize; 3],
    /// The slope of the ray along the two that stay.
    pub(crate) slope: [f32; 2],
    /// From depth to t.
    pub(crate) reciprocal: f32,
}

impl Shear {
    #[inline]
    pub(crate) fn along(direction: &Vec3) -> Self {
        let axes = watertight::axes(direction);
        let [x, y, depth] = pick(direction, axes);
        let reciprocal = 1.0 / depth;
        Self { axes, slope: [x * reciprocal, y * reciprocal], reciprocal }
    }

    /// A triangle as the ray sees it.
    #[inline]
    pub(crate) fn apply(&self, corners: &[Vec3; 3], ray: &Ray) -> ShearedTriangle {
        let origin = pick(&ray.origin, self.axes);
        let [a, b, c] = corners.each_ref().map(|corner| {
            let corner = pick(corner, self.axes);
            let [x, y, depth] = std::array::from_fn(|i| corner[i] - origin[i]);
            [x - self.slope[0] * depth, y - self.slope[1] * depth, depth * self.reciprocal]
        });
        let cross = |p: [f32; 3], q: [f32; 3]| p[0] * q[1] - p[1] * q[0];
        ShearedTriangle {
            edges: [cross(b, c), cross(c, a), cross(a, b)],
            depths: [a[2], b[2], c[2]],
        }
    }
}

/// The least; if `c` is not a number, that.
#[inline]
fn least([a, b, c]: [f32; 3]) -> f32 {
    let least = if a < b { a } else { b };
    if least < c { least } else { c }
}

/// The greatest; if `c` is not a number, that.
#[inline]
fn greatest([a, b, c]: [f32; 3]) -> f32 {
    let greatest = if a > b { a } else { b };
    if greatest > c { greatest } else { c }
}

/// A triangle as a ray sees it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShearedTriangle {
    /// The edge functions: twice the areas between the ray and the edge opposite to
    /// each corner.
    pub(crate) edges: [f32; 3],
    /// t of the points of the ray beside the corners.
    pub(crate) depths: [f32; 3],
}

impl ShearedTriangle {
    /// Tells whether the ray passes inside or on the border, and a point of the triangle can be at
    /// 0 < t < `limit`.
    #[inline]
    pub(crate) fn may_meet(&self, limit: f32) -> bool {
        (least(self.edges) >= 0.0 || greatest(self.edges) <= 0.0)
            && greatest(self.depths) > 0.0
            && least(self.depths) < limit
    }

    /// Tells whether the signs of all edge functions are right. Near the line of an edge, far
    /// beyond its ends, products can be rounded to the same number for two edges or three, so a
    /// zero may stand for either sign.
    #[inline]
    pub(crate) fn is_settled(&self) -> bool {
        !self.edges.contains(&0.0)
    }

    /// Returns the hit with the triangle, if the ray passes inside, at 0 < t < `limit`: at t
    /// between those beside the corners in the ratio of the areas.
    #[inline]
    pub(crate) fn meet(&self, limit: f32) -> Option<ShapeHit> {
        let [of_a, of_b, of_c] = self.edges;
        let [ta, tb, tc] = self.depths;
        let reciprocal = 1.0 / (of_a + of_b + of_c);
        let t = self.within((of_a * ta + of_b * tb + of_c * tc) * reciprocal);
        (0.0 < t && t < limit).then_some(ShapeHit { t, u: of_b * reciprocal, v: of_c * reciprocal })
    }

    /// `t`, or that of the nearest or farthest corner if it is beyond.
    #[inline]
    pub(crate) fn within(&self, t: f32) -> f32 {
        let (first, last) = (least(self.depths), greatest(self.depths));
        let t = if t < first { first } else { t };
        if t > last { last } else { t }
    }
}
