//! The JSON text as plain types: what is read of it, and no more.

use super::Error;
use serde::Deserialize as Derive;
use serde::de::IgnoredAny;
use std::collections::BTreeMap;

/// Reads the text.
pub(super) fn read(json: &[u8]) -> Result<Root, Error> {
    let root: Root = serde_json::from_slice(json).map_err(|error| {
        // What is wrong in another version is not what is wrong with it.
        if let Ok(Head { asset }) = serde_json::from_slice::<Head>(json)
            && !asset.version.starts_with('2')
        {
            return Error::Version(crate::suggest::shown(&asset.version));
        }
        let (line, column) = (error.line(), error.column());
        let what = error.to_string();
        let end = what.rfind(" at line ").unwrap_or(what.len());
        Error::Json { line, column, what: crate::suggest::shown(&what[..end]) }
    })?;
    let is_two = root.asset.version.split('.').next() == Some("2");
    if is_two { Ok(root) } else { Err(Error::Version(crate::suggest::shown(&root.asset.version))) }
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct Root {
    pub(super) asset: Asset,
    pub(super) scene: Option<u64>,
    #[serde(default)]
    pub(super) scenes: Vec<Scene>,
    #[serde(default)]
    pub(super) nodes: Vec<Node>,
    #[serde(default)]
    pub(super) meshes: Vec<Mesh>,
    #[serde(default)]
    pub(super) accessors: Vec<Accessor>,
    #[serde(default)]
    pub(super) buffer_views: Vec<BufferView>,
    #[serde(default)]
    pub(super) buffers: Vec<Buffer>,
    #[serde(default)]
    pub(super) materials: Vec<Material>,
    #[serde(default)]
    pub(super) textures: Vec<Texture>,
    #[serde(default)]
    pub(super) samplers: Vec<Sampler>,
    #[serde(default)]
    pub(super) images: Vec<Image>,
    #[serde(default)]
    pub(super) cameras: Vec<Camera>,
    #[serde(default)]
    pub(super) animations: Vec<IgnoredAny>,
    #[serde(default)]
    pub(super) extensions_used: Vec<String>,
    #[serde(default)]
    pub(super) extensions_required: Vec<String>,
    #[serde(default)]
    pub(super) extensions: RootExtensions,
}

/// The fields that every version has.
#[derive(Debug, Derive)]
struct Head {
    asset: Asset,
}

#[derive(Debug, Derive)]
pub(super) struct Asset {
    pub(super) version: String,
}

#[derive(Debug, Default, Derive)]
pub(super) struct RootExtensions {
    #[serde(default, rename = "KHR_lights_punctual")]
    pub(super) lights: Lights,
}

#[derive(Debug, Default, Derive)]
pub(super) struct Lights {
    #[serde(default)]
    pub(super) lights: Vec<Light>,
}

#[derive(Debug, Derive)]
pub(super) struct Light {
    #[serde(rename = "type")]
    pub(super) kind: String,
    #[serde(default = "white")]
    pub(super) color: [f32; 3],
    #[serde(default = "one")]
    pub(super) intensity: f32,
    pub(super) range: Option<f32>,
    pub(super) spot: Option<Spot>,
}

#[derive(Debug, Default, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct Spot {
    #[serde(default)]
    pub(super) inner_cone_angle: f32,
    pub(super) outer_cone_angle: Option<f32>,
}

#[derive(Debug, Derive)]
pub(super) struct Scene {
    #[serde(default)]
    pub(super) nodes: Vec<u64>,
}

#[derive(Debug, Derive)]
pub(super) struct Node {
    #[serde(default)]
    pub(super) children: Vec<u64>,
    pub(super) mesh: Option<u64>,
    pub(super) camera: Option<u64>,
    pub(super) skin: Option<u64>,
    pub(super) matrix: Option<[f64; 16]>,
    pub(super) translation: Option<[f64; 3]>,
    pub(super) rotation: Option<[f64; 4]>,
    pub(super) scale: Option<[f64; 3]>,
    #[serde(default)]
    pub(super) extensions: NodeExtensions,
}

#[derive(Debug, Default, Derive)]
pub(super) struct NodeExtensions {
    #[serde(rename = "KHR_lights_punctual")]
    pub(super) light: Option<NodeLight>,
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub(super) instancing: Option<Instancing>,
}

/// Arrays of places in which the node's mesh stands.
#[derive(Debug, Derive)]
pub(super) struct Instancing {
    pub(super) attributes: BTreeMap<String, u64>,
}

#[derive(Debug, Derive)]
pub(super) struct NodeLight {
    pub(super) light: u64,
}

#[derive(Debug, Derive)]
pub(super) struct Mesh {
    pub(super) primitives: Vec<Primitive>,
}

#[derive(Debug, Derive)]
pub(super) struct Primitive {
    pub(super) attributes: BTreeMap<String, u64>,
    pub(super) indices: Option<u64>,
    pub(super) material: Option<u64>,
    #[serde(default = "triangles")]
    pub(super) mode: u64,
    #[serde(default)]
    pub(super) targets: Vec<IgnoredAny>,
}

fn triangles() -> u64 {
    4
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<u64>,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) component_type: u64,
    #[serde(default)]
    pub(super) normalized: bool,
    pub(super) count: u64,
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) sparse: Option<Sparse>,
}

