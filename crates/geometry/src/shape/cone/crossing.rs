//! The intersections of a line with a cone.

use super::Cone;
use crate::Ray;
use crate::precise::{DVec3, difference};

/// The part of its axis by which a cone counts as longer at each end: a few roundings of what
/// it meets.
const LONGER: f64 = 2.0 * f32::EPSILON as f64;

/// A point of a line on the cone, which here has no ends.
pub(super) struct Crossing {
    /// The parameter along the ray, in units of its direction's length.
    pub(super) t: f64,
    /// The place along the axis: 0 at the first end, 1 at the second.
    height: f64,
    /// −1 where the ray goes in, 1 where it comes out: the sign of its cosine
    /// with the outward normal.
    pub(super) cosine_sign: f32,
}

impl Crossing {
    /// Tells whether it lies on the part of the cone that is there, which counts as a little
    /// longer, so that light does not pass between it and what closes its ends.
    pub(super) fn is_between_ends(&self) -> bool {
        (-LONGER..=1.0 + LONGER).contains(&self.height)
    }
}

/// Returns the crossings of the line of a ray with the cone, in any order; a crossing that there is
/// not has a `t` that is not a finite number.
///
/// With what lies along the axis removed, the ray's point at t is p + t·q and
/// the cone's radius beside it r + t·g. They agree where
///
/// (q² − g²)·t² + 2(p·q − r·g)·t + (p² − r²) = 0.
///
/// The discriminant is taken as (r·q − g·p)² − (p × q)²: both squares are of the
/// line alone, not of the place where it starts, so nothing cancels that was not
/// close. With the sum in the root that has equal signs the other root follows
/// from the product of both, and a line parallel to the side has one root.
#[inline]
pub(super) fn crossings(cone: &Cone, ray: &Ray) -> Option<[Crossing; 2]> {
    let axis = cone.axis();
    let direction = ray.direction.as_dvec3();
    let square = axis.length_squared();
    let from_end = difference(ray.origin, cone.ends[0]);
    let is_far = from_end.length_squared() > FAR * FAR * square;
    let (ahead, start) = if is_far { nearer(cone, ray, from_end) } else { (0.0, from_end) };
    let per_length = axis * square.recip();
    let (height, climb) = (start.dot(per_length), direction.dot(per_length));
    let (p, q) = (start - height * axis, direction - climb * axis);
    let r = f64::from(cone.radii[0]) + height * cone.widening();
    let g = climb * cone.widening();
    let room = (r * q - g * p).length_squared() - p.cross(q).length_squared();
    // NaN has no root either.
    if room.is_nan() || room < 0.0 {
        return None;
    }
    let half = p.dot(q) - r * g;
    let root = room.sqrt().copysign(half);
    let sum = -(half + root);
    let one = sum / (q.length_squared() - g * g);
    let other = (p.length_squared() - r * r) / sum;
    // The derivative of the left side is ∓2·root there: in, where it falls.
    let out = root.signum() as f32;
    let crossing = |t: f64, cosine_sign| {
        let height = height + t * climb;
        Crossing { t: ahead + t, height, cosine_sign }
    };
    Some([crossing(one, -out), crossing(other, out)])
}

/// From so many lengths of its axis a cone is looked at from nearer.
const FAR: f64 = (1 << 22) as f64;

/// Returns how far along a ray to start instead, and where that is from the first end.
///
/// Far away digits are lost that tell the line from its neighbours. Where it comes
/// nearest they are there again: the way there is rounded to single precision, so that it
/// times the direction is exact, and what then is left of the origin is exact, too, but
/// for the rounding of what is left.
#[cold]
#[inline(never)]
fn nearer(cone: &Cone, ray: &Ray, from_end: DVec3) -> (f64, DVec3) {
    let direction = ray.direction.as_dvec3();
    let nearest = -from_end.dot(direction) / direction.length_squared();
    let ahead = f64::from(nearest as f32);
    if !ahead.is_finite() {
        return (0.0, from_end);
    }
    let there = ray.origin.as_dvec3() + ahead * direction;
    (ahead, there - cone.ends[0].as_dvec3())
}
