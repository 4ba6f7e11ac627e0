//! Any bytes as a scene of Mitsuba that may include itself.
#![no_main]

use libfuzzer_sys::fuzz_target;
use traylib_io::mitsuba::{Included, Limits, decode};

/// Less than a caller would allow, so that many files are tried in a second.
const LIMITS: Limits = Limits { bytes: 1 << 18, elements: 1 << 12, depth: 8, triangles: 1 << 12 };

fuzz_target!(|bytes: &[u8]| {
    let mut count = 0;
    let mut load = |_: &str| {
        count += 1;
        Ok(Included { name: count.to_string(), bytes: bytes.to_vec() })
    };
    let Ok(document) = decode("a.xml", bytes, LIMITS, &mut load) else { return };
    let all = document.objects.len();
    assert!(document.roots.iter().all(|&root| root < all));
    for object in &document.objects {
        assert!(object.children.iter().all(|child| child.object < all));
        assert!(object.place.file < document.files.len());
    }
});
