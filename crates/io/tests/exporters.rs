//! Files that public programs wrote, held against what other programs read in them: a row for each
//! in `data/exporters/expected.json`, which its `read.py` writes.
#![allow(clippy::unwrap_used, reason = "a test may fail so, in its helpers too")]

use serde_json::{Map, Value};
use std::path::PathBuf;
use traylib_geometry::Ray;
use traylib_io::{Inventory, LoadOptions, MeshCounts, inventory, load_scene};
use traylib_math::Vec3;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/exporters");
/// Rows of a kind, at least.
const ENOUGH: usize = 10;

fn expected() -> Map<String, Value> {
    let text = std::fs::read_to_string(format!("{FOLDER}/expected.json")).unwrap();
    let Value::Object(rows) = serde_json::from_str(&text).unwrap() else { panic!("no object") };
    rows
}

fn numbers(value: &Value) -> Vec<f64> {
    let one = std::slice::from_ref(value);
    let all = value.as_array().map_or(one, Vec::as_slice);
    all.iter().map(|value| value.as_f64().unwrap()).collect()
}

/// Tells whether these are the same, but for rounding beside the largest.
fn agree(found: &[f64], wanted: &[f64]) -> bool {
    let scale = wanted.iter().fold(0.0_f64, |scale, value| scale.max(value.abs()));
    let near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-5 * scale;
    found.len() == wanted.len() && found.iter().zip(wanted).all(near)
}

fn counted(name: &str) -> MeshCounts {
    let file = PathBuf::from(format!("{FOLDER}/{name}"));
    let (found, _) = inventory(&[file], LoadOptions::default()).unwrap();
    let Inventory::Meshes(counts) = found else { panic!("{name}: {found:?}") };
    *counts
}

fn wide(values: &[f32]) -> Vec<f64> {
    values.iter().copied().map(f64::from).collect()
}

#[test]
fn other_readers_find_the_same_in_files_of_meshes() {
    let (rows, mut wrong) = (expected(), Vec::new());
    for (name, wanted) in rows.iter().filter(|(name, _)| !name.starts_with("mitsuba")) {
        let counts = counted(name);
        let found = [
            ("triangles", vec![counts.triangles as f64]),
            ("area", vec![counts.area]),
            ("bbox", wide(&counts.bbox)),
            ("uv_box", wide(&counts.uv_box)),
            ("colours", wide(counts.colours.as_flattened())),
        ];
        for (key, found) in found {
            // The readers have no colours of what shows pictures.
            let Some(wanted) = wanted.get(key).map(numbers) else { continue };
            if !agree(&found, &wanted) {
                wrong.push(format!("{name}: {key} {found:?}, not {wanted:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    for kind in ["obj", "ply", "gltf"] {
        let count = rows.keys().filter(|name| name.starts_with(kind)).count();
        assert!(count >= ENOUGH, "{kind}: {count}");
    }
}

/// Scenes that Mitsuba's own writer made: its lamps, and the surfaces along rays.
#[test]
fn mitsuba_finds_the_same_in_scenes_it_wrote() {
    for (name, wanted) in expected().iter().filter(|(name, _)| name.starts_with("mitsuba")) {
        let scene = load_scene(&format!("{FOLDER}/{name}")).unwrap().scene;
        assert_eq!(scene.lights().len() as u64, wanted["lamps"].as_u64().unwrap(), "{name}");
        for ray in wanted["rays"].as_array().unwrap() {
            let [origin, direction] = [0, 1].map(|part| {
                let numbers = numbers(&ray[part]);
                Vec3::new(numbers[0] as f32, numbers[1] as f32, numbers[2] as f32)
            });
            let hit = scene.intersect(&Ray::new(origin, direction));
            let found = hit.map(|hit| f64::from((hit.site.position - origin).length()));
            let wanted = ray[2].as_f64().map(|far| far * f64::from(direction.length()));
            let agrees = match (found, wanted) {
                (Some(found), Some(wanted)) => (found - wanted).abs() < 1e-3 * wanted,
                (found, wanted) => found.is_none() && wanted.is_none(),
            };
            assert!(agrees, "{name}: {ray}: {found:?}");
        }
    }
}

#[test]
fn compressed_meshes_are_refused_by_the_name_of_what_they_need() {
    for (name, needed) in [
        ("transform-draco.glb", "KHR_draco_mesh_compression"),
        ("transform-meshopt.glb", "EXT_meshopt_compression"),
    ] {
        let file = PathBuf::from(format!("{FOLDER}/gltf/{name}"));
        let told = inventory(&[file], LoadOptions::default()).unwrap_err().to_string();
        assert!(told.contains(&format!("it needs the extension `{needed}`")), "{told}");
    }
}