#[derive(Debug, Derive)]
pub(super) struct Sparse {
    pub(super) count: u64,
    pub(super) indices: SparsePart,
    pub(super) values: SparsePart,
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparsePart {
    pub(super) buffer_view: u64,
    #[serde(default)]
    pub(super) byte_offset: u64,
    /// The type of indices; values have that of the accessor.
    #[serde(default)]
    pub(super) component_type: u64,
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: u64,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) byte_length: u64,
    pub(super) byte_stride: Option<u64>,
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct Buffer {
    pub(super) uri: Option<String>,
    pub(super) byte_length: u64,
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct Material {
    #[serde(default)]
    pub(super) name: String,
    #[serde(default)]
    pub(super) pbr_metallic_roughness: MetallicRoughness,
    pub(super) normal_texture: Option<IgnoredAny>,
    pub(super) occlusion_texture: Option<IgnoredAny>,
    pub(super) emissive_texture: Option<IgnoredAny>,
    #[serde(default)]
    pub(super) emissive_factor: [f32; 3],
    #[serde(default)]
    pub(super) alpha_mode: AlphaMode,
    #[serde(default = "half")]
    pub(super) alpha_cutoff: f32,
    #[serde(default)]
    pub(super) double_sided: bool,
    #[serde(default)]
    pub(super) extensions: MaterialExtensions,
}

fn half() -> f32 {
    0.5
}

/// The meaning of alpha.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Derive)]
#[serde(rename_all = "UPPERCASE")]
pub enum AlphaMode {
    /// Alpha means nothing.
    #[default]
    Opaque,
    /// All is there or nothing.
    Mask,
    /// As much of the surface is there as alpha says.
    Blend,
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct MetallicRoughness {
    #[serde(default = "opaque_white")]
    pub(super) base_color_factor: [f32; 4],
    pub(super) base_color_texture: Option<TextureInfo>,
    #[serde(default = "one")]
    pub(super) metallic_factor: f32,
    #[serde(default = "one")]
    pub(super) roughness_factor: f32,
    #[serde(rename = "metallicRoughnessTexture")]
    pub(super) picture: Option<TextureInfo>,
}

impl Default for MetallicRoughness {
    fn default() -> Self {
        Self {
            base_color_factor: opaque_white(),
            base_color_texture: None,
            metallic_factor: 1.0,
            roughness_factor: 1.0,
            picture: None,
        }
    }
}

fn one() -> f32 {
    1.0
}

fn white() -> [f32; 3] {
    [1.0; 3]
}

fn opaque_white() -> [f32; 4] {
    [1.0; 4]
}

#[derive(Debug, Default, Derive)]
pub(super) struct MaterialExtensions {
    #[serde(default, rename = "KHR_materials_emissive_strength")]
    pub(super) emissive_strength: EmissiveStrength,
    #[serde(rename = "KHR_materials_unlit")]
    pub(super) unlit: Option<IgnoredAny>,
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct EmissiveStrength {
    #[serde(default = "one")]
    pub(super) emissive_strength: f32,
}

impl Default for EmissiveStrength {
    fn default() -> Self {
        Self { emissive_strength: 1.0 }
    }
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct TextureInfo {
    pub(super) index: u64,
    #[serde(default)]
    pub(super) tex_coord: u32,
    #[serde(default)]
    pub(super) extensions: TextureExtensions,
}

#[derive(Debug, Default, Derive)]
pub(super) struct TextureExtensions {
    #[serde(rename = "KHR_texture_transform")]
    pub(super) transform: Option<TextureTransform>,
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct TextureTransform {
    #[serde(default)]
    pub(super) offset: [f32; 2],
    #[serde(default)]
    pub(super) rotation: f32,
    #[serde(default = "ones")]
    pub(super) scale: [f32; 2],
    pub(super) tex_coord: Option<u32>,
}

fn ones() -> [f32; 2] {
    [1.0; 2]
}

#[derive(Debug, Derive)]
pub(super) struct Texture {
    pub(super) sampler: Option<u64>,
    pub(super) source: Option<u64>,
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct Sampler {
    #[serde(default = "repeat")]
    pub(super) wrap_s: u64,
    #[serde(default = "repeat")]
    pub(super) wrap_t: u64,
}

fn repeat() -> u64 {
    10497
}

/// The values beyond the edges of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrap {
    /// Its edge goes on.
    Clamp,
    /// The picture again, every other time mirrored.
    Mirror,
    /// The picture again.
    Repeat,
}

impl Wrap {
    pub(super) fn of(number: u64) -> Self {
        match number {
            33071 => Self::Clamp,
            33648 => Self::Mirror,
            _ => Self::Repeat,
        }
    }
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct Image {
    pub(super) uri: Option<String>,
    pub(super) buffer_view: Option<u64>,
}

#[derive(Debug, Derive)]
pub(super) struct Camera {
    pub(super) perspective: Option<Perspective>,
}

#[derive(Debug, Derive)]
#[serde(rename_all = "camelCase")]
pub(super) struct Perspective {
    pub(super) yfov: f32,
    pub(super) aspect_ratio: Option<f32>,
}
