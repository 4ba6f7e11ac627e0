//! Where a ray meets a triangle, without gaps at its edges.
//!
//! Woop, Benthin and Wald, *Watertight Ray/Triangle Intersection*, JCGT 2013. The
//! corners are sheared so that the ray becomes an axis; what is left is a plane
//! figure in which a corner has the same place for all its triangles. Products are
//! rounded before they are subtracted, so the sign of an edge function is right or
//! zero; zeros are computed again without rounding, and then count as inside.
//!
//! Every kernel computes the edge functions by the formulas of this file, operation
//! by operation, and leaves the distance to [`meet`]: so all of them agree to the
//! bit.

use crate::precise::{DVec3, difference};
use crate::shape::ShapeHit;
use crate::{Ray, Vec3};

/// The map that leaves out one coordinate, the one along which the ray is
/// longest, and shifts the others so that the ray's direction becomes zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shear {
    /// The two coordinates that stay, and the one along which depth is measured.
    /// Kernels read at these places unchecked: they are below three.
    pub(crate) axes: [usize; 3],
    /// How fast the ray moves along the two that stay.
    pub(crate) slope: [f32; 2],
    /// From depth to t.
    pub(crate) reciprocal: f32,
}

impl Shear {
    #[inline]
    pub(crate) fn along(direction: &Vec3) -> Self {
        let size = direction.abs();
        let axes = if size.x > size.y && size.x > size.z {
            [1, 2, 0]
        } else if size.y > size.z {
            [2, 0, 1]
        } else {
            [0, 1, 2]
        };
        let [x, y, depth] = pick(direction, axes);
        let reciprocal = 1.0 / depth;
        Self { axes, slope: [x * reciprocal, y * reciprocal], reciprocal }
    }

    /// A triangle as the ray sees it.
    #[inline]
    pub(crate) fn flat(&self, corners: &[Vec3; 3], origin: &Vec3) -> Flat {
        let corners = self.figure(corners, origin);
        let [a, b, c] = corners;
        let cross = |p: [f32; 3], q: [f32; 3]| p[0] * q[1] - p[1] * q[0];
        Flat {
            edges: [cross(b, c), cross(c, a), cross(a, b)],
            depths: corners.map(|corner| corner[2] * self.reciprocal),
        }
    }

    /// The corners in the plane figure in which the ray is the point zero, and how
    /// deep each is.
    #[inline]
    fn figure(&self, corners: &[Vec3; 3], origin: &Vec3) -> [[f32; 3]; 3] {
        let origin = pick(origin, self.axes);
        corners.each_ref().map(|corner| {
            let corner = pick(corner, self.axes);
            let [x, y, depth] = std::array::from_fn(|i| corner[i] - origin[i]);
            [x - self.slope[0] * depth, y - self.slope[1] * depth, depth]
        })
    }

    /// Products of two f32 are exact in f64, so all signs and zeros are right.
    fn exact_edges(&self, corners: &[Vec3; 3], origin: &Vec3) -> Option<[f32; 3]> {
        let [a, b, c] = self.figure(corners, origin).map(|p| p.map(f64::from));
        let cross = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - p[1] * q[0];
        let edges = [cross(b, c), cross(c, a), cross(a, b)];
        let inside = edges.iter().all(|&e| e >= 0.0) || edges.iter().all(|&e| e <= 0.0);
        inside.then(|| edges.map(|e| e as f32))
    }
}

/// Three coordinates in another order.
#[inline]
fn pick(v: &Vec3, axes: [usize; 3]) -> [f32; 3] {
    let v: &[f32; 3] = v.as_ref();
    axes.map(|axis| v[axis])
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

/// Whether edge functions are those of a ray that passes the triangle or its border.
#[inline]
pub(crate) fn is_inside(edges: [f32; 3]) -> bool {
    least(edges) >= 0.0 || greatest(edges) <= 0.0
}

/// A triangle as a ray sees it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flat {
    /// The edge functions: twice the areas between the ray and the edge opposite to
    /// each corner.
    pub(crate) edges: [f32; 3],
    /// t of the points of the ray beside the corners.
    pub(crate) depths: [f32; 3],
}

impl Flat {
    /// Whether the signs of all edge functions are right. Near the line of an edge, far
    /// beyond its ends, products can be rounded to the same number for two edges or
    /// three, so a zero may stand for either sign.
    #[inline]
    pub(crate) fn is_settled(&self) -> bool {
        !self.edges.contains(&0.0)
    }

