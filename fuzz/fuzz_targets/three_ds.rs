//! Any bytes as a 3DS file, and all that is computed from one.
#![no_main]

use libfuzzer_sys::fuzz_target;
use traylib_io::three_ds::{Counts, decode, pose, smoothing};

fuzz_target!(|bytes: &[u8]| {
    let Ok(mut document) = decode(bytes) else { return };
    for mesh in &document.meshes {
        let _ = smoothing::corner_normals(mesh, &mut document.warnings);
    }
    let _ = Counts::of(&document);
    let placed = pose::stored_with_instances(&document);
    assert!(placed.iter().all(|placed| placed.place.is_finite()));
});
