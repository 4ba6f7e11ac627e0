//! Any bytes as a picture of any format but EXR.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::Path;
use traylib_io::{TextureLimits, texture_from_bytes};

/// Less than a caller would allow, so that many files are tried in a second.
const LIMITS: TextureLimits = TextureLimits { pixels: 1 << 18, file_bytes: 1 << 20 };

fuzz_target!(|bytes: &[u8]| {
    // Without a sign of its own it is a TGA file.
    if let Ok(found) = texture_from_bytes(bytes, Path::new("x.tga"), LIMITS) {
        let count = found.pixels.values().len();
        assert!(count > 0 && count as u64 <= LIMITS.pixels);
        assert!(found.alpha.is_none_or(|alpha| alpha.values().len() == count));
    }
});
