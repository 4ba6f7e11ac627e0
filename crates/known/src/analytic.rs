//! Direct light with closed forms: one lamp over the floor z = 0, paths of two
//! edges.
//!
//! A lamp of radiance Le that the floor sees in the set Ω of directions gives a
//! diffuse floor of reflectance ρ the radiance ρ/π·∫_Ω Le·cosθ dω = ρ·Le·F, with
//! F the share of the cosine hemisphere that Ω covers: the area of Ω thrown onto
//! the unit sphere and from there straight down onto the unit disk, over π
//! (Nusselt). Lamps are black, so there is no light but the direct one and no
//! limit of length is needed.

use crate::case::{Case, mean_over_floor};
use crate::stage::{
    Stage, ball, black, camera, disk_facing_down, floor, lambert, max_phong, phong, rectangle, spot,
};
use std::f64::consts::PI;
use traylib_geometry::{Primitive, Vec3};
use traylib_materials::SurfaceModel;
use traylib_scene::{Camera, Scene};

const REFLECTANCE: f64 = 0.5;
const RADIANCE: f64 = 3.0;

/// A1: a point light of intensity I = 3 W/sr at distance d = 2, in a direction
/// with cosine 0.8: L = ρ/π·I·cosθ/d².
pub fn point_light() -> Case {
    Case { name: "A1".into(), ..coincident_lights(1) }
}

/// A9: the light of A1 as `count` lights in one place with a share of the
/// intensity each. They give the same radiance, and a sample that draws one of
/// them the same value.
pub fn coincident_lights(count: u16) -> Case {
    let stage = Stage::new(spot(Vec3::new(-1.0, 0.5, 2.0), Vec3::ZERO))
        .surface(floor(), lambert(REFLECTANCE as f32));
    let share = (RADIANCE / f64::from(count)) as f32;
    let place = Vec3::new(1.2, 0.0, 1.6);
    let scene = (0..count).fold(stage, |stage, _| stage.point(place, share)).build();
    let truth = REFLECTANCE / PI * RADIANCE * 0.8 / 4.0;
    Case { name: format!("A9 N = {count}"), scene, max_depth: None, truth }
}

/// A1 in a wide view from straight above: at the distance r from the light,
/// which hangs at the height h = 0.5, cosθ = h/r, so L = ρ/π·I·h/r³. A third of
/// its light ends up in view.
pub fn point_light_wide() -> Case {
    let scene = under_a_point_light().build();
    let truth = mean_over_floor(scene.camera(), |x| {
        let r = f64::from(LIGHT.distance(x));
        REFLECTANCE / PI * RADIANCE * 0.5 / r.powi(3)
    });
    Case { name: "A1 wide".into(), scene, max_depth: None, truth }
}

const LIGHT: Vec3 = Vec3::new(0.3, 0.2, 0.5);

fn under_a_point_light() -> Stage {
    Stage::new(camera(Vec3::new(0.0, 0.0, 2.0), Vec3::ZERO, 90.0, 32))
        .surface(floor(), lambert(REFLECTANCE as f32))
        .point(LIGHT, RADIANCE as f32)
}

/// Adds a sun far below the floor, which gives nothing in view light and has
/// some 10²⁶ times the power.
pub fn outshone() -> Case {
    let sun = ball(-1.5e11 * Vec3::Z, 7e8);
    let Case { truth, .. } = point_light_wide();
    let scene = under_a_point_light().light(sun, 2e7, black()).build();
    Case { name: "A1 outshone".into(), scene, max_depth: None, truth }
}

/// A2: a disk of radius R at the height 1, straight above and facing down. It
/// covers the cone of half-angle t₀, tan t₀ = R, whose shadow on the unit disk
/// has the radius sin t₀: F = sin² t₀ = R²/(1 + R²).
pub fn disk(radius: f64) -> Case {
    let lamp = disk_facing_down(Vec3::Z, radius as f32);
    let factor = radius * radius / (1.0 + radius * radius);
    from_aside(format!("A2 R = {radius}"), &[lamp], factor)
}

