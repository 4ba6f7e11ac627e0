//! Inventories: the contents of a file, in figures.

use crate::load::load_scene_with;
use crate::load_options::LoadOptions;
use crate::source::Location;
use crate::{Error, MeshCounts, Warning, import, mgf, three_ds};
use serde::Serialize;
use std::path::{Path, PathBuf};
use traylib_scene::Light;

/// The contents of files as a reader made of them, as figures that can be held against what other
/// programs find in them.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Inventory {
    /// The contents of a 3DS file.
    ThreeDs(Box<three_ds::Counts>),
    /// The contents of MGF files, read one after the other.
    Mgf(Box<mgf::Counts>),
    /// The contents of an OBJ, PLY or glTF file.
    Meshes(Box<MeshCounts>),
    /// The contents of a scene in RON or built in.
    Scene(SceneCounts),
}

/// The contents of a scene, counted.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct SceneCounts {
    /// Triangles, spheres and other shapes.
    pub primitives: usize,
    /// Materials.
    pub materials: usize,
    /// Lamps with an area.
    pub area_lights: usize,
    /// Point lights.
    pub point_lights: usize,
    /// Whether there is a sky.
    pub sky: bool,
    /// Columns of the camera's picture.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// Reads files and counts what is in them; beside it, what was skipped or repaired. A missing
/// camera or lamp is no error in a file of shapes. Several files are one scene, which only MGF
/// knows. Of the options root, that of the first file where none is named, and limits count.
///
/// # Errors
/// A file cannot be read or makes no sense; several files of another format.
pub fn inventory(
    files: &[PathBuf],
    options: LoadOptions<'_>,
) -> Result<(Inventory, Vec<String>), Error> {
    match files {
        [] => Err(Error::NoFile),
        files if files.iter().all(|file| has_ending(file, "mgf")) => of_mgf(files, options),
        [file] if is_three_ds(file) => of_three_ds(file, options),
        [file] if import::has_mesh_counts(file) => {
            let location = Location::Disk(file.clone());
            let (counts, warnings) = import::mesh_counts(&location, options)?;
            let warnings = warnings.iter().map(ToString::to_string).collect();
            Ok((Inventory::Meshes(Box::new(counts)), warnings))
        }
        [file] => of_scene(file, options),
        [_, other, ..] => Err(Error::SeveralFiles(other.clone())),
    }
}

fn has_ending(file: &Path, wanted: &str) -> bool {
    file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(wanted))
}

/// Judges a file by its ending, or for want of one by its first bytes.
fn is_three_ds(file: &Path) -> bool {
    let starts = || std::fs::read(file).is_ok_and(|bytes| three_ds::decode(&bytes).is_ok());
    has_ending(file, "3ds") || (file.extension().is_none() && starts())
}

fn of_mgf(files: &[PathBuf], options: LoadOptions<'_>) -> Result<(Inventory, Vec<String>), Error> {
    let document = mgf::decode(files, &options.limits.mgf(options.root))?;
    let warnings = document.warnings.iter().map(ToString::to_string).collect();
    Ok((Inventory::Mgf(Box::new(document.counts)), warnings))
}

fn of_three_ds(file: &Path, options: LoadOptions<'_>) -> Result<(Inventory, Vec<String>), Error> {
    let name = file.display().to_string();
    let bytes = std::fs::read(file).map_err(|cause| Error::Read { file: name.clone(), cause })?;
    let document = three_ds::decode_within(&bytes, options.limits.three_ds())
        .map_err(|cause| Error::Format { file: name.clone(), cause: cause.into() })?;
    let warning = |(what, count)| Warning { file: name.clone(), what, count }.to_string();
    let warnings = document.warnings.iter().map(warning);
    let warnings = warnings.collect();
    Ok((Inventory::ThreeDs(Box::new(three_ds::Counts::of(&document))), warnings))
}

