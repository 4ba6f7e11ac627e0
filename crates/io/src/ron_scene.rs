//! Our own scene files: what they may say, as plain types.
//!
//! The types *are* the grammar; `docs/scene-format.md` explains it by example.
//! Nothing is checked here beyond the form: materials are not looked up, numbers
//! may make no sense. That is the importer's part, which asks [`locate`](crate::locate) where in
//! the text a value stands.

mod camera_change;
mod context;
pub mod material;
pub(crate) mod syntax;
mod wanted;

pub use camera_change::CameraChange;
pub use material::Material;

use serde::Deserialize as Derive;
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use std::fmt;

/// A file. Lengths are metres, angles degrees, y is up.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields, rename = "Scene")]
pub struct Document {
    /// Scene files whose materials, objects and lights belong to this one.
    #[serde(default)]
    pub include: Vec<String>,
    /// The camera.
    pub camera: Option<Camera>,
    /// Factor on radiance in 8-bit pictures.
    pub exposure: Option<f32>,
    /// Samples per pixel.
    pub spp: Option<u32>,
    /// Materials by name.
    #[serde(default)]
    pub materials: Named<Material>,
    /// The objects of the scene.
    #[serde(default)]
    pub objects: Vec<Object>,
    /// Lights that are not objects.
    #[serde(default)]
    pub lights: Vec<Light>,
    /// Light from infinitely far away.
    pub sky: Option<Sky>,
}

/// A pinhole camera.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// The pinhole.
    pub position: [f32; 3],
    /// A point in the middle of the picture.
    pub target: [f32; 3],
    /// A direction that points up in the picture.
    #[serde(default = "y_axis")]
    pub up: [f32; 3],
    /// Horizontal field of view in degrees.
    pub fov: f32,
    /// Width and height in pixels.
    pub resolution: (u32, u32),
}

impl fmt::Display for Camera {
    /// As it stands in a file.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = |[x, y, z]: [f32; 3]| format!("({x}, {y}, {z})");
        let (width, height) = self.resolution;
        write!(
            f,
            "camera: (position: {}, target: {}, up: {}, fov: {}, resolution: ({width}, {height}))",
            place(self.position),
            place(self.target),
            place(self.up),
            self.fov,
        )
    }
}

fn y_axis() -> [f32; 3] {
    [0.0, 1.0, 0.0]
}

/// A shape with a material.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Object {
    /// Its form.
    pub shape: Shape,
    /// Name of its material. Only a mesh may do without.
    pub material: Option<String>,
    /// Radiance that its front emits, W/(m²·sr).
    pub emission: Option<[f32; 3]>,
    /// The sides that are there for light.
    pub sides: Option<Sides>,
}

/// The sides of a surface that are there for light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Derive)]
pub enum Sides {
    /// Both.
    Both,
    /// The front; rays that meet the back pass.
    Front,
}

/// A form in space.
#[derive(Clone, Debug, PartialEq, Derive)]
pub enum Shape {
    /// A parallelogram.
    Quad(Quad),
    /// A sphere.
    Sphere(Sphere),
    /// A disk.
    Disk(Disk),
    /// A triangle.
    Triangle(Triangle),
    /// The side of a truncated cone or a cylinder.
    Cone(Cone),
    /// Six rectangles around a room or a block.
    Box(Block),
    /// Triangles from a file.
    Mesh(Mesh),
}

/// A parallelogram. Its front is the side `edge_u` × `edge_v` points to.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Quad {
    /// A corner.
    pub corner: [f32; 3],
    /// From the corner to a neighbour.
    pub edge_u: [f32; 3],
    /// From the corner to the other neighbour.
    pub edge_v: [f32; 3],
}

/// A sphere.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Its middle.
    pub center: [f32; 3],
    /// Its radius.
    pub radius: f32,
    /// The side that is its front.
    #[serde(default)]
    pub facing: Facing,
}

/// The side that is the front of a round shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Derive)]
pub enum Facing {
    /// Outside.
    #[default]
    Outward,
    /// Inside.
    Inward,
}

/// A disk.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Disk {
    /// Its middle.
    pub center: [f32; 3],
    /// The direction its front faces; any length.
    pub normal: [f32; 3],
    /// Its radius.
    pub radius: f32,
    /// The radius of the hole in its middle.
    #[serde(default)]
    pub inner: f32,
}

/// The side of a truncated cone, without its ends.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// The ends of its axis.
    pub ends: [[f32; 3]; 2],
    /// The radius at each.
    pub radii: [f32; 2],
    /// The side that is its front.
    #[serde(default)]
    pub facing: Facing,
}

/// A triangle. Its front is the side from which a, b, c turn counter-clockwise.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Triangle {
    /// First corner.
    pub a: [f32; 3],
    /// Second corner.
    pub b: [f32; 3],
    /// Third corner.
    pub c: [f32; 3],
}

