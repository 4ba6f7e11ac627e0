//! Closed forms of the scenes in `scenes/failure`: the radiance seen from a place
//! in a direction that meets the floor y = 0.

use std::f64::consts::{FRAC_PI_2, PI};
use traylib_geometry::Vec3;
use traylib_known::analytic::corner_factor;

const FLOOR: f64 = 0.5;
const MIRROR: f64 = 0.9;

/// F1: ρ·Le·[`disk_factor`].
pub fn small_lamp(origin: Vec3, direction: Vec3) -> f64 {
    let [x, z] = floor_point(origin, direction);
    FLOOR * 1e4 * disk_factor(x.hypot(z), 0.01, 1.0)
}

/// F2: a lobe wholly within the lamp. f·cosθ is ks·(n+2)/(2π)·cosⁿα·cosθ; about
/// the mirror direction, at the angle θ₀ from the normal, the mean of cosθ is
/// cosα·cosθ₀, and the integral of (n+2)/(2π)·cosⁿ⁺¹α is one: L = ks·Le·cosθ₀.
pub fn sharp_lobe(_: Vec3, direction: Vec3) -> f64 {
    0.9 * f64::from(-direction.y)
}

/// F4: the mirror at the height 2 shows the lamp, half-side a = 0.1, at the
/// height 3 and facing down: L = ρ·km·Le·F with F a signed sum of
/// [`corner_factor`] in units of that height. The mirror covers all of the image
/// for all of the floor in view, which it meets at a third of the way.
pub fn caustic(origin: Vec3, direction: Vec3) -> f64 {
    let [x, z] = floor_point(origin, direction);
    let edge = |at: f64| [(0.1 - at) / 3.0, (-0.1 - at) / 3.0];
    let ([x1, x0], [z1, z0]) = (edge(x), edge(z));
    let factor = corner_factor(x1, z1) - corner_factor(x1, z0) - corner_factor(x0, z1)
        + corner_factor(x0, z0);
    FLOOR * MIRROR * 100.0 * factor
}

/// F15: as F4 with a point: ρ/π·km·I·h/d³, its image at the height h = 3.
pub fn point_caustic(origin: Vec3, direction: Vec3) -> f64 {
    let [x, z] = floor_point(origin, direction);
    FLOOR / PI * MIRROR * 10.0 * 3.0 / (x * x + z * z + 9.0).powf(1.5)
}

/// F5: F4 seen in the mirror x = 3.2.
pub fn mirrored_caustic(origin: Vec3, direction: Vec3) -> f64 {
    let (origin, direction) = seen_in_mirror(origin, direction);
    MIRROR * caustic(origin, direction)
}

/// F14: F15 seen in the mirror x = 3.2.
pub fn mirrored_point(origin: Vec3, direction: Vec3) -> f64 {
    let (origin, direction) = seen_in_mirror(origin, direction);
    MIRROR * point_caustic(origin, direction)
}

/// F10: ρ·Le·F; the lamp stands on the floor's edge x = 0, of height one, and
/// reaches to z and 1 − z beside the floor's point: twice [`upright_factor`].
pub fn corner(origin: Vec3, direction: Vec3) -> f64 {
    let [x, z] = floor_point(origin, direction);
    FLOOR * (upright_factor(1.0, z, x) + upright_factor(1.0, 1.0 - z, x))
}

/// F13: ρ/π·I·h/d³ with I = 1000 at the height h = 10.
pub fn small_view(origin: Vec3, direction: Vec3) -> f64 {
    let [x, z] = floor_point(origin, direction);
    FLOOR / PI * 1000.0 * 10.0 / (x * x + z * z + 100.0).powf(1.5)
}

/// F of a disk of radius R at the height h, parallel to the floor, its axis at
/// the distance a:
/// ½·[1 − (a² + h² − R²)/√((a² + h² + R²)² − 4a²R²)].
/// Howell, *A catalog of radiation heat transfer configuration factors*.
pub fn disk_factor(a: f64, radius: f64, h: f64) -> f64 {
    let (outside, square) = (a * a + h * h, radius * radius);
    let root = ((outside + square).powi(2) - 4.0 * a * a * square).sqrt();
    // 1 − p/q = (q² − p²)/(q·(q + p)) with q² − p² = 4h²R²: no cancellation
    // where the disk is small.
    2.0 * h * h * square / (root * (root + outside - square))
}

/// F of an upright rectangle a high and b wide that stands on the floor at the
/// distance c, one of its lower corners straight before the point:
/// 1/(2π)·[atan(b/c) − c/√(a² + c²)·atan(b/√(a² + c²))].
pub fn upright_factor(a: f64, b: f64, c: f64) -> f64 {
    let slant = a.hypot(c);
    let foot = if c > 0.0 { (b / c).atan() } else { FRAC_PI_2 };
    (foot - c / slant * (b / slant).atan()) / (2.0 * PI)
}

/// Returns the point at which a ray meets the floor.
fn floor_point(origin: Vec3, direction: Vec3) -> [f64; 2] {
    let along = -f64::from(origin.y) / f64::from(direction.y);
    let at = |from: f32, step: f32| f64::from(from) + along * f64::from(step);
    [at(origin.x, direction.x), at(origin.z, direction.z)]
}

/// The ray as it looks behind the mirror x = 3.2: the place and the direction
/// it would have had without the mirror.
fn seen_in_mirror(origin: Vec3, direction: Vec3) -> (Vec3, Vec3) {
    let flip = Vec3::new(-1.0, 1.0, 1.0);
    (origin * flip + 6.4 * Vec3::X, direction * flip)
}
