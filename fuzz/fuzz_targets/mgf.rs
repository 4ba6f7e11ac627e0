//! Any bytes as an MGF file, and its shapes as triangles. What it includes is
//! itself, by the name `x.mgf`, or not there.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::PathBuf;
use std::sync::LazyLock;
use traylib_io::mgf::{Options, decode, tessellate};

/// A folder of this process alone.
static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let name = format!("traylib-fuzz-mgf-{}", std::process::id());
    let folder = std::env::temp_dir().join(name);
    std::fs::create_dir_all(&folder).expect("a folder for temporary files");
    folder
});

fuzz_target!(|bytes: &[u8]| {
    let file = FOLDER.join("x.mgf");
    std::fs::write(&file, bytes).expect("room for temporary files");
    let Ok(document) = decode(&[file], &Options::default()) else { return };
    for surface in document.surfaces.iter().take(20) {
        assert!(surface.material < document.materials.len());
        for corner in tessellate::triangles(&surface.shape, 1).iter().flatten() {
            assert!(!corner.position.is_nan());
        }
    }
});
