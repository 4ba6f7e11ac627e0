//! Laws that every model obeys, and the known albedos of each.

use super::*;
use crate::Error;
use traylib_math::{Rgb, Sampler, warp};

const EXPONENTS: [f32; 7] = [0.0, 1.0, 5.0, 20.0, 1e3, 1e5, 1e6];

fn direction(degrees: f32, azimuth: f32) -> Vec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Vec3::new(sin * azimuth.cos(), sin * azimuth.sin(), cos)
}

fn phong(diffuse: f32, specular: f32, exponent: f32) -> SurfaceModel {
    SurfaceModel::Phong(Phong::new(Rgb::splat(diffuse), Rgb::splat(specular), exponent).unwrap())
}

fn max_phong(specular: f32, exponent: f32) -> SurfaceModel {
    SurfaceModel::MaxPhong(MaxPhong::new(Rgb::splat(specular), exponent).unwrap())
}

fn mirror(reflectance: f32, diffuse: f32) -> SurfaceModel {
    SurfaceModel::Mirror(Mirror::new(Rgb::splat(reflectance), Rgb::splat(diffuse)).unwrap())
}

/// Half of the light passes, most of it near the straight direction.
fn sheet(exponent: f32) -> SurfaceModel {
    let part = |kd, ks| Phong::new(Rgb::splat(kd), Rgb::splat(ks), exponent).unwrap();
    SurfaceModel::Sheet(Sheet::new(part(0.3, 0.1), part(0.1, 0.4)).unwrap())
}

fn models() -> Vec<SurfaceModel> {
    let mut models = Vec::new();
    loop {
        let examples = examples_after(models.last());
        if examples.is_empty() {
            return models;
        }
        models.extend(examples);
    }
}

/// Some of the first model, or of the one after the last; none after the last of all. A new
/// one has to find its place here.
fn examples_after(last: Option<&SurfaceModel>) -> Vec<SurfaceModel> {
    match last {
        None => vec![SurfaceModel::Lambert(Lambert::new(Rgb::new(0.2, 0.5, 0.9)).unwrap())],
        Some(SurfaceModel::Lambert(_)) => vec![mirror(0.5, 0.3)],
        Some(SurfaceModel::Mirror(_)) => {
            EXPONENTS.into_iter().flat_map(|n| [phong(0.3, 0.6, n), phong(0.0, 1.0, n)]).collect()
        }
        Some(SurfaceModel::Phong(_)) => EXPONENTS.map(|n| max_phong(0.9, n)).to_vec(),
        Some(SurfaceModel::MaxPhong(_)) => EXPONENTS.map(sheet).to_vec(),
        Some(SurfaceModel::Sheet(_)) => [0.7, 1.5]
            .map(|index| SurfaceModel::Dielectric(Dielectric::new(index).unwrap()))
            .to_vec(),
        Some(SurfaceModel::Dielectric(_)) => Vec::new(),
    }
}

/// Mean of `f` over `n` samples of the model, zero where it gives none.
fn mean(model: &SurfaceModel, wo: Vec3, n: u64, f: impl Fn(&BsdfSample) -> f32) -> f64 {
    let mut sampler = Sampler::numbered(11, 0);
    let sum: f64 = (0..n)
        .filter_map(|_| model.sample(Vec3::Z, wo, sampler.next_3d()))
        .map(|sample| f64::from(f(&sample)))
        .sum();
    sum / n as f64
}

#[test]
fn weight_is_value_over_density() {
    let mut sampler = Sampler::numbered(1, 0);
    for model in models() {
        for degrees in [0.0, 30.0, 60.0, 80.0, 89.0, 89.99] {
            let wo = direction(degrees, 0.3);
            for _ in 0..200 {
                let Some(sample) = model.sample(Vec3::Z, wo, sampler.next_3d()) else {
                    continue;
                };
                if sample.is_delta {
                    continue;
                }
                let scattered = model.evaluate(Vec3::Z, wo, sample.wi);
                assert_eq!(
                    (scattered.pdf, scattered.pdf_reverse),
                    (sample.pdf, sample.pdf_reverse)
                );
                let expected = scattered.f * (sample.wi.z.abs() / sample.pdf.0);
                for (got, want) in sample.weight.to_array().iter().zip(expected.to_array()) {
                    assert!((got - want).abs() <= 1e-5 * want, "{model:?} {got} {want}");
                }
            }
        }
    }
}

