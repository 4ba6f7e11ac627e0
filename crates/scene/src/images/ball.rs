//! The image in a ball: small, and near behind its surface.

use super::ImageCone;
use super::light_ball::LightBall;
use super::reflection::Reflection;
use traylib_geometry::Sphere;
use traylib_math::glam::DVec3;
use traylib_math::{Vec2, Vec3};

/// The image's half-angle is computed for its middle: a little more holds the rest.
const AMPLE: f32 = 1.05;

/// A ball that mirrors to its outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BallMirror {
    centre: Vec3,
    radius: f32,
}

impl BallMirror {
    pub(super) fn new(sphere: &Sphere) -> Self {
        Self { centre: sphere.centre(), radius: sphere.radius() }
    }

    pub(super) fn centre(&self) -> Vec3 {
        self.centre
    }

    pub(super) fn radius(&self) -> f32 {
        self.radius
    }

    /// Whether a lamp's light may fall on it.
    pub(super) fn may_show(&self, lamp: &LightBall) -> bool {
        lamp.may_light(self.centre, self.radius)
    }

    /// Tells whether any of the ball is above a surface with this normal.
    #[inline]
    pub(super) fn rises_above(&self, from: Vec3, normal: Vec3) -> bool {
        normal.dot(self.centre - from) > -self.radius
    }

    /// The cone around a lamp's image as `from` sees it, if any of it may show.
    pub(super) fn image(&self, lamp: &LightBall, blur: f32, from: Vec3) -> Option<ImageCone> {
        let normal = self.mirroring_normal(from, lamp.centre)?;
        let seen_at = self.centre + self.radius * normal;
        let (to_eye, to_lamp) = (from - seen_at, lamp.centre - seen_at);
        // On the side of both, up to the lamp's extent, and in the lamp's light.
        if normal.dot(to_eye) <= 0.0
            || normal.dot(to_lamp) <= -lamp.radius
            || !lamp.shines_to(-to_lamp)
        {
            return None;
        }
        let (eye_distance, lamp_distance) = (to_eye.length(), to_lamp.length());
        let cosine = normal.dot(to_eye) / eye_distance;
        // How far the image stands behind the surface, in the plane where that is
        // farther: across the plane of incidence (Coddington's equations).
        let depth = 1.0 / (1.0 / lamp_distance + 2.0 * cosine / self.radius);
        let half_angle =
            AMPLE * (lamp.radius / lamp_distance + blur) * depth / (eye_distance + depth);
        // ½h² is 1 − cos h or a little more.
        Some(ImageCone::around(-to_eye / eye_distance, 0.5 * half_angle * half_angle))
    }

    /// The unit normal where the ball mirrors one point into the other, both outside.
    ///
    /// In the plane of both and the centre, a from the centre at angle 0 and b at φ,
    /// the normal at angle θ has equal angles to both where
    /// ab·sin(2θ−φ) = r·(a·sin θ − b·sin(φ−θ)): three steps of Newton's method. It has other roots,
    /// where one of both is behind the surface: so they start where both see it.
    fn mirroring_normal(&self, one: Vec3, other: Vec3) -> Option<Vec3> {
        let r = self.radius;
        let (to_one, to_other) = (one - self.centre, other - self.centre);
        let (a, b) = (to_one.length(), to_other.length());
        if a <= r || b <= r {
            return None;
        }
        let (x, toward) = (to_one / a, to_other / b);
        let cos_phi = x.dot(toward);
        let side = toward - cos_phi * x;
        let sin_phi = side.length();
        let y = side.try_normalize().unwrap_or_else(|| x.any_orthonormal_vector());
        // The bisector leans to whoever is nearer.
        let (near, far) = (a - r, b - r);
        let guess = Vec2::new(far + near * cos_phi, near * sin_phi).try_normalize()?;
        let mut m = nearest_seen(guess, [a / r, b / r], Vec2::new(cos_phi, sin_phi))?;
        for _ in 0..3 {
            m = newton(m, [a, b], r, [sin_phi, cos_phi])?;
        }
        Some(m.x * x + m.y * y)
    }

    /// Returns how light of a point arrives at another by way of the ball.
    ///
    /// A narrow bundle of rays that has come a metres from the light and is mirrored at the
    /// angle θ spreads as if it came from a and a + 2ab/(r·cosθ) in the plane of incidence, and
    /// from 2ab·cosθ/r farther across it (Coddington's equations): b metres on it is
    /// (a + b + 2ab/(r·cosθ))·(a + b + 2ab·cosθ/r) times as wide as the solid angle that it
    /// fills at the light. It is the same from either end.
    pub(super) fn reflection(&self, from: Vec3, light: Vec3) -> Option<Reflection> {
        let centre = self.centre.as_dvec3();
        let radius = f64::from(self.radius);
        // In units of the radius.
        let [one, other] = [from, light].map(|point| (point.as_dvec3() - centre) / radius);
        let normal = reflecting_normal(one, other)?;
        let [to_one, to_other] = [one - normal, other - normal];
        let [a, b] = [to_one, to_other].map(DVec3::length);
        let cosine = normal.dot(to_one) / a;
        // Both before the surface.
        if cosine.is_nan() || cosine <= 0.0 || normal.dot(to_other) <= 0.0 {
            return None;
        }
        let bend = 2.0 * a * b;
        let area = (a + b + bend / cosine) * (a + b + bend * cosine);
        Some(Reflection { toward: -to_one * radius, spread: 1.0 / (area * radius * radius) })
    }
}