    /// With edge functions computed without rounding; nothing if the ray passes outside.
    #[cold]
    pub(crate) fn settled(self, corners: &[Vec3; 3], ray: &Ray) -> Option<Self> {
        let edges = Shear::along(&ray.direction).exact_edges(corners, &ray.origin)?;
        Some(Self { edges, ..self })
    }

    /// Whether a point of it can be at 0 < t < `limit`.
    #[inline]
    pub(crate) fn reaches(&self, limit: f32) -> bool {
        greatest(self.depths) > 0.0 && least(self.depths) < limit
    }

    /// `t`, or that of the nearest or farthest corner if it is beyond.
    #[inline]
    fn within(&self, t: f32) -> f32 {
        let (first, last) = (least(self.depths), greatest(self.depths));
        let t = if t < first { first } else { t };
        if t > last { last } else { t }
    }
}

/// Where a ray that passes inside a triangle meets it, with the barycentric
/// coordinates of the second and the third corner.
///
/// The plane gives t most precisely, except to a ray within it; no point of the
/// triangle is nearer or farther than its corners. In double precision, since the
/// normal of a sliver of aspect 10⁵ is off by a percent in single. It counts at
/// 0 < t < `limit`.
#[inline]
pub(crate) fn meet(
    ray: &Ray,
    limit: f32,
    corners: impl Fn() -> [DVec3; 3],
    flat: &Flat,
) -> Option<ShapeHit> {
    let [of_a, of_b, of_c] = flat.edges;
    let sum = of_a + of_b + of_c;
    let [a, b, c] = corners();
    let normal = (b - a).cross(c - a);
    let slope = ray.direction.as_dvec3().dot(normal);
    if sum == 0.0 || sum.is_nan() || slope == 0.0 {
        return None;
    }
    let t = ((a - ray.origin.as_dvec3()).dot(normal) / slope) as f32;
    let t = if is_grazing(normal, sum) { within_box(t, ray, corners) } else { t };
    // Last, since a triangle that begins beyond a hit by these depths is not asked.
    let t = flat.within(t);
    (0.0 < t && t < limit).then(|| ShapeHit { t, u: of_b / sum, v: of_c / sum })
}

/// Whether so little is left of the area when seen along the ray that t may be off by much
/// more than the ray is from an edge.
///
/// `sum`, twice the area in the figure, is the normal times the direction of the ray over
/// the longest coordinate of that.
#[inline]
fn is_grazing(normal: DVec3, sum: f32) -> bool {
    let seen = 16.0 * f64::from(sum).abs();
    seen < normal.x.abs() || seen < normal.y.abs() || seen < normal.z.abs()
}

/// `t`, or where the ray enters or leaves the box around the corners if it is not within
/// it then.
///
/// So boxes that hold the triangle begin before the hit, and rays find it whatever box
/// they are in.
#[cold]
#[inline(never)]
fn within_box(t: f32, ray: &Ray, corners: impl Fn() -> [DVec3; 3]) -> f32 {
    let [a, b, c] = corners();
    let (low, high) = (a.min(b).min(c), a.max(b).max(c));
    let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in (0..3).filter(|&axis| direction[axis] != 0.0) {
        let [low, high] = [low, high].map(|plane| (plane[axis] - origin[axis]) / direction[axis]);
        enter = enter.max(low.min(high));
        leave = leave.min(low.max(high));
    }
    f64::from(t).min(leave).max(enter) as f32
}

/// [`meet`] with t between those beside the corners in the ratio of the areas.
#[inline]
pub(crate) fn meet_coarsely(limit: f32, flat: &Flat) -> Option<ShapeHit> {
    let [of_a, of_b, of_c] = flat.edges;
    let [ta, tb, tc] = flat.depths;
    let reciprocal = 1.0 / (of_a + of_b + of_c);
    let t = flat.within((of_a * ta + of_b * tb + of_c * tc) * reciprocal);
    (0.0 < t && t < limit).then_some(ShapeHit { t, u: of_b * reciprocal, v: of_c * reciprocal })
}

/// The normal of the front, as long as twice the area.
#[inline]
pub(crate) fn normal([a, b, c]: [Vec3; 3]) -> DVec3 {
    difference(b, a).cross(difference(c, a))
}
