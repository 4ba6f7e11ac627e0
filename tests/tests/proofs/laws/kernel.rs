//! The oriented kernel where shading and geometric normal differ:
//! K = f·cos_s(w_l)·cos_g(w_e), whichever end a walk comes from.

use super::sampler;
use glam::DVec3;
use traylib_geometry::{SurfaceSite, Vec3};
use traylib_integrators::toolkit::VertexNumbers;
use traylib_known::frame::frame;
use traylib_known::stage::{lambert, max_phong, phong};
use traylib_materials::SurfaceModel;
use traylib_math::{Rgb, Sampler, warp};
use traylib_scene::{SurfacePoint, Walk};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::laws::verdict::{same_bits, within, worse};

const PAIRS: u64 = 100_000;
/// Tangent of the angle between the normals.
const SLOPES: [f32; 4] = [0.0, 0.3, 1.0, 5.0];

fn models() -> [(&'static str, SurfaceModel); 4] {
    [
        ("Lambert", lambert(0.8)),
        ("Phong, n = 20", phong(0.3, 0.6, 20.0)),
        ("Phong, n = 10⁵", phong(0.0, 1.0, 1e5)),
        ("Max-Phong, n = 1000", max_phong(0.9, 1e3)),
    ]
}

/// A point of the plane z = 0 whose bumps lean this much, toward anywhere.
fn bump(model: SurfaceModel, slope: f32, sampler: &mut Sampler) -> SurfacePoint {
    let (sin, cos) = (std::f32::consts::TAU * sampler.next_1d()).sin_cos();
    let shading_normal = Vec3::new(slope * cos, slope * sin, 1.0).normalize();
    let site = SurfaceSite { position: Vec3::ZERO, error: Vec3::ZERO, normal: Vec3::Z };
    SurfacePoint {
        site,
        normal: Vec3::Z,
        shading_normal,
        model,
        opacity: 1.0,
        through: Rgb::BLACK,
        light: None,
        surface: 0,
    }
}

/// The largest error that `of` finds at many points, for every model and slope;
/// `None` where there is nothing to compare.
fn largest(
    claim: &str,
    bound: f64,
    of: impl Fn(&SurfacePoint, Vec3, &mut Sampler) -> Option<f64>,
) -> Vec<Finding> {
    let cases = models().into_iter().flat_map(|model| SLOPES.map(|slope| (model, slope)));
    let finding = |((name, model), slope): ((&str, SurfaceModel), f32)| {
        let claim = format!("{name}, slope {slope}: {claim}");
        let mut sampler = sampler(&claim);
        let (mut worst, mut compared) = (0.0, 0);
        for _ in 0..PAIRS {
            let point = bump(model, slope, &mut sampler);
            let w = warp::cosine_hemisphere(Vec3::Z, sampler.next_2d());
            if let Some(error) = of(&point, w, &mut sampler) {
                worst = worse(worst, error);
                compared += 1;
            }
        }
        assert!(compared > PAIRS / 50, "{claim}: only {compared}");
        within(claim, worst, bound, compared)
    };
    cases.map(finding).collect()
}

/// |a·b| of unit vectors.
fn cosine(a: Vec3, b: Vec3) -> f64 {
    DVec3::from(a).dot(DVec3::from(b)).abs()
}

/// Walks from either end multiply the same kernel, once the cosine is put back that the density of
/// the arriving edge divides out.
#[test]
fn the_kernel_is_the_same_from_both_ends() {
    let error = |point: &SurfacePoint, to_light: Vec3, sampler: &mut Sampler| {
        let to_eye = warp::cosine_hemisphere(Vec3::Z, sampler.next_2d());
        let f = point.evaluate(to_light, to_eye).f.g;
        let back = point.evaluate(to_eye, to_light).f.g;
        // Neither end sees more sides than the other.
        if (f > 0.0) != (back > 0.0) {
            return Some(f64::INFINITY);
        }
        if to_light.dot(point.shading_normal) <= 0.0 || to_eye.dot(point.shading_normal) <= 0.0 {
            return (f > 0.0).then_some(f64::INFINITY);
        }
        let kernel = cosine(to_light, point.shading_normal) * cosine(to_eye, point.normal);
        let from_light = f64::from(point.cosine(Walk::FromLight, to_light, to_eye))
            * cosine(to_light, point.normal);
        let from_camera = f64::from(point.cosine(Walk::FromCamera, to_eye, to_light))
            * cosine(to_eye, point.normal);
        // Single precision loses digits of a cosine only where it is nearly zero.
        let rounding = 1e-7 / cosine(to_light, point.shading_normal)
            + 1e-7 / cosine(to_eye, point.normal)
            + 1e-7 / cosine(to_light, point.normal);
        let off = |walk: f64| ((walk / kernel - 1.0).abs() - rounding).max(0.0);
        Some(worse(off(from_light), off(from_camera)))
    };
    settle(&largest("one kernel from both ends", 1e-6, error));
}

/// f·cos_s(wi)/pdf from the camera, f·cos_g(wi)·cos_s(wo)/cos_g(wo)/pdf from a
/// light.
#[test]
fn walks_weigh_samples_by_the_kernel() {
    let error = |point: &SurfacePoint, wo: Vec3, sampler: &mut Sampler| {
        let sample = point.sample(wo, VertexNumbers::next(sampler).bsdf)?;
        let scattered = point.evaluate(wo, sample.wi);
        let density = f64::from(scattered.f.g) / f64::from(scattered.pdf.0);
        let of = |walk| f64::from(point.walk_weight(walk, wo, &sample).g);
        let shading = |w| cosine(w, point.shading_normal);
        let geometric = |w| cosine(w, point.normal);
        let from_camera = density * shading(sample.wi);
        let from_light = density * geometric(sample.wi) * shading(wo) / geometric(wo);
        let rounding = [shading(wo), shading(sample.wi), geometric(wo), geometric(sample.wi)]
            .map(|cosine| 2e-7 / cosine)
            .iter()
            .sum::<f64>();
        let off = |found: f64, right: f64| ((found / right - 1.0).abs() - rounding).max(0.0);
        let camera = off(of(Walk::FromCamera), from_camera);
        Some(worse(camera, off(of(Walk::FromLight), from_light)))
    };
    settle(&largest("walk weights", 1e-5, error));
}

/// D7: N_s nearly orthogonal to the eye, and either direction along the plane.
#[test]
fn steep_bumps_give_sound_numbers() {
    let mut sampler = sampler("steep bumps");
    let (mut unsound, mut seen) = (0, 0);
    for i in 0..PAIRS {
        let (_, model) = models()[i as usize % 4];
        let mut point = bump(model, 5.0, &mut sampler);
        let grazing = warp::uniform_sphere(sampler.next_2d()) * Vec3::new(1.0, 1.0, 1e-6);
        let wo = Vec3::new(grazing.x, grazing.y, grazing.z.abs()).normalize();
        if i % 3 == 0 {
            // Just on the near side of a right angle to N_s.
            let [side, _, _] = frame(DVec3::from(wo)).map(DVec3::as_vec3);
            let aside = side.any_orthonormal_vector();
            point.shading_normal = (aside + 1e-6 * side).normalize();
        }
        let Some(sample) = point.sample(wo, VertexNumbers::next(&mut sampler).bsdf) else {
            continue;
        };
        seen += 1;
        let weights =
            [Walk::FromCamera, Walk::FromLight].map(|walk| point.walk_weight(walk, wo, &sample));
        let sound = weights.iter().all(|weight| weight.is_finite() && weight.min_band() >= 0.0);
        unsound += usize::from(!sound);
    }
    settle(&[same_bits("grazing walks on bumps of slope 5: weights are numbers", unsound, seen)]);
}
