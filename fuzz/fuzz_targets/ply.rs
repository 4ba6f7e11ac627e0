//! Any bytes as a PLY file.
#![no_main]

use libfuzzer_sys::fuzz_target;
use traylib_io::ply::{Limits, decode};

fuzz_target!(|bytes: &[u8]| {
    let Ok(document) = decode(bytes, Limits::default()) else { return };
    let corners = document.faces().flat_map(|(_, corners)| corners);
    assert!(corners.into_iter().all(|&corner| (corner as usize) < document.positions.len()));
    assert!(document.positions.iter().all(|position| position.is_finite()));
});