#[test]
fn exchanging_directions_changes_nothing() {
    let mut sampler = Sampler::numbered(2, 0);
    let normal = Vec3::new(0.2, -0.5, 0.7).normalize();
    for model in models() {
        for _ in 0..500 {
            let a = warp::cosine_hemisphere(normal, sampler.next_2d());
            let b = match model.sample(normal, a, sampler.next_3d()) {
                Some(sample) if !sample.is_delta => sample.wi,
                _ => warp::cosine_hemisphere(normal, sampler.next_2d()),
            };
            let behind = if normal.dot(b) < 0.0 { -normal } else { normal };
            let (ab, ba) = (model.evaluate(normal, a, b), model.evaluate(behind, b, a));
            assert_eq!(ab.f, ba.f, "{model:?}");
            assert_eq!((ab.pdf, ab.pdf_reverse), (ba.pdf_reverse, ba.pdf));
        }
    }
}

/// A(θ, n) of the modified Phong lobe, by quadrature, for 0°, 60°, 80°, 89°.
const PHONG_ALBEDO: [(f32, [f64; 4]); 5] = [
    (1.0, [1.0, 0.6090, 0.4100, 0.3271]),
    (5.0, [1.0, 0.5194, 0.2693, 0.1786]),
    (20.0, [1.0, 0.5005, 0.2003, 0.0971]),
    (1e3, [1.0, 0.5, 0.1737, 0.0232]),
    (1e6, [1.0, 0.5, 0.1736, 0.0175]),
];

#[test]
fn phong_albedo_matches_the_table() {
    const SAMPLES: u64 = 100_000;
    for (n, albedos) in PHONG_ALBEDO {
        for (degrees, albedo) in [0.0, 60.0, 80.0, 89.0].into_iter().zip(albedos) {
            let wo = direction(degrees, 1.0);
            let got = mean(&phong(0.0, 1.0, n), wo, SAMPLES, |s| s.weight.g);
            // Weights stay below 1.5: five standard errors of the mean at most.
            let slack = 5.0 * 0.75 / (SAMPLES as f64).sqrt();
            assert!((got - albedo).abs() < slack, "n {n}, {degrees}°: {got} {albedo}");
        }
    }
}

/// The part of the lobe below the horizon, by quadrature, for 60°, 80°, 89°: as
/// often must sampling fail.
#[test]
fn phong_loses_just_what_dips_below_the_horizon() {
    const SAMPLES: u64 = 100_000;
    let table = [
        (1.0, [0.25, 0.413, 0.491]),
        (5.0, [0.104, 0.340, 0.484]),
        (20.0, [0.008, 0.214, 0.469]),
        (1e3, [0.0, 0.0, 0.290]),
    ];
    for (n, lost) in table {
        for (degrees, lost) in [60.0, 80.0, 89.0].into_iter().zip(lost) {
            let kept = mean(&phong(0.0, 1.0, n), direction(degrees, 0.0), SAMPLES, |_| 1.0);
            // Table digits plus five standard errors of a frequency.
            let slack = 6e-4 + 5.0 * 0.5 / (SAMPLES as f64).sqrt();
            assert!((1.0 - kept - lost).abs() < slack, "n {n}, {degrees}°: {kept}");
        }
    }
}

#[test]
fn max_phong_tends_to_the_mirror_and_never_above() {
    let at_80 = |n| mean(&max_phong(1.0, n), direction(80.0, 0.0), 20_000, |s| s.weight.g);
    assert!((at_80(1e3) - 0.928).abs() < 5e-3, "{}", at_80(1e3));
    assert!((at_80(1e6) - 0.998).abs() < 1e-3, "{}", at_80(1e6));
    for n in EXPONENTS {
        for degrees in [0.0, 45.0, 85.0] {
            assert!(
                mean(&max_phong(1.0, n), direction(degrees, 0.0), 5_000, |s| s.weight.g) <= 1.0
            );
        }
    }
}

