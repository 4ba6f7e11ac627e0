//! Decoder of glTF 2.0 (`.gltf`, `.glb`).
//!
//! Bytes become a [`Document`]: meshes of triangles, every place where one stands, materials,
//! lights and cameras with their places, pictures. Lengths are metres, y is up; the front of a
//! triangle is the side from which its corners turn counter-clockwise.
//!
//! Read are the scene that the file shows, nodes with transforms, accessors of any type, also
//! sparse and quantized, strips and fans, and of the extensions `EXT_mesh_gpu_instancing`,
//! `KHR_lights_punctual`,
//! `KHR_materials_emissive_strength`, `KHR_materials_unlit`, `KHR_mesh_quantization` and
//! `KHR_texture_transform`. Not read, and counted in [`Document::warnings`]: animations, skins,
//! morph targets, colours of vertices, points and lines, further scenes, other extensions. An
//! extension without which shapes cannot be known is an error.
//!
//! Source: *glTF 2.0 Specification*, Khronos Group, 2021, and its extensions.

mod accessor;
mod budget;
mod buffers;
mod builder;
mod container;
mod error;
mod extensions;
mod fixture;
mod instancing;
mod json;
mod material;
mod nodes;
mod primitive;
mod warning;

pub use error::{Cause, Error};
pub use json::{AlphaMode, Wrap};
pub use warning::WarningKind;

use crate::warning_counts::WarningCounts;
use traylib_math::glam::{Affine2, DAffine3};
use traylib_math::{Rgb, Vec2, Vec3};

/// Bounds on what is taken in of a file. What exceeds it is an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The most bytes of a file with its buffers.
    pub bytes: usize,
    /// The most triangles, counted anew in every place, and the most vertices.
    pub triangles: u64,
    /// The most nodes, materials, pictures and the like of a kind.
    pub items: usize,
}

impl Default for Limits {
    /// 2²⁸ bytes, 2²⁴ triangles, 2¹⁷ items.
    fn default() -> Self {
        Self { bytes: 1 << 28, triangles: 1 << 24, items: 1 << 17 }
    }
}

/// The contents of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Pieces of meshes, each with one material.
    pub primitives: Vec<Primitive>,
    /// The instances of meshes in the scene.
    pub instances: Vec<Instance>,
    /// The materials.
    pub materials: Vec<Material>,
    /// The pictures.
    pub images: Vec<Image>,
    /// The lights in the scene.
    pub lights: Vec<Light>,
    /// The cameras in the scene.
    pub cameras: Vec<Camera>,
    /// The warnings: what was skipped or repaired.
    pub warnings: WarningCounts<WarningKind>,
}

/// Triangles with one material, in their own space.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Primitive {
    /// Index of its material.
    pub material: Option<usize>,
    /// The positions of vertices.
    pub positions: Vec<Vec3>,
    /// Normals, one for each position or none at all.
    pub normals: Vec<Vec3>,
    /// Texture coordinates of the set that the material's pictures want, one for each
    /// position or none at all. v goes down from the top of a picture.
    pub uvs: Vec<Vec2>,
    /// Corners, by numbers of positions.
    pub triangles: Vec<[u32; 3]>,
}

/// A primitive in one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instance {
    /// Index of the primitive.
    pub primitive: usize,
    /// From its space to that of the scene.
    pub place: DAffine3,
}

/// A material of metal and roughness.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name; may be empty.
    pub name: String,
    /// Colour, linear.
    pub base_colour: Rgb,
    /// The part of the surface that is there, from 0 to 1.
    pub alpha: f32,
    /// From 0, a dielectric, to 1, a metal.
    pub metallic: f32,
    /// From 0, a mirror, to 1.
    pub roughness: f32,
    /// Radiance.
    pub emission: Rgb,
    /// True if its light is the same from everywhere.
    pub is_unlit: bool,
    /// The meaning of alpha.
    pub alpha_mode: AlphaMode,
    /// From which alpha on it is there, where all is or is not.
    pub alpha_cutoff: f32,
    /// True if its back is there.
    pub double_sided: bool,
    /// The picture that colour and alpha are multiplied with.
    pub base_colour_picture: Option<Picture>,
    /// The picture of which green multiplies roughness, and blue metal.
    pub metallic_roughness_picture: Option<Picture>,
    /// True for each of the pictures of normals, of occlusion and of emission that it has.
    pub has_normal_occlusion_emission: [bool; 3],
}

/// A picture on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picture {
    /// Index of the image; `None` of a picture in a format that an extension brings.
    pub image: Option<usize>,
    /// The set of texture coordinates.
    pub set: u32,
    /// The map that is applied to these coordinates.
    pub transform: Affine2,
    /// The values beyond the edges of the picture, along u and along v.
    pub wrap: [Wrap; 2],
}

/// An image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Image {
    /// A file of this name.
    File(String),
    /// The bytes of one.
    Bytes(Vec<u8>),
    /// None that can be read, and why.
    Missing(String),
}

/// A light that is no surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// The position.
    pub position: Vec3,
    /// The direction in which it shines, of any length.
    pub direction: Vec3,
    /// Candela, in colour.
    pub intensity: Rgb,
    /// Half the angle within which a spot light is full, and of that beyond which there is none.
    pub cone: Option<[f32; 2]>,
}

/// A camera with perspective.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The position.
    pub position: Vec3,
    /// The viewing direction.
    pub direction: Vec3,
    /// The direction that is up in the picture.
    pub up: Vec3,
    /// The vertical angle of view, in radians.
    pub yfov: f32,
    /// Width by height of the picture that it is made for.
    pub aspect: Option<f32>,
}

/// Decodes a file. `load` brings the buffer of a name that the file has beside it, or says why
/// it does not.
///
/// Memory stays within a fixed multiple of the bytes of the file and its buffers, and of
/// [`Limits::triangles`].
///
/// # Errors
/// The bytes are no glTF, or what is read of it makes no sense or asks for too much: the
/// first such fault, with its place.
pub fn decode(
    bytes: &[u8],
    limits: Limits,
    load: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
) -> Result<Document, Error> {
    if bytes.len() > limits.bytes {
        return Err(Error::TooLong(limits.bytes));
    }
    let container::Parts { json, binary } = container::parts(bytes)?;
    let root = json::read(json)?;
    builder::build(&root, binary, limits, load)
}

#[cfg(test)]
mod tests;
