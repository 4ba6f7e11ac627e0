//! Materials in scene files.

use serde::Deserialize as Derive;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use std::fmt;

/// The materials of scene files: how a surface scatters light. Reflectances are in 0..1.
#[derive(Clone, Debug, PartialEq, Derive)]
pub enum Material {
    /// Ideal diffuse.
    Lambert(Lambert),
    /// Modified Phong.
    Phong(Phong),
    /// Max-Phong, a metal.
    MaxPhong(MaxPhong),
    /// Ideal mirror.
    Mirror(Mirror),
    /// Thin, and scattering light to both sides.
    Sheet(Sheet),
    /// The boundary of a clear solid.
    Glass(Glass),
    /// Thin clear glass.
    Pane(Pane),
    /// Another material that part of the light passes straight.
    Gauze(Gauze),
    /// Another material with pictures on it.
    Textured(Box<Textured>),
}

/// Ideal diffuse.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Lambert {
    /// Part of the light reflected.
    pub reflectance: [f32; 3],
}

/// Modified Phong.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Phong {
    /// kd.
    pub diffuse: [f32; 3],
    /// ks.
    pub specular: [f32; 3],
    /// n.
    pub exponent: f32,
}

/// Max-Phong, a metal.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct MaxPhong {
    /// ks.
    pub specular: [f32; 3],
    /// n.
    pub exponent: f32,
}

/// Ideal mirror.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Mirror {
    /// Part of the light mirrored.
    pub reflectance: [f32; 3],
    /// Part of the light reflected diffusely.
    #[serde(default)]
    pub diffuse: [f32; 3],
}

/// A lobe and a diffuse part, as of a Phong surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Lobes {
    /// kd.
    #[serde(default)]
    pub diffuse: [f32; 3],
    /// ks.
    #[serde(default)]
    pub specular: [f32; 3],
    /// n.
    #[serde(default = "broadest")]
    pub exponent: f32,
}

fn broadest() -> f32 {
    1.0
}

/// A sheet that scatters light to both of its sides.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Sheet {
    /// Light thrown back.
    #[serde(default)]
    pub reflection: Lobes,
    /// Light let through.
    pub transmission: Lobes,
}

/// The boundary of clear glass.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Glass {
    /// Index of refraction.
    pub index: f32,
}

/// A thin pane of clear glass.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Pane {
    /// Part of the light mirrored.
    pub reflectance: [f32; 3],
    /// Part of the light that goes straight on.
    pub through: [f32; 3],
}

/// A material that part of the light passes straight.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Gauze {
    /// The material that scatters the rest.
    pub base: Box<Material>,
    /// Part of the light that goes straight on.
    pub through: [f32; 3],
}

/// A material with pictures on it.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Textured {
    /// The material where no picture says otherwise.
    pub base: Box<Material>,
    /// Diffuse part.
    pub diffuse: Option<Texture>,
    /// Specular part.
    pub specular: Option<Texture>,
    /// The part of the surface that is there.
    pub opacity: Option<Texture>,
    /// The height over the surface.
    pub bump: Option<BumpMap>,
}

/// A picture on a surface: `"wood.png"` alone, or with how it lies there.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The picture's file, relative to the scene file.
    pub file: String,
    /// The way it lies on the surface.
    pub lay: Lay,
    /// From 0, as if it were not there, to 1.
    pub strength: f32,
}

/// A picture whose brightness is height.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(from = "BumpMapFields")]
pub struct BumpMap {
    /// The picture's file, relative to the scene file.
    pub file: String,
    /// The way it lies on the surface.
    pub lay: Lay,
    /// Height of white over black, in lengths of a unit of u.
    pub height: f32,
}

/// The way a picture lies on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lay {
    /// The values beyond its edges.
    pub tiling: Tiling,
    /// The number of times that it fits along u and along v.
    pub scale: [f32; 2],
    /// In place of the scale, (a, b, c, d, x, y): u and v of the surface are a·u + c·v + x and
    /// b·u + d·v + y of the picture.
    pub matrix: Option<[f32; 6]>,
}

/// The values beyond the edges of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Derive)]
pub enum Tiling {
    /// The picture again.
    #[default]
    Repeat,
    /// The picture again, every other time mirrored.
    Mirror,
    /// Nothing.
    Once,
}

#[derive(Derive)]
#[serde(deny_unknown_fields, rename = "Texture")]
struct TextureFields {
    file: String,
    #[serde(default)]
    tiling: Tiling,
    #[serde(default = "once")]
    scale: [f32; 2],
    matrix: Option<[f32; 6]>,
    #[serde(default = "fully")]
    strength: f32,
}

// Scene files that write the name of the struct write `Relief`.
#[derive(Derive)]
#[serde(deny_unknown_fields, rename = "Relief")]
struct BumpMapFields {
    file: String,
    #[serde(default)]
    tiling: Tiling,
    #[serde(default = "once")]
    scale: [f32; 2],
    matrix: Option<[f32; 6]>,
    height: f32,
}

fn once() -> [f32; 2] {
    [1.0; 2]
}

fn fully() -> f32 {
    1.0
}

impl From<BumpMapFields> for BumpMap {
    fn from(BumpMapFields { file, tiling, scale, matrix, height }: BumpMapFields) -> Self {
        Self { file, lay: Lay { tiling, scale, matrix }, height }
    }
}

impl From<TextureFields> for Texture {
    fn from(TextureFields { file, tiling, scale, matrix, strength }: TextureFields) -> Self {
        Self { file, lay: Lay { tiling, scale, matrix }, strength }
    }
}

impl<'de> Deserialize<'de> for Texture {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TextureVisitor)
    }
}

struct TextureVisitor;

impl<'de> Visitor<'de> for TextureVisitor {
    type Value = Texture;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a picture in quotes, or `(file: \"…\", …)`")
    }

    fn visit_str<E>(self, file: &str) -> Result<Texture, E> {
        let (file, tiling, scale) = (file.to_string(), Tiling::Repeat, once());
        Ok(Texture::from(TextureFields { file, tiling, scale, matrix: None, strength: 1.0 }))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Texture, A::Error> {
        TextureFields::deserialize(MapAccessDeserializer::new(map)).map(Texture::from)
    }
}