fn of_scene(file: &Path, options: LoadOptions<'_>) -> Result<(Inventory, Vec<String>), Error> {
    let loaded = load_scene_with(&file.to_string_lossy(), options)?;
    let count = |is_one: fn(&Light) -> bool| -> usize {
        loaded.scene.lights().iter().filter(|&light| is_one(light)).count()
    };
    let counts = SceneCounts {
        primitives: loaded.scene.primitive_count(),
        materials: loaded.scene.materials().len(),
        area_lights: count(|light| matches!(light, Light::Area { .. })),
        point_lights: count(Light::is_point),
        sky: loaded.scene.sky().is_some(),
        width: loaded.scene.camera().width(),
        height: loaded.scene.camera().height(),
    };
    let warnings = loaded.warnings.iter().map(ToString::to_string).collect();
    Ok((Inventory::Scene(counts), warnings))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scene_is_counted() {
        let (found, warnings) = inventory(&["cornell".into()], LoadOptions::default()).unwrap();
        assert!(warnings.is_empty());
        let Inventory::Scene(counts) = found else { panic!("{found:?}") };
        assert_eq!((counts.primitives, counts.area_lights, counts.width), (15, 1, 400));
    }

    #[test]
    fn a_mesh_is_counted() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/models/cube.3ds");
        let (found, _) = inventory(&[file.into()], LoadOptions::default()).unwrap();
        let Inventory::ThreeDs(counts) = found else { panic!("{found:?}") };
        assert_eq!((counts.meshes, counts.faces), (1, 12));
    }

    /// Files that trimesh 5.2.0 wrote, and what it found in them itself; of shared vertices
    /// the OBJ file has 8, which differ in their normals.
    #[test]
    fn others_find_the_same_in_files_of_meshes() {
        let models = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/models");
        for (name, triangles, vertices, area, bbox) in [
            ("trimesh.obj", 12, 8, 22.0, [-0.5, -1.0, -1.5, 0.5, 1.0, 1.5]),
            ("trimesh-text.ply", 80, 42, 6.562_087, [-0.75, -0.75, -0.75, 0.75, 0.75, 0.75]),
            ("trimesh-binary.ply", 12, 8, 22.0, [-0.5, -1.0, -1.5, 0.5, 1.0, 1.5]),
            ("trimesh.glb", 172, 92, 39.777_361, [-0.5, -1.0, -1.5, 2.754_650_4, 1.305_212_9, 1.5]),
        ] {
            let file = PathBuf::from(format!("{models}/{name}"));
            let (found, _) = inventory(&[file], LoadOptions::default()).unwrap();
            let Inventory::Meshes(counts) = found else { panic!("{found:?}") };
            assert_eq!((counts.triangles, counts.vertices), (triangles, vertices), "{name}");
            assert!((counts.area - area).abs() < 1e-5 * area, "{name}: {}", counts.area);
            let near = |(a, b): (f32, f32)| (a - b).abs() < 1e-6;
            assert!(counts.bbox.into_iter().zip(bbox).all(near), "{name}: {:?}", counts.bbox);
        }
    }

    /// Figures of the files that `TRAYLIB_MODELS` lists, a line each, to be held against those
    /// of another program.
    #[test]
    #[ignore = "real files"]
    fn real_files_of_meshes_are_counted() {
        let Some(list) = std::env::var_os("TRAYLIB_MODELS") else { return };
        for file in std::fs::read_to_string(list).unwrap().lines() {
            let found = inventory(&[file.into()], LoadOptions::default());
            let line = match found {
                Ok((counts, warnings)) => serde_json::json!([file, counts, warnings]),
                Err(error) => serde_json::json!([file, error.to_string()]),
            };
            println!("{line}");
        }
    }

    #[test]
    fn only_mgf_files_go_together() {
        let files = ["cornell", "furnace"].map(PathBuf::from);
        assert!(matches!(inventory(&files, LoadOptions::default()), Err(Error::SeveralFiles(_))));
        assert!(matches!(inventory(&[], LoadOptions::default()), Err(Error::NoFile)));
    }
}