/// A3: a ball of radius R = 1 at the distance d = 2 of its centre, in a
/// direction with cosine 0.8, all of it above the floor. It covers a cone of
/// half-angle asin(R/d), a disk of area π(R/d)² across its axis once thrown
/// along it, which tilts by θ: F = (R/d)²·cosθ = 0.2.
pub fn sphere() -> Case {
    let lamp = ball(Vec3::new(1.2, 0.0, 1.6), 1.0);
    from_aside("A3".into(), &[lamp], 0.25 * 0.8)
}

/// A5: a square of half-side a at the height 1, straight above and facing down:
/// four times the [`corner_factor`] of its quarter.
pub fn square(half_side: f64) -> Case {
    let factor = 4.0 * corner_factor(half_side, half_side);
    from_aside(format!("A5 half-side {half_side}"), &[square_lamp(half_side)], factor)
}

/// A5 in a wide view from above, through the lamp's back, which is not there:
/// joining the floor to the camera must ask from the camera's side.
/// The floor's point (x, y) has the lamp's corners at (±a − x, ±a − y): a signed
/// sum of [`corner_factor`], which is odd in both.
pub fn square_wide() -> Case {
    let a = 0.5;
    let camera = camera(Vec3::new(0.1, 0.0, 1.3), Vec3::new(0.1, 0.0, 0.0), 70.0, 32);
    let truth = mean_over_floor(&camera, |point| {
        let (x, y) = (f64::from(point.x), f64::from(point.y));
        let strip = |y| corner_factor(a - x, y) - corner_factor(-a - x, y);
        REFLECTANCE * RADIANCE * (strip(a - y) - strip(-a - y))
    });
    let scene = diffuse_floor(camera, &[square_lamp(a)]);
    Case { name: "A5 wide".into(), scene, max_depth: None, truth }
}

/// F of a rectangle x × y at the height 1, parallel to the floor, one of its
/// corners straight above. Lambert's sum over the edges, each its angle times
/// the sine of its plane's tilt; the edges at the corner above have plumb planes
/// and add nothing:
/// (1/2π)·[x/√(1+x²)·atan(y/√(1+x²)) + y/√(1+y²)·atan(x/√(1+y²))].
pub fn corner_factor(x: f64, y: f64) -> f64 {
    let edge = |at: f64, along: f64| {
        let slant = (1.0 + at * at).sqrt();
        at / slant * (along / slant).atan()
    };
    (edge(x, y) + edge(y, x)) / (2.0 * PI)
}

/// A8: glossy floor under a disk of half-angle t₀, seen straight from above, so
/// that the lobe's axis is the normal and α = θ.
///
/// L/Le = ∫₀^t₀ [kd/π + ks·(n+2)/(2π)·cosⁿθ]·cosθ·2π·sinθ dθ
///      = kd·sin² t₀ + ks·(1 − cos^(n+2) t₀).
pub fn phong_disk(exponent: f64, half_angle: f64) -> Case {
    let (diffuse, specular) = (0.3, 0.6);
    let model = phong(diffuse as f32, specular as f32, exponent as f32);
    let lobe = lobe_part(exponent + 2.0, half_angle);
    let albedo = diffuse * half_angle.sin().powi(2) + specular * lobe;
    from_above(format!("A8 Phong n = {exponent}"), model, half_angle, albedo)
}

/// A8 with metal: max(cosθi, cosθo) is cosθo = 1, which leaves
/// ks·(n+1)/(2π)·cosⁿθ as the BRDF: L/Le = ks·(n+1)/(n+2)·(1 − cos^(n+2) t₀).
pub fn max_phong_disk(exponent: f64, half_angle: f64) -> Case {
    let specular = 0.6;
    let share = (exponent + 1.0) / (exponent + 2.0);
    let albedo = specular * share * lobe_part(exponent + 2.0, half_angle);
    let model = max_phong(specular as f32, exponent as f32);
    from_above(format!("A8 MaxPhong n = {exponent}"), model, half_angle, albedo)
}