/// The point of the unit ball around the origin that mirrors one point outside into another,
/// to the last bits; `None` where no point does.
///
/// In the plane of both, `one` at the angle 0 from the centre and `other` at φ, those points
/// see the surface that lie nearer than acos(1/A) to the one and acos(1/B) to the other. From
/// one end of them to the other the angle to `one` grows and that to `other` shrinks, so that
/// they are equal once: Newton's method finds where, and halving keeps it there.
fn reflecting_normal(one: DVec3, other: DVec3) -> Option<DVec3> {
    let [a, b] = [one, other].map(DVec3::length);
    if !(a > 1.0 && b > 1.0) {
        return None;
    }
    let x = one / a;
    let cross = one.cross(other);
    let phi = cross.length().atan2(one.dot(other));
    // In line with the centre nothing but the way along the line is left.
    let Some(axis) = cross.try_normalize() else {
        return (one.dot(other) > 0.0).then_some(x);
    };
    let y = axis.cross(x);
    let (mut low, mut high) = ((phi - (1.0 / b).acos()).max(0.0), (1.0 / a).acos().min(phi));
    if low >= high {
        return None;
    }
    // Nearer to whoever is near.
    let mut theta = (phi * (a - 1.0) / (a + b - 2.0)).clamp(low, high);
    for _ in 0..MOST_STEPS {
        // |A|·|B| times the sine of the difference of both angles, and its slope.
        let rest = phi - theta;
        let (twice, turn) = ((theta - rest).sin_cos(), [theta.sin_cos(), rest.sin_cos()]);
        let value = a * b * twice.0 - a * turn[0].0 + b * turn[1].0;
        let slope = 2.0 * a * b * twice.1 - a * turn[0].1 - b * turn[1].1;
        if value > 0.0 {
            high = theta;
        } else {
            low = theta;
        }
        let newton = theta - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        let step = (next - theta).abs();
        theta = next;
        if step <= f64::EPSILON * theta {
            break;
        }
    }
    let (sin, cos) = theta.sin_cos();
    Some(cos * x + sin * y)
}

/// Five or six are usual; halving alone needs 52 for all bits.
const MOST_STEPS: usize = 60;

/// Finds, among the points of a unit circle that are seen from both the distance a in the direction
/// (1, 0) and b in the direction `toward`, the one that is nearest to `guess`; where nothing is,
/// one between what either sees.
fn nearest_seen(guess: Vec2, [a, b]: [f32; 2], toward: Vec2) -> Option<Vec2> {
    // Where tangents touch it: at acos(1/a) from the one, acos(1/b) from the other.
    let touched = |distance: f32| {
        let cos = 1.0 / distance;
        Vec2::new(cos, (1.0 - cos * cos).max(0.0).sqrt())
    };
    let last = touched(a);
    let from_other = touched(b);
    let first = Vec2::new(from_other.x, -from_other.y).rotate(toward);
    if first.perp_dot(last) <= 0.0 {
        return (first + last).try_normalize();
    }
    Some(if guess.perp_dot(last) < 0.0 {
        last
    } else if first.perp_dot(guess) < 0.0 {
        first
    } else {
        guess
    })
}

/// The next guess after the unit vector (cos θ, sin θ).
fn newton(m: Vec2, [a, b]: [f32; 2], r: f32, [sin_phi, cos_phi]: [f32; 2]) -> Option<Vec2> {
    let (cos, sin) = (m.x, m.y);
    let (sin_2, cos_2) = (2.0 * sin * cos, cos * cos - sin * sin);
    // Of 2θ − φ and of φ − θ.
    let twice = [sin_2 * cos_phi - cos_2 * sin_phi, cos_2 * cos_phi + sin_2 * sin_phi];
    let rest = [sin_phi * cos - cos_phi * sin, cos_phi * cos + sin_phi * sin];
    let value = a * b * twice[0] - r * (a * sin - b * rest[0]);
    let slope = 2.0 * a * b * twice[1] - r * (a * cos + b * rest[1]);
    let step = (value / slope).clamp(-0.5, 0.5);
    // A turn by −step, to first order, made a unit vector again.
    Vec2::new(cos + sin * step, sin - cos * step).try_normalize()
}

#[cfg(test)]
mod tests;
