//! The point of a ball that mirrors one point into another.

use traylib_math::glam::{DVec2, DVec3};

/// Four or five are usual; halving alone needs 52 for all bits.
const MOST_STEPS: usize = 60;

/// The points of the unit ball around the origin that may mirror one point outside into another.
///
/// They lie in the plane of both and the centre, where a unit vector stands for a point of the
/// circle: `one`, at the distance a, is in the direction (1, 0), and `other`, at the distance b, in
/// the direction (cos φ, sin φ). Those points see the surface that lie nearer than acos(1/a) to the
/// one and acos(1/b) to the other, and what mirrors lies between them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mirroring {
    distances: [f64; 2],
    axes: [DVec3; 2],
    toward_other: DVec2,
    /// The first point that `other` sees and the last that `one` sees, in this order if anything
    /// is seen by both.
    ends: [DVec2; 2],
}

impl Mirroring {
    /// `None` unless both points are outside.
    pub(super) fn between(one: DVec3, other: DVec3) -> Option<Self> {
        let [a, b] = [one, other].map(DVec3::length);
        if !(a > 1.0 && b > 1.0) {
            return None;
        }
        let cosines = [a, b].map(f64::recip);
        let (x, toward) = (one * cosines[0], other * cosines[1]);
        // The vector product, not the cosine, tells small angles.
        let cross = x.cross(toward);
        let sine = cross.length();
        let axis = if sine > 0.0 { cross / sine } else { x.any_orthonormal_vector() };
        let toward_other = DVec2::new(x.dot(toward), sine);
        // Where tangents from either touch the circle, or what mirrors straight back.
        let [touched_by_one, mut touched_by_other] = cosines.map(touched);
        touched_by_other.y = -touched_by_other.y;
        let (first, last) = (touched_by_other.rotate(toward_other), touched_by_one);
        let first = if first.y < 0.0 { DVec2::X } else { first };
        let last = if toward_other.perp_dot(last) > 0.0 { toward_other } else { last };
        Some(Self {
            distances: [a, b],
            axes: [x, axis.cross(x)],
            toward_other,
            ends: [first, last],
        })
    }

    /// The unit normal where the ball mirrors one into the other; `None` where no point does.
    ///
    /// That is where the angles to both are equal,
    /// ab·sin(2θ−φ) = a·sin θ − b·sin(φ−θ): from one end of what both see to the other the angle to
    /// `one` grows and that to `other` shrinks, so that they are equal once. Newton's method finds
    /// where, and halving keeps it there. It ends after a step of less than `settled`, in radians,
    /// which leaves an error of some of its square.
    pub(super) fn normal(&self, settled: f64) -> Option<DVec3> {
        let [mut low, mut high] = self.ends;
        if low.perp_dot(high) < 0.0 {
            return None;
        }
        let mut at = self.guess();
        for _ in 0..MOST_STEPS {
            let [value, slope] = self.difference(at);
            if value > 0.0 {
                high = at;
            } else {
                low = at;
            }
            // A turn by −step, to first order.
            let step = value / slope;
            let next = (at - step * at.perp()).normalize();
            if low.perp_dot(next) >= 0.0 && next.perp_dot(high) >= 0.0 {
                at = next;
                if step.abs() < settled {
                    break;
                }
            } else {
                at = (low + high).normalize();
            }
        }
        Some(self.out_of_plane(at))
    }

    /// A unit normal near what both points see, where they see nothing in common.
    pub(super) fn between_ends(&self) -> DVec3 {
        let [one, other] = self.ends;
        self.out_of_plane((one + other).normalize())
    }

    /// A point that both see, nearer to whoever is nearer.
    fn guess(&self) -> DVec2 {
        let [near, far] = self.distances.map(|distance| distance - 1.0);
        let guess = (far * DVec2::X + near * self.toward_other).normalize_or(DVec2::X);
        let [first, last] = self.ends;
        if guess.perp_dot(last) < 0.0 {
            last
        } else if first.perp_dot(guess) < 0.0 {
            first
        } else {
            guess
        }
    }

    /// |A|·|B| times the sine of the difference of both angles at (cos θ, sin θ), and its slope,
    /// for the ways A and B to both points.
    fn difference(&self, at: DVec2) -> [f64; 2] {
        let [a, b] = self.distances;
        // (cos, sin) of φ − θ, and of 2θ − φ.
        let DVec2 { x: cos, y: sin } = at;
        let rest = DVec2::new(cos, -sin).rotate(self.toward_other);
        let twice = at.rotate(DVec2::new(rest.x, -rest.y));
        let value = a * b * twice.y - a * sin + b * rest.y;
        let slope = 2.0 * a * b * twice.x - a * cos - b * rest.x;
        [value, slope]
    }

    fn out_of_plane(&self, at: DVec2) -> DVec3 {
        let [x, y] = self.axes;
        at.x * x + at.y * y
    }
}

/// Returns the point at which a tangent from a point in the direction (1, 0) touches the unit
/// circle, above it: at an angle that has the inverse of the point's distance as its cosine.
fn touched(cos: f64) -> DVec2 {
    DVec2::new(cos, (1.0 - cos * cos).sqrt())
}