/// In lobe coordinates (cosⁿ⁺¹α and the azimuth around the mirror direction)
/// sampled directions are uniform at any exponent. Chi-square over 16 × 16
/// cells, 255 degrees of freedom; seven tests at a family level of 1e-3.
#[test]
fn lobe_samples_are_uniform_in_lobe_coordinates() {
    const SAMPLES: u32 = 100_000;
    let wo = direction(20.0, 0.7);
    let axis = Vec3::new(-wo.x, -wo.y, wo.z);
    let frame = traylib_math::Frame::around(axis);
    for n in [20.0, 1e3, 1e5, 1e6] {
        let mut counts = [[0_u32; 16]; 16];
        let mut sampler = Sampler::numbered(5, n as u64);
        for _ in 0..SAMPLES {
            let Some(sample) = max_phong(1.0, n).sample(Vec3::Z, wo, sampler.next_3d()) else {
                continue;
            };
            let away = sample.wi - axis;
            let height = warp::cosine_power(0.5 * away.length_squared(), n + 1.0);
            let local = frame.to_local(sample.wi);
            let azimuth = local.y.atan2(local.x) / std::f32::consts::TAU + 0.5;
            counts[((height * 16.0) as usize).min(15)][((azimuth * 16.0) as usize).min(15)] += 1;
        }
        let expected = f64::from(SAMPLES) / 256.0;
        let chi_square: f64 =
            counts.iter().flatten().map(|&c| (f64::from(c) - expected).powi(2) / expected).sum();
        // 1 − 1e-3/4 quantile of chi-square with 255 degrees of freedom.
        assert!(chi_square < 341.0, "n {n}: {chi_square}");
    }
}

#[test]
fn mirror_and_diffuse_part_share_the_light() {
    let model = mirror(0.6, 0.2);
    assert!(model.has_smooth_part() && model.has_delta_part());
    assert!(!mirror(0.6, 0.0).has_smooth_part());
    let wo = direction(50.0, 0.0);
    let delta = mean(&model, wo, 20_000, |s| if s.is_delta { s.weight.g } else { 0.0 });
    let smooth = mean(&model, wo, 20_000, |s| if s.is_delta { 0.0 } else { s.weight.g });
    assert!((delta - 0.6).abs() < 0.02 && (smooth - 0.2).abs() < 0.02, "{delta} {smooth}");
}

#[test]
fn nothing_goes_through_but_sheets() {
    let below = Vec3::new(0.6, 0.0, -0.8);
    for model in models() {
        let through = model.evaluate(Vec3::Z, Vec3::Z, below);
        assert_eq!(through == Scattering::NONE, !model.transmits(), "{model:?}");
        assert_eq!(model.evaluate(Vec3::Z, below, Vec3::Z), Scattering::NONE);
        assert!(model.sample(Vec3::Z, below, [0.5; 3]).is_none());
    }
}

/// At right angles a lobe loses nothing: just the four parts are left.
#[test]
fn a_sheet_shares_the_light_among_its_parts() {
    let model = sheet(20.0);
    let (front, back) = (|s: &BsdfSample| s.wi.z > 0.0, |s: &BsdfSample| s.wi.z < 0.0);
    let share = |side: fn(&BsdfSample) -> bool| {
        mean(&model, Vec3::Z, 20_000, |s| if side(s) { s.weight.g } else { 0.0 })
    };
    let (reflected, passed) = (share(front), share(back));
    // Weights stay below 1.1: five standard errors of the mean at most.
    let slack = 5.0 * 0.55 / f64::from(20_000_u16).sqrt();
    assert!((reflected - 0.4).abs() < slack && (passed - 0.5).abs() < slack);
}

#[test]
fn parameters_that_create_energy_are_refused() {
    let half = Rgb::splat(0.5);
    assert!(matches!(Lambert::new(Rgb::splat(1.1)), Err(Error::Reflectance { .. })));
    assert!(matches!(Lambert::new(Rgb::new(0.0, f32::NAN, 0.0)), Err(Error::Reflectance { .. })));
    assert!(matches!(Phong::new(half, Rgb::splat(0.6), 1.0), Err(Error::Energy { .. })));
    assert!(matches!(Phong::new(half, half, 2e6), Err(Error::Exponent(_))));
    assert!(matches!(MaxPhong::new(half, f32::NAN), Err(Error::Exponent(_))));
    assert!(matches!(Mirror::new(half, Rgb::splat(0.6)), Err(Error::Energy { .. })));
    assert!(Phong::new(Rgb::splat(0.7), Rgb::splat(0.3), 1.0).is_ok());
}
