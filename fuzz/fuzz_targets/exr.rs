//! Any bytes as an EXR file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::PathBuf;
use std::sync::LazyLock;
use traylib_io::{TextureLimits, load_texture};

/// A file of this process alone.
static FILE: LazyLock<PathBuf> = LazyLock::new(|| {
    let name = format!("traylib-fuzz-{}.exr", std::process::id());
    std::env::temp_dir().join(name)
});

const LIMITS: TextureLimits = TextureLimits { pixels: 1 << 18, file_bytes: 1 << 20 };

fuzz_target!(|bytes: &[u8]| {
    std::fs::write(&*FILE, bytes).expect("room for temporary files");
    let _ = load_texture(&FILE, LIMITS);
});
