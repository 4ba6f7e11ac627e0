//! Any text as a scene file: read, built, or its errors shown with their lines.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::PathBuf;
use std::sync::LazyLock;
use traylib_io::load_scene;

/// A file of this process alone.
static FILE: LazyLock<PathBuf> = LazyLock::new(|| {
    let name = format!("traylib-fuzz-{}.ron", std::process::id());
    std::env::temp_dir().join(name)
});

fuzz_target!(|text: &str| {
    std::fs::write(&*FILE, text).expect("room for temporary files");
    if let Err(error) = load_scene(&FILE.to_string_lossy()) {
        assert!(!error.to_string().is_empty());
    }
});
