//! The sky in our own format, and as a Radiance picture.

use super::Files;
use super::files::vector;
use crate::relations::scene::Sky;
use traylib_math::Vec3;

/// The field of a scene file.
pub(super) fn field(sky: &Sky, files: &mut Files) -> String {
    if sky.is_even() {
        return format!("    sky: Constant(radiance: {}),\n", vector(sky.texels[0]));
    }
    let (file, turn) = (files.add("hdr", picture(sky)), sky.turn);
    format!("    sky: Picture(file: \"{file}\", turn: {turn}),\n")
}

/// Its bytes, without runs.
fn picture(sky: &Sky) -> Vec<u8> {
    let (width, height) = (sky.width, sky.texels.len() / sky.width);
    let head = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n");
    head.into_bytes().into_iter().chain(sky.texels.iter().flat_map(|&texel| rgbe(texel))).collect()
}

/// Mantissas of eight bits and an exponent.
fn rgbe(light: Vec3) -> [u8; 4] {
    let largest = light.max_element();
    if largest == 0.0 {
        return [0; 4];
    }
    let exponent = largest.log2().floor() as i32 + 1;
    let [r, g, b] = (light * (8.0 - exponent as f32).exp2()).to_array().map(|band| band as u8);
    [r, g, b, (exponent + 128) as u8]
}
