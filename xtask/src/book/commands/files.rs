//! Files that pages speak of as those of their readers.

use super::programs::Programs;
use crate::book::page::Page;
use crate::workspace::root;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A file that pages name, and the one of the project in its place.
const FILES: [(&str, &str); 6] = [
    ("my.ron", "scenes/reference-a.ron"),
    ("chair.obj", "scenes/models/bowl.obj"),
    ("model.obj", "scenes/models/bowl.obj"),
    ("kitchen.xml", "crates/io/tests/data/mitsuba/box.xml"),
    ("YOURS.mgf", "crates/io/tests/data/shapes.mgf"),
    ("target/relations/1-512-Methods.ron", "tests/data/relations/box-edge.ron"),
];

/// Returns a new folder with them, from which the project's scenes are in `scenes`.
pub(super) fn folder(programs: &Programs) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::create_dir_all(path.join("target/relations")).unwrap();
    for (name, source) in FILES {
        fs::copy(root().join(source), path.join(name)).unwrap();
    }
    for name in ["YOURS.glb", "chair.glb", "room.glb"] {
        fs::write(path.join(name), glb(LAMP)).unwrap();
    }
    std::os::unix::fs::symlink(
        fs::canonicalize(root().join("scenes")).unwrap(),
        path.join("scenes"),
    )
    .unwrap();
    render(programs, path, "pyramid --spp 1 -o BETTER.exr");
    for name in ["mine.exr", "reference.exr"] {
        fs::copy(path.join("BETTER.exr"), path.join(name)).unwrap();
    }
    // All parts of seven but the first, which a page renders.
    for part in 1..7 {
        render(
            programs,
            path,
            &format!("my.ron --spp 16 --shard {part}/7 --checkpoint part-{part}.film"),
        );
    }
    folder
}

/// Saves the scenes of a page that have a name: blocks of `ron NAME`.
pub(super) fn save_scenes(page: &Page, folder: &Path) {
    for block in &page.blocks {
        if let Some(name) = block.language.strip_prefix("ron ") {
            fs::write(folder.join(name), &block.text).unwrap();
        }
    }
}

fn render(programs: &Programs, folder: &Path, arguments: &str) {
    let arguments = arguments.split(' ').chain(["--resolution", "32x24"]).map(String::from);
    programs.run("bdpt", &arguments.collect::<Vec<_>>(), folder).unwrap();
}

/// A triangle that shines, in glTF.
const LAMP: &str = r#"{
    "asset": {"version": "2.0"},
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
    "materials": [{"emissiveFactor": [1, 1, 1]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36}]
}"#;

/// A file in binary glTF of this document and the triangle's corners.
fn glb(document: &str) -> Vec<u8> {
    let corners = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let corners: Vec<u8> =
        corners.iter().flatten().flat_map(|number| number.to_le_bytes()).collect();
    let mut text = document.as_bytes().to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut chunks = Vec::new();
    for (kind, content) in [(b"JSON", &text), (b"BIN\0", &corners)] {
        chunks.extend((content.len() as u32).to_le_bytes());
        chunks.extend(kind);
        chunks.extend(content);
    }
    let mut file = b"glTF".to_vec();
    file.extend(2_u32.to_le_bytes());
    file.extend((12 + chunks.len() as u32).to_le_bytes());
    file.extend(chunks);
    file
}
