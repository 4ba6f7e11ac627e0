//! Decoder of 3D Studio files (`.3ds`, releases 3 and 4).
//!
//! Bytes become a [`Document`]: meshes, materials with their maps, lights,
//! cameras and the keyframer, all as stored. Vertices are in world space
//! already; the local axes of a mesh are not applied, and [`pose`] tells where
//! the keyframer would have the meshes. The file has no unit; z is up and the
//! front of a face is the side from which its corners turn counter-clockwise.
//!
//! Not read: fog, background, shadow defaults, viewports, procedural data. What
//! is damaged is skipped or repaired, and counted in [`Warnings`].
//!
//! Sources: the chunk layout as published with lib3ds 1.3 and 2.0.

mod affine;
mod camera;
mod chunk;
mod colour;
mod counts;
mod decoder;
pub mod keyframer;
mod light;
mod limits;
mod map;
mod material;
mod mesh;
mod motion;
mod names;
mod object;
pub mod pose;
mod raw_mesh;
pub mod smoothing;
mod warning;
mod wide;

pub use affine::Affine;
pub use camera::Camera;
pub use counts::{Counts, PoseCounts};
pub use keyframer::Keyframer;
pub use light::{Light, Shadow, Spot};
pub use limits::Limits;
pub use map::{Map, MapKind};
pub use material::{Material, MaterialFlags, Shading};
pub use mesh::{Face, Mesh};
pub use motion::Motion;
pub use object::ObjectFlags;
pub use warning::{WarningKind, Warnings};

use chunk::Reader;
use decoder::Decoder;
use traylib_math::Rgb;

/// The contents of a 3DS file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Version of the file; 3 is usual.
    pub version: Option<u32>,
    /// Version of the mesh section.
    pub mesh_version: Option<u32>,
    /// Displayed size of a unit. Vertices are not multiplied by it.
    pub master_scale: Option<f32>,
    /// Ambient light, coded for a screen. It means nothing where light is
    /// computed.
    pub ambient: Option<Rgb>,
    /// Every mesh in file order, also those without a face that can be drawn.
    pub meshes: Vec<Mesh>,
    /// The materials in file order. Names may repeat; the first one counts.
    pub materials: Vec<Material>,
    /// The lights in file order.
    pub lights: Vec<Light>,
    /// The cameras in file order.
    pub cameras: Vec<Camera>,
    /// The animation part, if there is one.
    pub keyframer: Option<Keyframer>,
    /// The warnings: what was skipped or repaired.
    pub warnings: Warnings,
}

/// The reason why bytes are not a 3DS file. Damage further inside is a warning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Shorter than the six bytes of a chunk header.
    #[error("ends after {0} bytes, a 3DS file has at least 6")]
    TooShort(usize),
    /// Longer than [`Limits::bytes`].
    #[error("has more than {0} bytes; {more}", more = crate::Limit::Bytes.remedy(*.0 as u64))]
    TooLong(usize),
    /// The first chunk is not one a 3DS file begins with.
    #[error("it is no 3DS file: it begins with chunk {0:#06x}, not with 0x4d4d, 0x3daa or 0xc23d")]
    NotThreeDs(u16),
}

const ROOTS: [u16; 3] = [0x4d4d, 0x3daa, 0xc23d];

/// Decodes a file.
///
/// Memory stays within a fixed multiple of the size of `bytes`.
///
/// # Errors
/// If the bytes do not begin as a 3DS file does.
pub fn decode(bytes: &[u8]) -> Result<Document, Error> {
    decode_within(bytes, Limits::default())
}

/// [`decode`] with limits of one's own.
///
/// # Errors
/// As `decode`.
pub fn decode_within(bytes: &[u8], limits: Limits) -> Result<Document, Error> {
    if bytes.len() > limits.bytes {
        return Err(Error::TooLong(limits.bytes));
    }
    let mut warnings = Warnings::default();
    let (id, root) =
        Reader::new(bytes).next_chunk(&mut warnings).ok_or(Error::TooShort(bytes.len()))?;
    if !ROOTS.contains(&id) {
        return Err(Error::NotThreeDs(id));
    }
    let mut decoder = Decoder::new(warnings, limits);
    decoder.section(root);
    Ok(decoder.finish())
}

#[cfg(test)]
mod tests;
