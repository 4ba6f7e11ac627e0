//! Laws of lamps: points and directions follow their densities, and what is
//! emitted is all that the lamp has.

use super::{FAST, LONG, sampler};
use glam::DVec3;
use std::f64::consts::{PI, TAU};
use traylib_geometry::{Primitive, Vec3};
use traylib_known::frame::frame;
use traylib_known::grid::{Counts, even, probabilities};
use traylib_math::Rgb;
use traylib_scene::{Light, PointLight};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::laws::chart::{Chart, View, views};
use traylib_tests::laws::chi_square::follows;
use traylib_tests::laws::verdict::{within, worse};

/// Points toward a place follow the stated density, which integrates to one
/// over what is seen.
fn toward_findings(view: &View, samples: u64) -> Vec<Finding> {
    let View { name, shape, from } = view;
    let chart = Chart::seen_from(shape, *from);
    let density = |at| {
        let (position, normal) = chart.point(at);
        let pdf = shape.pdf_toward(*from, position.as_vec3(), normal.as_vec3());
        f64::from(pdf.0) * chart.area()
    };
    let cells = probabilities(density);
    let total: f64 = cells.iter().sum();
    let mut counts = Counts::new(0);
    let mut sampler = sampler(name);
    for _ in 0..samples {
        let (site, _) = shape.sample_toward(*from, sampler.next_2d());
        counts.add(chart.coordinates(site.position));
    }
    vec![
        within(format!("{name}: ∫ pdf dA = 1"), (total - 1.0).abs(), 5e-5, 0),
        follows(format!("{name}: points toward a place"), &cells, &counts.cells),
    ]
}

/// Points of the whole surface are alike.
fn area_finding(view: &View, samples: u64) -> Finding {
    let View { name, shape, .. } = view;
    // From its middle all of a sphere is seen.
    let middle = if let Primitive::Sphere(sphere) = shape { sphere.centre() } else { Vec3::ZERO };
    let chart = Chart::seen_from(shape, middle);
    let mut counts = Counts::new(0);
    let mut sampler = sampler(&format!("{name}, area"));
    for _ in 0..samples {
        counts.add(chart.coordinates(shape.sample_area(sampler.next_2d()).position));
    }
    follows(format!("{name}: points by area"), &even(), &counts.cells)
}

/// The density that a drawn point comes with is the one asked for later.
fn density_finding(view: &View, samples: u64) -> Finding {
    let View { name, shape, from } = view;
    let mut sampler = sampler(&format!("{name}, density"));
    let different = (0..samples).filter(|_| {
        let (site, pdf) = shape.sample_toward(*from, sampler.next_2d());
        pdf.0.to_bits() != shape.pdf_toward(*from, site.position, site.normal).0.to_bits()
    });
    let different = different.count() as f64;
    within(format!("{name}: density of a drawn point, bits"), different, 0.0, samples)
}

fn point_laws(samples: u64) {
    let findings = views().into_iter().flat_map(|view| {
        let mut findings = toward_findings(&view, samples);
        findings.extend([area_finding(&view, samples), density_finding(&view, samples / 10)]);
        findings
    });
    settle(&findings.collect::<Vec<_>>());
}

#[test]
fn points_of_lamps_follow_their_density() {
    point_laws(FAST);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn points_of_lamps_follow_their_density_at_length() {
    point_laws(LONG);
}

/// The light that a light path starts with, over its density, is the lamp's power: π·A·L for an
/// area, 4π·I for a point. It is the same for every sample.
fn power_finding(name: &str, light: &Light, power: f64) -> Finding {
    const SAMPLES: u64 = 10_000;
    let mut sampler = sampler(name);
    let mut worst = (f64::from(light.power().g) / power - 1.0).abs();
    for _ in 0..SAMPLES {
        let emission = light.sample_emission(sampler.next_2d(), sampler.next_2d());
        let (point, direction) = (emission.point, emission.direction);
        let cosine = f64::from(point.cosine(direction));
        // Along the surface single precision gives a cosine of zero or nearly so.
        if cosine > 1e-3 {
            let density =
                f64::from(light.emission_pdf(&point).0 * point.direction_pdf(direction).0);
            let weight = f64::from(point.emitted.g) * cosine / density;
            worst = worse(worst, (weight / power - 1.0).abs());
        }
    }
    within(format!("{name}: every light path carries the lamp's power"), worst, 1e-6, SAMPLES)
}

/// Directions are uniform in (sin²θ, φ) around the normal of their point for an
/// area, in (z, φ) for a point light, and know nothing of where they start.
fn emission_findings(name: &str, light: &Light, samples: u64) -> Vec<Finding> {
    let mut sampler = sampler(&format!("{name}, directions"));
    let (mut directions, mut pairs) = (Counts::new(0), Counts::new(0));
    for _ in 0..samples {
        let (u_point, u_direction) = (sampler.next_2d(), sampler.next_2d());
        let emission = light.sample_emission(u_point, u_direction);
        let at = if light.is_point() {
            let w = DVec3::from(emission.direction);
            [0.5 * (w.z + 1.0), w.y.atan2(w.x).rem_euclid(TAU) / TAU]
        } else {
            let [_, u, v] = frame(DVec3::from(emission.point.site.normal));
            let [x, y] = [u, v].map(|axis| axis.dot(DVec3::from(emission.direction)));
            [x * x + y * y, y.atan2(x).rem_euclid(TAU) / TAU]
        };
        directions.add(at);
        pairs.add([at[0], f64::from(u_point.x)]);
    }
    vec![
        follows(format!("{name}: directions of emission"), &even(), &directions.cells),
        follows(format!("{name}: directions know no place"), &even(), &pairs.cells),
    ]
}

fn emission_laws(samples: u64) {
    let radiance = Rgb::splat(3.0);
    let lamps = views().into_iter().filter(|view| !view.name.contains("from")).map(|view| {
        let area = Chart::whole(&view.shape).area();
        (view.name, Light::Area { primitive: view.shape, radiance }, PI * area * 3.0)
    });
    let point = PointLight { position: Vec3::ONE, intensity: Rgb::splat(2.0), cone: None };
    let point = ("point light", Light::Point(point), 8.0 * PI);
    let findings = lamps.chain([point]).flat_map(|(name, light, power)| {
        let mut findings = emission_findings(name, &light, samples);
        findings.push(power_finding(name, &light, power));
        findings
    });
    settle(&findings.collect::<Vec<_>>());
}

#[test]
fn emission_follows_its_density_and_carries_the_power() {
    emission_laws(FAST);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn emission_follows_its_density_and_carries_the_power_at_length() {
    emission_laws(LONG);
}
