//! Spot lights: how much they emit, and where.

use super::*;
use crate::{Light, PointLight};
use traylib_math::{Rgb, Sampler};

/// Angles from the axis in degrees: full up to the first, dark from the second.
const CONES: [[f32; 2]; 8] = [
    [0.0, 30.0],
    [20.0, 25.0],
    [40.0, 40.0],
    [10.0, 80.0],
    [60.0, 170.0],
    [90.0, 180.0],
    [0.0, 180.0],
    [0.5, 1.0],
];

fn cone([full, dark]: [f32; 2]) -> SpotCone {
    let [full, dark] = [full, dark].map(|degrees| degrees.to_radians().cos());
    SpotCone::new(Vec3::new(1.0, -2.0, 0.5), full, dark).unwrap()
}

fn lamp(angles: [f32; 2]) -> Light {
    let intensity = Rgb::new(1.0, 2.0, 3.0);
    Light::Point(PointLight { position: Vec3::ONE, intensity, cone: Some(cone(angles)) })
}

/// The mean of intensity over density of emitted directions is the power.
#[test]
fn power_is_what_is_emitted() {
    const SAMPLES: u32 = 200_000;
    for (i, angles) in CONES.into_iter().enumerate() {
        let light = lamp(angles);
        let mut sampler = Sampler::numbered(2, i as u64);
        let (mut sum, mut squares) = (0.0, 0.0);
        for _ in 0..SAMPLES {
            let emission = light.sample_emission(Vec2::ZERO, sampler.next_2d());
            let falloff = emission.point.falloff(emission.direction);
            if falloff > 0.0 {
                let pdf = emission.point.direction_pdf(emission.direction).0;
                let value = f64::from(falloff * emission.point.emitted.g / pdf);
                sum += value;
                squares += value * value;
            }
        }
        let n = f64::from(SAMPLES);
        let (mean, power) = (sum / n, f64::from(light.power().g));
        let deviation = ((squares / n - mean * mean) / n).max(0.0).sqrt();
        // Five deviations: one in 10⁶ for each cone. A few samples at a sharp rim
        // may round out of the cone, and single precision adds its own.
        let allowed = 5.0 * deviation + 1e-5 * power;
        assert!((mean - power).abs() < allowed, "{angles:?}: {mean} {power} ± {allowed}");
        assert!(allowed < 0.02 * power, "{angles:?}: {allowed} is too wide");
    }
}

/// Against the midpoint rule, whose error is far below single precision.
#[test]
fn solid_angle_is_the_integral_of_the_falloff() {
    const STEPS: u32 = 100_000;
    for angles in CONES {
        let cone = cone(angles);
        let [full, dark] = [cone.cos_full, cone.cos_dark].map(|c| f64::from(c).acos());
        let step = (dark - full) / f64::from(STEPS);
        let soft = |i: u32| {
            let t = 1.0 - (f64::from(i) + 0.5) / f64::from(STEPS);
            t * t * (3.0 - 2.0 * t) * (dark - t * (dark - full)).sin() * step
        };
        let known = TAU * (1.0 - full.cos() + (0..STEPS).map(soft).sum::<f64>());
        let found = f64::from(cone.solid_angle());
        assert!((found - known).abs() < 1e-7 * known, "{angles:?}: {found} {known}");
    }
}

/// Half way between the angles half the light is left.
#[test]
fn falloff_is_a_step_of_the_angle() {
    for angles in CONES {
        let cone = cone(angles);
        let across = cone.axis.any_orthonormal_vector();
        let at = |degrees: f32| {
            let (sin, cos) = degrees.to_radians().sin_cos();
            cone.falloff((cos * cone.axis + sin * across).normalize())
        };
        let [full, dark] = angles;
        let width = dark - full;
        assert_eq!((at(0.9 * full), at(180.0 - 0.9 * (180.0 - dark))), (1.0, 0.0), "{angles:?}");
        if width > 0.0 {
            for (part, known) in [(0.25, 0.15625), (0.5, 0.5), (0.75, 0.84375)] {
                // Directions and cosines round to 10⁻⁷, which is 10⁻⁷/sinθ in the
                // angle; the step is no steeper than 1.5/width.
                let theta = (dark - part * width).to_radians();
                let slack = 1e-6 / (theta.sin() * width.to_radians());
                assert!((at(dark - part * width) - known).abs() < slack, "{angles:?} {part}");
            }
        }
    }
}

/// A lamp whose cone is the sphere is the point light it is without.
#[test]
fn a_full_cone_is_a_point_light() {
    let light = |cone| Light::Point(PointLight { position: Vec3::X, intensity: Rgb::WHITE, cone });
    let full = SpotCone::new(Vec3::Y, -1.0, -1.0).unwrap();
    assert_eq!(light(Some(full)).power(), light(None).power());
    let emission = light(Some(full)).sample_emission(Vec2::ZERO, Vec2::new(0.3, 0.7));
    assert_eq!(emission.point.falloff(emission.direction), 1.0);
    let pdf = emission.point.direction_pdf(emission.direction).0;
    assert!((4.0 * std::f32::consts::PI * pdf - 1.0).abs() < 2.0 * f32::EPSILON, "{pdf}");
}

#[test]
fn cones_that_make_no_sense_are_refused() {
    for (axis, cos_full, cos_dark) in [
        (Vec3::ZERO, 0.9, 0.8),
        (Vec3::NAN, 0.9, 0.8),
        (Vec3::X, 0.8, 0.9),
        (Vec3::X, 1.1, 0.9),
        (Vec3::X, 0.9, -1.1),
        (Vec3::X, f32::NAN, 0.5),
        (Vec3::X, 0.5, f32::NAN),
        (Vec3::X, 1.0, 1.0),
    ] {
        let refused = SpotCone::new(axis, cos_full, cos_dark);
        assert!(matches!(refused, Err(Error::Spot(_))), "{axis} {cos_full} {cos_dark}");
    }
}