/// A block along the axes. The fronts of its six rectangles are outside.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields, rename = "Box")]
pub struct Block {
    /// The corner with the smallest coordinates.
    pub min: [f32; 3],
    /// The corner with the largest coordinates.
    pub max: [f32; 3],
}

/// Triangles from a file: scaled, then turned, then moved.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields)]
pub struct Mesh {
    /// A file of any format of shapes, relative to the scene file.
    pub file: String,
    /// Metres a unit of the file.
    #[serde(default = "one")]
    pub scale: f32,
    /// Degrees about x, then about y, then about z.
    #[serde(default)]
    pub rotate: [f32; 3],
    /// The place of the file's origin.
    #[serde(default)]
    pub translate: [f32; 3],
    /// Materials of the scene for some of the file's, by their names there.
    #[serde(default)]
    pub materials: Named<String>,
    /// Factor on what the file's materials emit: 0 for 3DS, whose light
    /// has no unit, 1 for all others.
    pub glow: Option<f32>,
    /// Factor on the lights of a 3DS or glTF file.
    #[serde(default)]
    pub lights: f32,
}

fn one() -> f32 {
    1.0
}

/// A light that is not an object.
#[derive(Clone, Debug, PartialEq, Derive)]
pub enum Light {
    /// A point that shines evenly in all directions.
    Point(PointLight),
    /// A point that shines into a cone.
    Spot(SpotLight),
}

impl Light {
    /// Its position.
    pub fn position(&self) -> [f32; 3] {
        match self {
            Self::Point(light) => light.position,
            Self::Spot(light) => light.position,
        }
    }

    /// Radiant intensity where it is full, W/sr.
    pub fn intensity(&self) -> [f32; 3] {
        match self {
            Self::Point(light) => light.intensity,
            Self::Spot(light) => light.intensity,
        }
    }
}

/// A point that shines evenly in all directions.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields, rename = "Point")]
pub struct PointLight {
    /// Its position.
    pub position: [f32; 3],
    /// Radiant intensity, W/sr.
    pub intensity: [f32; 3],
}

/// A point that shines into a cone.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields, rename = "Spot")]
pub struct SpotLight {
    /// Its position.
    pub position: [f32; 3],
    /// A point in the middle of its light.
    pub target: [f32; 3],
    /// Radiant intensity where it is full, W/sr.
    pub intensity: [f32; 3],
    /// Whole angle of the cone of full light, in degrees.
    pub full: f32,
    /// Whole angle of the cone beyond which there is none; that of full light, if
    /// none is given.
    pub dark: Option<f32>,
}

/// Light from infinitely far away, all around the scene.
#[derive(Clone, Debug, PartialEq, Derive)]
pub enum Sky {
    /// The same from everywhere.
    Constant(ConstantSky),
    /// That of a latitude-longitude picture.
    Picture(PictureSky),
}

/// A sky that is the same everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields, rename = "Constant")]
pub struct ConstantSky {
    /// Radiance, W/(m²·sr).
    pub radiance: [f32; 3],
}

/// A sky by a picture: its top row is up, its middle where −z points.
#[derive(Clone, Debug, PartialEq, Derive)]
#[serde(deny_unknown_fields, rename = "Picture")]
pub struct PictureSky {
    /// The picture, relative to the scene file.
    pub file: String,
    /// Factor on its values to be W/(m²·sr).
    #[serde(default = "one")]
    pub scale: f32,
    /// Degrees about y, as `rotate` turns a mesh.
    #[serde(default)]
    pub turn: f32,
}

/// A map from names that keeps the order of the file, and names that occur
/// twice.
#[derive(Clone, Debug, PartialEq)]
pub struct Named<T>(pub Vec<(String, T)>);

impl<T> Default for Named<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Named<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(NamedVisitor(std::marker::PhantomData))
    }
}

struct NamedVisitor<T>(std::marker::PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for NamedVisitor<T> {
    type Value = Named<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a map from names, `{ \"name\": … }`")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = map.next_entry()? {
            entries.push(entry);
        }
        Ok(Named(entries))
    }
}

/// Reads the text of a scene file.
///
/// # Errors
/// If the text is not of the form that the types describe.
pub fn decode(text: &str) -> Result<Document, ron::error::SpannedError> {
    options().from_str(text)
}

/// The options with which all of our own text is read: `Some` need not be written.
fn options() -> ron::Options {
    use ron::extensions::Extensions;
    ron::Options::default()
        .with_default_extension(Extensions::UNWRAP_VARIANT_NEWTYPES)
        .with_default_extension(Extensions::IMPLICIT_SOME)
}

#[cfg(test)]
mod tests;
