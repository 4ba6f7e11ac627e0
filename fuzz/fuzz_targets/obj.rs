//! Any bytes as an OBJ file, and as a material library.
#![no_main]

use libfuzzer_sys::fuzz_target;
use traylib_io::obj::{Limits, decode, mtl};

fuzz_target!(|bytes: &[u8]| {
    let _ = mtl::decode(bytes, Limits::default());
    let Ok(document) = decode(bytes, Limits::default()) else { return };
    for corner in document.faces.iter().flat_map(|face| document.corners_of(face)) {
        assert!((corner.position as usize) < document.positions.len());
        assert!(corner.uv.is_none_or(|uv| (uv.get() as usize) < document.uvs.len()));
        assert!(corner.normal.is_none_or(|n| (n.get() as usize) < document.normals.len()));
    }
    assert!(document.positions.iter().all(|position| position.is_finite()));
});
