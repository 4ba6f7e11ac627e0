//! From the unit square to directions and points, each with its density.
//!
//! Every function is pure: the same `u` gives the same result. Directions are
//! unit vectors.

use crate::{Frame, Vec2, Vec3};
use std::f32::consts::{FRAC_1_PI, TAU};

/// A direction around the unit `normal` with density cosθ/π per steradian.
#[inline]
pub fn cosine_hemisphere(normal: Vec3, u: Vec2) -> Vec3 {
    let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
    let radius = u.x.sqrt();
    let height = (1.0 - u.x).sqrt();
    let local = Vec3::new(radius * cos_phi, radius * sin_phi, height);
    Frame::around(normal).to_world(local)
}

/// Density of [`cosine_hemisphere`] in 1/sr, for the cosine of the angle to the
/// normal; zero below the surface.
#[inline]
pub fn cosine_hemisphere_pdf(cosine: f32) -> f32 {
    cosine.max(0.0) * FRAC_1_PI
}

/// A direction uniform on the sphere: density 1/(4π) per steradian.
pub fn uniform_sphere(u: Vec2) -> Vec3 {
    let z = 1.0 - 2.0 * u.x;
    // 1 − z², written so that it does not cancel near the poles.
    let radius = 2.0 * (u.x * (1.0 - u.x)).sqrt();
    let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
    Vec3::new(radius * cos_phi, radius * sin_phi, z)
}

/// A point uniform on the unit disk.
pub fn uniform_disk(u: Vec2) -> Vec2 {
    let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
    u.x.sqrt() * Vec2::new(cos_phi, sin_phi)
}

/// Barycentric coordinates (of the second and third corner) of a point uniform
/// on a triangle.
pub fn uniform_triangle(u: Vec2) -> Vec2 {
    let root = u.x.sqrt();
    Vec2::new(root * (1.0 - u.y), root * u.y)
}

/// A direction around the unit `axis` with density (n+1)/(2π)·cosⁿα per
/// steradian, α the angle to the axis.
///
/// Cosine and sine are formed from the logarithm, so that exponents up to 10⁶
/// keep all their directions (`1 − cos²` would leave 144 of them).
///
/// Lafortune and Willems, *Using the modified Phong reflectance model for
/// physically based rendering*, 1994.
pub fn cosine_power_lobe(axis: Vec3, exponent: f32, u: Vec2) -> Vec3 {
    let log_cosine = (-u.x).ln_1p() / (exponent + 1.0);
    let cosine = log_cosine.exp();
    let sine = (-(2.0 * log_cosine).exp_m1()).sqrt();
    let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
    let local = Vec3::new(sine * cos_phi, sine * sin_phi, cosine);
    Frame::around(axis).to_world(local).normalize()
}

/// cosⁿα between two unit vectors at distance d from one another, from
/// `half_square` = d²/2, to a relative error of about 10⁻⁷ for any exponent up to
/// 10⁶; zero from a right angle on.
///
/// cosα = 1 − d²/2 exactly, so cosⁿα = exp(n·ln(1 − d²/2)) without the
/// cancellation that `dot` and `powf` suffer.
#[inline]
pub fn cosine_power(half_square: f32, exponent: f32) -> f32 {
    // ln(1 − x) ≤ −x, and beyond 104 the power is zero in single precision.
    if half_square >= 1.0 || exponent * half_square > 104.0 {
        return 0.0;
    }
    (exponent * (-half_square).ln_1p()).exp()
}

