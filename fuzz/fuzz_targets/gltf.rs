//! Any bytes as a glTF file, as text or binary, whose buffers are within it.
#![no_main]

use libfuzzer_sys::fuzz_target;
use traylib_io::gltf::{Limits, decode};

/// Less than a caller would allow, so that many files are tried in a second.
const LIMITS: Limits = Limits { bytes: 1 << 20, triangles: 1 << 16, items: 1 << 12 };

fuzz_target!(|bytes: &[u8]| {
    let mut load = |_: &str| Err("none".to_string());
    let Ok(document) = decode(bytes, LIMITS, &mut load) else { return };
    for primitive in &document.primitives {
        let count = primitive.positions.len();
        assert!(primitive.triangles.iter().flatten().all(|&corner| (corner as usize) < count));
        assert!(primitive.positions.iter().all(|position| position.is_finite()));
    }
    assert!(document.instances.iter().all(|instance| instance.place.is_finite()));
});
