//! Parallelograms.

use super::{ShapeHit, Sides, all_finite, sound_area};
use crate::precise::{DVec3, difference, unit};
use crate::{Aabb, Error, Ray, SurfaceSite, Vec2, Vec3};

/// A parallelogram: `corner + u · edge_u + v · edge_v` with u, v in [0, 1]. The
/// front normal is along `edge_u × edge_v`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    corner: Vec3,
    /// Unit normal of the front, rounded.
    normal: Vec3,
    edge_u: Vec3,
    edge_v: Vec3,
    /// `edge_u` × `edge_v`.
    across: DVec3,
    /// The lengths of the edges if they are at right angles.
    lengths: Option<[f64; 2]>,
    /// The part of its edges by which it counts as larger than it is; see [`margin`].
    margin: Vec2,
    area: f32,
}

impl Quad {
    /// The parallelogram at `corner` with these edges.
    ///
    /// # Errors
    /// [`Error::NotFinite`], or [`Error::NoArea`] when the edges are parallel.
    pub fn new(corner: Vec3, edge_u: Vec3, edge_v: Vec3) -> Result<Self, Error> {
        let opposite = corner + edge_u + edge_v;
        all_finite(&[corner, edge_u, edge_v, opposite])?;
        let (u, v) = (edge_u.as_dvec3(), edge_v.as_dvec3());
        let across = u.cross(v);
        let area = sound_area(across.length())?;
        let normal = unit(across).ok_or(Error::NoArea)?;
        let reach = corner.abs().max(opposite.abs()).max_element();
        let margin = Vec2::new(margin(reach, edge_u), margin(reach, edge_v));
        let lengths = is_square(u, v).then(|| [u.length(), v.length()]);
        Ok(Self { corner, normal, edge_u, edge_v, across, lengths, margin, area })
    }

    /// The corner where u and v are zero.
    pub fn corner(&self) -> Vec3 {
        self.corner
    }

    /// The two edges that leave the corner: the derivatives of a point of the
    /// surface with respect to its u and v, in metres.
    pub fn edges(&self) -> [Vec3; 2] {
        [self.edge_u, self.edge_v]
    }

    /// Unit normal of the front.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// A box around it.
    pub fn bounds(&self) -> Aabb {
        let (a, b) = (self.corner, self.corner + self.edge_u);
        let corners = Aabb::around([a, b, a + self.edge_v, b + self.edge_v]);
        // Corners are rounded sums.
        corners.grown(corners.min.abs().max(corners.max.abs()) * f32::EPSILON)
    }

    /// The cross product of its edges.
    pub(crate) fn across(&self) -> DVec3 {
        self.across
    }

    /// The lengths of the edges of a rectangle; `None` of another parallelogram.
    pub(crate) fn rectangle_lengths(&self) -> Option<[f64; 2]> {
        self.lengths
    }

    /// Returns the part of each edge by which it counts as longer at either end.
    pub(crate) fn margin(&self) -> Vec2 {
        self.margin
    }

    /// Area in square metres.
    pub fn area(&self) -> f32 {
        self.area
    }

    /// Returns the hit of a ray with it, with the coordinates along its edges.
    ///
    /// Cramer's rule in double precision for o + t·d = c + u·e_u + v·e_v: as Möller and
    /// Trumbore, *Fast, Minimum Storage Ray/Triangle Intersection*, 1997, but t first,
    /// which rules most parallelograms out.
    #[inline]
    pub fn intersect(&self, ray: &Ray, sides: Sides) -> Option<ShapeHit> {
        let direction = ray.direction.as_dvec3();
        let from_corner = difference(ray.origin, self.corner);
        let slope = direction.dot(self.across);
        let reciprocal = -slope.recip();
        let t = (from_corner.dot(self.across) * reciprocal) as f32;
        if !(ray.contains(t) && sides.admit(slope as f32)) {
            return None;
        }
        let moment = direction.cross(from_corner) * reciprocal;
        let u = -moment.dot(self.edge_v.as_dvec3()) as f32;
        let v = moment.dot(self.edge_u.as_dvec3()) as f32;
        let is_within = |x: f32, margin: f32| -margin <= x && x <= 1.0 + margin;
        let inside = is_within(u, self.margin.x) && is_within(v, self.margin.y);
        inside.then(|| ShapeHit { t, u: u.clamp(0.0, 1.0), v: v.clamp(0.0, 1.0) })
    }

    /// The site at coordinates `u`, `v`.
    pub(crate) fn site(&self, u: f32, v: f32) -> SurfaceSite {
        let position = self.corner + (u * self.edge_u + v * self.edge_v);
        SurfaceSite::flat(position, self.normal, self.edge_u.abs() + self.edge_v.abs())
    }

    pub(crate) fn sample_area(&self, u: Vec2) -> SurfaceSite {
        self.site(u.x, u.y)
    }
}

/// Tells whether two edges are at right angles, up to a few roundings of their coordinates.
fn is_square(along: DVec3, aside: DVec3) -> bool {
    const SLANT: f64 = 4.0 * f32::EPSILON as f64;
    let lengths = along.length_squared() * aside.length_squared();
    along.dot(aside).powi(2) <= SLANT * SLANT * lengths
}

/// Computes by which part of itself an edge counts as longer at each end, so that light does not
/// pass between shapes that meet.
///
/// Corners round, of which some are decimal numbers and some sums: of two neighbours
/// each is off by half a unit in the last place of the largest coordinate, and reaches
/// over its end by as much, and by a rounding of its own length. Of a short edge far
/// from the origin that is much; no more than 2⁻¹⁶ is added, or lamps would be met
/// where no point of them is drawn.
fn margin(largest_coordinate: f32, edge: Vec3) -> f32 {
    let length = edge.abs().max_element();
    (0.5 * f32::EPSILON * (2.0 + largest_coordinate / length)).min(1.0 / (1 << 16) as f32)
}
