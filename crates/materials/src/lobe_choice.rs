//! The choice of the part of a surface that is sampled.

use traylib_math::Rgb;

/// The chance to sample the specular part, by luminance; zero for a black
/// surface.
///
/// It depends on no direction, so a walk from the other end finds the same.
pub(crate) fn specular_chance(diffuse: Rgb, specular: Rgb) -> f32 {
    let (d, s) = (diffuse.luminance(), specular.luminance());
    if s > 0.0 { s / (s + d) } else { 0.0 }
}
