//! OBJ, PLY and glTF files as scenes, and in scenes.

use super::*;
use crate::{Headlight, Limit, ReadLimits};
use traylib_scene::Light;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/models");

fn file(name: &str) -> String {
    format!("{FOLDER}/{name}")
}

/// A floor and a lamp above it that faces down.
const ROOM: &str = "mtllib room.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\n\
                    v 1 2 1\nf 4 3 2 1\nusemtl lamp\nf 5 6 7\n";
const LAMP: &[u8] = b"newmtl lamp\nKd 0 0 0\nKe 3 3 3\n";

/// A camera with a light beside it.
const LIT: &str = r#"{"asset":{"version":"2.0"},
    "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":2}]}},
    "cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1,"aspectRatio":2}}],
    "nodes":[{"camera":0,"translation":[0,0,4]},{"mesh":0},
        {"translation":[1,2,3],"extensions":{"KHR_lights_punctual":{"light":0}}}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "buffers":[{"byteLength":36,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}"#;

fn load_gltf(test: &str, text: &str, options: LoadOptions<'_>) -> Result<Loaded, Error> {
    let path = std::env::temp_dir().join(format!("traylib-{}-{test}.gltf", std::process::id()));
    fs::write(&path, text).unwrap();
    let loaded = load_scene_with(&path.to_string_lossy(), options);
    fs::remove_file(&path).unwrap();
    loaded
}

#[test]
fn files_without_light_are_refused_or_lit_from_the_camera() {
    for name in ["trimesh.obj", "trimesh-text.ply", "trimesh-binary.ply", "trimesh.glb"] {
        assert!(matches!(load_scene(&file(name)), Err(Error::Unlit(_))), "{name}");
        let options = LoadOptions { headlight: Headlight::WithoutLight, ..LoadOptions::default() };
        let loaded = load_scene_with(&file(name), options).unwrap();
        assert!(matches!(loaded.scene.lights(), [Light::Point(_)]), "{name}");
        let [camera] = &loaded.notes[..] else { panic!("{name}: {:?}", loaded.notes) };
        assert!(camera.contains("up: (0, 1, 0), fov: 40"), "{camera}");
    }
}

#[test]
fn a_mesh_is_the_same_by_itself_and_in_a_scene() {
    let others = [("room.obj", ROOM.as_bytes()), ("room.mtl", LAMP)];
    let mesh =
        |more: &str| format!("({CAMERA} objects: [(shape: Mesh(file: \"room.obj\"{more}))])");
    let loaded = load_text("obj", &mesh(""), &others).unwrap();
    // Both sides of the lamp, which is open.
    assert_eq!((loaded.scene.primitive_count(), loaded.scene.lights().len()), (4, 2));
    let shines = |loaded: &Loaded| match loaded.scene.lights()[0] {
        Light::Area { radiance, .. } => radiance.g,
        Light::Point(_) | Light::Sky(_) => 0.0,
    };
    assert_eq!(shines(&loaded), 3.0);
    let dimmed = load_text("dimmed", &mesh(", glow: 0.5"), &others).unwrap();
    assert_eq!(shines(&dimmed), 1.5);
    let error = report("dark", &mesh(", glow: 0"), &others);
    assert!(error.contains("nothing in the scene emits light"), "{error}");
}

#[test]
fn a_gltf_file_brings_its_camera_and_its_lights() {
    let loaded = load_gltf("whole", LIT, LoadOptions::default()).unwrap();
    let camera = loaded.scene.camera();
    assert_eq!((camera.width(), camera.height()), (400, 200));
    assert_eq!(camera.position(), traylib_math::Vec3::new(0.0, 0.0, 4.0));
    let [Light::Point(light)] = loaded.scene.lights() else { panic!() };
    assert_eq!((light.intensity.g, light.position.x), (2.0, 1.0));
    let mesh = |more: &str| format!("({CAMERA} objects: [(shape: Mesh(file: \"a.gltf\"{more}))])");
    let others = [("a.gltf", LIT.as_bytes())];
    let loaded = load_text("lights", &mesh(", scale: 2, lights: 0.5"), &others).unwrap();
    let [Light::Point(light)] = loaded.scene.lights() else { panic!() };
    assert_eq!((light.intensity.g, light.position.x), (1.0, 2.0));
    let error = report("unused", &mesh(""), &others);
    assert!(error.contains("nothing in the scene emits light"), "{error}");
}

#[test]
fn faults_in_meshes_are_told_in_scene_files() {
    let others = [("a.obj", &b"v 0 0 0\nf 1 2 3\n"[..]), ("b.ply", b"plz"), ("c.glb", b"glTF")];
    for (name, wanted) in [
        ("a.obj", "a.obj cannot be used: line 2: there is no vertex 2: there are 1 so far"),
        ("b.ply", "b.ply cannot be used: it is no PLY file"),
        ("c.glb", "c.glb cannot be used: byte 4: the file ends"),
    ] {
        let shown = report(
            "faults",
            &lit(&format!("objects: [(shape: Mesh(file: \"{name}\"))],")),
            &others,
        );
        assert!(shown.contains(wanted), "{shown}");
    }
    let mut limits = ReadLimits::default();
    limits.set(Limit::Bytes, 100);
    let options = LoadOptions { limits, ..LoadOptions::default() };
    for name in ["trimesh.obj", "trimesh-text.ply", "trimesh.glb"] {
        let error = load_scene_with(&file(name), options).unwrap_err().to_string();
        assert!(error.ends_with("`--limit bytes=200` allows more"), "{error}");
    }
}