/// 1 − cosᵐ t without cancellation.
pub fn lobe_part(power: f64, half_angle: f64) -> f64 {
    let half_sine = (0.5 * half_angle).sin();
    -(power * (-2.0 * half_sine * half_sine).ln_1p()).exp_m1()
}

fn square_lamp(half_side: f64) -> Primitive {
    let a = half_side as f32;
    // y × x points down.
    rectangle(Vec3::new(-a, -a, 1.0), 2.0 * a * Vec3::Y, 2.0 * a * Vec3::X)
}

/// A diffuse floor seen obliquely, from below the height of the lamps.
pub(crate) fn from_aside(name: String, lamps: &[Primitive], factor: f64) -> Case {
    lit_floor(name, spot(Vec3::new(-0.6, 0.2, 0.5), Vec3::ZERO), lamps, factor)
}

/// A diffuse floor that sees these lamps in the share `factor` of its hemisphere.
pub(crate) fn lit_floor(name: String, camera: Camera, lamps: &[Primitive], factor: f64) -> Case {
    let scene = diffuse_floor(camera, lamps);
    Case { name, scene, max_depth: None, truth: REFLECTANCE * RADIANCE * factor }
}

fn diffuse_floor(camera: Camera, lamps: &[Primitive]) -> Scene {
    let stage = Stage::new(camera).surface(floor(), lambert(REFLECTANCE as f32));
    let lit = |stage: Stage, &lamp: &Primitive| stage.light(lamp, RADIANCE as f32, black());
    lamps.iter().fold(stage, lit).build()
}

/// A floor seen straight down from between it and the disk.
fn from_above(name: String, model: SurfaceModel, half_angle: f64, albedo: f64) -> Case {
    let scene = Stage::new(spot(0.5 * Vec3::Z, Vec3::ZERO))
        .surface(floor(), model)
        .light(disk_facing_down(Vec3::Z, half_angle.tan() as f32), RADIANCE as f32, black())
        .build();
    Case { name, scene, max_depth: None, truth: RADIANCE * albedo }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values that two independent ways of computing them agreed on.
    #[test]
    fn closed_forms_have_their_known_values() {
        for (found, known) in [
            (disk(0.1).truth / 1.5, 0.009_900_99),
            (disk(1.0).truth / 1.5, 0.5),
            (corner_factor(1.0, 1.0), 0.138_532),
            (4.0 * corner_factor(1.0, 1.0), 0.554_126),
            (4.0 * corner_factor(0.5, 0.5), 0.239_456),
            (lobe_part(12.0, 0.5), 0.791_332),
            (lobe_part(1002.0, 0.05), 0.714_360),
            (lobe_part(1_000_002.0, 0.002), 0.864_665),
        ] {
            assert!((found - known).abs() < 1e-6, "{found} {known}");
        }
    }

    /// Against the integral of 1/(π r⁴) over the rectangle, by midpoints.
    #[test]
    fn corner_factor_is_the_integral_over_the_rectangle() {
        let (a, b, steps) = (1.3, 0.4, 400);
        let mut sum = 0.0;
        for i in 0..steps * steps {
            let x = a * (f64::from(i % steps) + 0.5) / f64::from(steps);
            let y = b * (f64::from(i / steps) + 0.5) / f64::from(steps);
            sum += 1.0 / (PI * (1.0 + x * x + y * y).powi(2));
        }
        let integral = sum * a * b / f64::from(steps * steps);
        assert!((corner_factor(a, b) - integral).abs() < 1e-6, "{integral}");
        assert_eq!(corner_factor(-a, b), -corner_factor(a, b));
    }
}
