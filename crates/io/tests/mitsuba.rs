//! Scenes of Mitsuba, held against what Mitsuba 3.9.1 itself finds in them along rays
//! (`data/mitsuba/probe.py`): the camera, how far surfaces are and how they are turned, their
//! colours with pictures on them, and what they emit, from the front and from behind.
#![allow(clippy::unwrap_used, reason = "a test may fail so, in its helpers too")]

use serde_json::Value;
use std::f32::consts::PI;
use traylib_geometry::Ray;
use traylib_io::load_scene;
use traylib_math::{Rgb, Vec2, Vec3};
use traylib_scene::Scene;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/mitsuba");

fn vector(value: &Value) -> Vec3 {
    let number = |index: usize| value[index].as_f64().unwrap() as f32;
    Vec3::new(number(0), number(1), number(2))
}

/// Files that have no warning.
const CLEAN: [&str; 6] = ["meshes", "textures", "sides", "included", "box", "paints"];

#[test]
fn mitsuba_finds_the_same_along_rays() {
    let text = std::fs::read_to_string(format!("{FOLDER}/expected.json")).unwrap();
    let expected: Value = serde_json::from_str(&text).unwrap();
    let scenes = expected.as_object().unwrap();
    assert_eq!(scenes.len(), 10);
    for (name, expected) in scenes {
        let loaded = load_scene(&format!("{FOLDER}/{name}.xml")).unwrap();
        let warnings: Vec<String> = loaded.warnings.iter().map(ToString::to_string).collect();
        assert!(!CLEAN.contains(&name.as_str()) || warnings.is_empty(), "{warnings:?}");
        let camera = loaded.scene.camera();
        let size = [u64::from(camera.width()), u64::from(camera.height())];
        assert_eq!(
            size.map(Some),
            ["width", "height"].map(|side| expected[side].as_u64()),
            "{name}"
        );
        let probes = expected["probes"].as_array().unwrap();
        let wrong: Vec<String> =
            probes.iter().filter_map(|probe| disagreement(&loaded.scene, probe)).collect();
        // A ray along an edge may see either side of it.
        assert!(
            wrong.len() <= 1,
            "{name}: {} of {}\n{}",
            wrong.len(),
            probes.len(),
            wrong.join("\n")
        );
    }
}

/// What we find otherwise than Mitsuba.
fn disagreement(scene: &Scene, probe: &Value) -> Option<String> {
    let (origin, direction) = (vector(&probe["origin"]), vector(&probe["direction"]));
    let pixel = &probe["pixel"];
    if let (Some(x), Some(y)) = (pixel[0].as_f64(), pixel[1].as_f64()) {
        let own = scene.camera().ray(Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
        // Mitsuba's begin on its near plane.
        let aside = (origin - own.origin).cross(own.direction.normalize()).length();
        let turned = (own.direction.normalize() - direction.normalize()).length();
        if aside > 1e-4 || turned > 1e-5 {
            return Some(format!("{probe}: the camera's ray is {own:?}"));
        }
    }
    let ray = Ray::new(origin, direction);
    let found = scene.intersect(&ray);
    let hit = &probe["hit"];
    if hit.is_null() {
        return found.map(|point| format!("{probe}: {:?} where nothing is", point.site.position));
    }
    let Some(point) = found else { return Some(format!("{probe}: nothing")) };
    let distance = (point.site.position - origin).length() / direction.length();
    let wo = -direction.normalize();
    let reflected = point.evaluate(wo, wo).f * PI;
    let emitted = scene.emitted(&point);
    let [wanted_reflected, wanted_emitted] =
        ["reflected", "emitted"].map(|name| Rgb::from(vector(&hit[name]).to_array()));
    let wanted = hit["distance"].as_f64().unwrap() as f32;
    let normal = vector(&hit["normal"]);
    let cosine = normal.dot(point.shading_normal).abs();
    let near = |a: Rgb, b: Rgb| {
        (a.to_array().into_iter().zip(b.to_array())).all(|(a, b)| (a - b).abs() <= 2e-3 * (1.0 + b))
    };
    let agrees = (distance - wanted).abs() < 1e-3 * wanted
        && near(reflected, wanted_reflected)
        && near(emitted, wanted_emitted)
        && cosine > 0.9999;
    (!agrees).then(|| {
        format!("{probe}: at {distance}, {reflected:?}, {emitted:?}, {:?}", point.shading_normal)
    })
}