/// A direction uniform in the cone around the unit `axis`, up to the angle with
/// `1 − cosθ = one_minus_cos_max`: density 1/(2π·`one_minus_cos_max`).
pub fn uniform_cone(axis: Vec3, one_minus_cos_max: f32, u: Vec2) -> Vec3 {
    let one_minus_cos = u.x * one_minus_cos_max;
    let sine = (one_minus_cos * (2.0 - one_minus_cos)).max(0.0).sqrt();
    let (sin_phi, cos_phi) = (TAU * u.y).sin_cos();
    let local = Vec3::new(sine * cos_phi, sine * sin_phi, 1.0 - one_minus_cos);
    Frame::around(axis).to_world(local).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The centres of `n × n` cells of the unit square.
    fn square(n: usize) -> impl Iterator<Item = Vec2> {
        let centre = move |i: usize| (i as f32 + 0.5) / n as f32;
        (0..n * n).map(move |i| Vec2::new(centre(i % n), centre(i / n)))
    }

    fn mean(n: usize, f: impl Fn(Vec2) -> f32) -> f32 {
        let sum: f64 = square(n).map(|u| f64::from(f(u))).sum();
        (sum / (n * n) as f64) as f32
    }

    #[test]
    fn cosine_hemisphere_has_mean_cosine_two_thirds() {
        let normal = Vec3::new(1.0, -2.0, 0.5).normalize();
        let cosine = mean(64, |u| cosine_hemisphere(normal, u).dot(normal));
        assert!((cosine - 2.0 / 3.0).abs() < 1e-3, "{cosine}");
    }

    #[test]
    fn sphere_has_no_preferred_direction() {
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            assert!(mean(64, |u| uniform_sphere(u).dot(axis)).abs() < 1e-3);
            assert!((mean(64, |u| uniform_sphere(u).dot(axis).powi(2)) - 1.0 / 3.0).abs() < 1e-3);
        }
    }

    #[test]
    fn disk_and_triangle_have_their_moments() {
        assert!((mean(64, |u| uniform_disk(u).length_squared()) - 0.5).abs() < 1e-3);
        assert!((mean(64, |u| uniform_triangle(u).x) - 1.0 / 3.0).abs() < 1e-3);
        assert!((mean(64, |u| uniform_triangle(u).y) - 1.0 / 3.0).abs() < 1e-3);
    }

    /// cosⁿ⁺¹α is uniform on [0, 1] under the lobe's density: its mean is 1/2
    /// and its mean square 1/3, whatever the exponent.
    #[test]
    fn lobe_keeps_its_shape_up_to_a_million() {
        let axis = Vec3::new(-0.3, 0.2, 0.9).normalize();
        for exponent in [0.0, 1.0, 5.0, 20.0, 1e3, 1e5, 1e6] {
            let uniform = |u| {
                let away = cosine_power_lobe(axis, exponent, u) - axis;
                cosine_power(0.5 * away.length_squared(), exponent + 1.0)
            };
            let (first, second) = (mean(64, uniform), mean(64, |u| uniform(u).powi(2)));
            assert!((first - 0.5).abs() < 2e-3, "n = {exponent}: {first}");
            assert!((second - 1.0 / 3.0).abs() < 2e-3, "n = {exponent}: {second}");
        }
    }

    #[test]
    fn cosine_power_agrees_with_double_precision() {
        let axis = Vec3::new(0.6, 0.0, 0.8);
        for u in square(16) {
            let w = cosine_power_lobe(axis, 1e6, u);
            let wide = |v: Vec3| v.to_array().map(f64::from);
            let d: f64 = wide(w).iter().zip(wide(axis)).map(|(a, b)| (a - b).powi(2)).sum();
            let exact = (1e6 * (-0.5 * d).ln_1p()).exp();
            let got = f64::from(cosine_power(0.5 * (w - axis).length_squared(), 1e6));
            assert!((got - exact).abs() <= 1e-5 * exact, "{got} {exact}");
        }
    }

    #[test]
    fn cone_is_filled_evenly_and_not_left() {
        let one_minus_cos_max = 1e-6;
        let axis = Vec3::Y;
        let sine_squared = |u| (uniform_cone(axis, one_minus_cos_max, u) - axis).length_squared();
        let limit = 2.0 * one_minus_cos_max;
        assert!(square(64).all(|u| sine_squared(u) <= limit * 1.001));
        assert!((mean(64, sine_squared) / limit - 0.5).abs() < 1e-2);
    }
}
