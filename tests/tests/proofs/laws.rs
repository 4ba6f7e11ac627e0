//! Laws of single parts: what is drawn follows its stated density, no light is
//! created, light goes both ways alike, and the camera is where it says.
//!
//! Chi-square tests, frequencies and known means are a family each, with one
//! false alarm in a thousand runs; the fast forms draw 10⁵ samples a test and the
//! long ones 10⁶ or more.

mod camera;
mod kernel;
mod lamps;
mod lengths;
mod masks;
mod numbers;
mod scattering;

use traylib_geometry::Vec3;
use traylib_math::Sampler;

/// Samples of one test in `cargo test`.
const FAST: u64 = 100_000;
/// Samples of one test at length.
const LONG: u64 = 4_000_000;

/// A stream of its own for each claim.
fn sampler(claim: &str) -> Sampler {
    // The offset and prime of 64-bit FNV-1a.
    let index = claim.bytes().fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
    });
    Sampler::numbered(3, index)
}

/// The unit vector at this angle from the third axis.
fn tilted(degrees: f32) -> Vec3 {
    let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
    let (across, aside) = 0.7_f64.sin_cos();
    Vec3::new((sin * aside) as f32, (sin * across) as f32, cos as f32)
}
