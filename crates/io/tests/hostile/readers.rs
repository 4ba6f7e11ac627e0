//! All that is done with a file, by the reader for its ending.

use std::path::{Path, PathBuf};
use traylib_io::mgf::{self, tessellate};
use traylib_io::three_ds::{self, pose, smoothing};
use traylib_io::{TextureLimits, load_scene, texture_from_bytes};
use traylib_io::{gltf, mitsuba, obj, ply};

/// Tells whether it could be read. `root` is a folder of the test alone, in which `name` is.
pub(crate) fn read(root: &Path, name: &Path, bytes: &[u8]) -> bool {
    let ending = name.extension().unwrap_or_default().to_ascii_lowercase();
    match ending.to_str() {
        Some("mgf") => read_mgf(root, name, bytes),
        Some("3ds") => read_three_ds(bytes),
        Some("obj") => read_obj(bytes),
        Some("mtl") => obj::mtl::decode(bytes, obj::Limits::default()).is_ok(),
        Some("ply") => read_ply(bytes),
        Some("gltf" | "glb") => read_gltf(bytes),
        Some("xml") => read_mitsuba(root, bytes),
        _ => texture_from_bytes(bytes, name, TextureLimits::default()).is_ok(),
    }
}

fn read_mgf(root: &Path, name: &Path, bytes: &[u8]) -> bool {
    // Beside the original, for what it includes.
    let file = root.join(name).with_file_name("mutated.mgf");
    std::fs::create_dir_all(file.parent().unwrap_or(root)).unwrap();
    let _ = std::fs::remove_file(&file);
    std::fs::write(&file, bytes).unwrap();
    let options = mgf::Options { root: Some(PathBuf::from(root)), ..mgf::Options::default() };
    let Ok(document) = mgf::decode(&[file], &options) else { return false };
    for surface in document.surfaces.iter().take(100) {
        assert!(surface.material < document.materials.len());
        for corner in tessellate::triangles(&surface.shape, 1).iter().flatten() {
            assert!(!corner.position.is_nan());
        }
    }
    true
}

fn read_three_ds(bytes: &[u8]) -> bool {
    let Ok(mut document) = three_ds::decode(bytes) else { return false };
    for mesh in &document.meshes {
        let _ = smoothing::corner_normals(mesh, &mut document.warnings);
    }
    let placed = pose::stored_with_instances(&document);
    assert!(placed.iter().all(|placed| placed.place.is_finite()));
    let _ = placed.iter().filter(|placed| pose::is_shown(&document, placed)).count();
    assert!(three_ds::Counts::of(&document).faces <= bytes.len() / 8);
    true
}

fn read_obj(bytes: &[u8]) -> bool {
    let Ok(document) = obj::decode(bytes, obj::Limits::default()) else { return false };
    for corner in document.faces.iter().flat_map(|face| document.corners_of(face)) {
        assert!((corner.position as usize) < document.positions.len());
        assert!(corner.uv.is_none_or(|uv| (uv.get() as usize) < document.uvs.len()));
        assert!(corner.normal.is_none_or(|n| (n.get() as usize) < document.normals.len()));
    }
    true
}

fn read_ply(bytes: &[u8]) -> bool {
    let Ok(document) = ply::decode(bytes, ply::Limits::default()) else { return false };
    let corners = document.faces().flat_map(|(_, corners)| corners);
    assert!(corners.into_iter().all(|&corner| (corner as usize) < document.positions.len()));
    true
}

fn read_mitsuba(root: &Path, bytes: &[u8]) -> bool {
    let mut load = |_: &str| Err("none".to_string());
    let decoded = mitsuba::decode("a.xml", bytes, mitsuba::Limits::default(), &mut load);
    let Ok(document) = decoded else { return false };
    let all = document.objects.len();
    assert!(
        document.objects.iter().flat_map(|object| &object.children).all(|child| child.object < all)
    );
    let file = root.join("mutated.xml");
    std::fs::write(&file, bytes).unwrap();
    let _ = load_scene(&file.to_string_lossy());
    true
}

fn read_gltf(bytes: &[u8]) -> bool {
    let mut load = |_: &str| Err("none".to_string());
    let Ok(document) = gltf::decode(bytes, gltf::Limits::default(), &mut load) else {
        return false;
    };
    for primitive in &document.primitives {
        let count = primitive.positions.len();
        assert!(primitive.triangles.iter().flatten().all(|&corner| (corner as usize) < count));
    }
    assert!(document.instances.iter().all(|instance| instance.place.is_finite()));
    true
}
