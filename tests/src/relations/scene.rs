//! A scene as plain data: small enough to be changed, written and made smaller.

mod facts;
mod material;
mod shape;
mod sky;

pub use material::{Base, BumpMap, Coding, Lobes, Map, Material, Picture, Tiling};
pub use shape::{Mesh, Shape, sides_of_box};
pub use sky::Sky;

use traylib_geometry::Sides;
use traylib_math::Vec3;

/// A scene. Lengths are metres, angles degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnScene {
    /// The camera.
    pub camera: Camera,
    /// The objects of the scene.
    pub objects: Vec<Object>,
    /// Lights that are not objects.
    pub lights: Vec<Light>,
    /// Light from infinitely far away.
    pub sky: Option<Sky>,
    /// The longest path in edges.
    pub max_depth: Option<u32>,
}

/// A pinhole camera with a square film.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The pinhole.
    pub position: Vec3,
    /// A point in the middle of the picture.
    pub target: Vec3,
    /// A direction that points up in the picture.
    pub up: Vec3,
    /// Angle of view, from edge to edge.
    pub fov: f32,
    /// Width and height in pixels.
    pub pixels: u32,
}

/// A surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its form.
    pub shape: Shape,
    /// The material that it is made of.
    pub material: Material,
    /// Radiance of its front in W/(m²·sr).
    pub emission: Vec3,
    /// The sides that are there for light.
    pub sides: Sides,
}

/// A point that shines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// The position.
    pub position: Vec3,
    /// W/sr, where it is full.
    pub intensity: Vec3,
    /// Its cone; `None` if it shines in all directions alike.
    pub spot: Option<Spot>,
}

/// The cone of a spot light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// A point in the middle of its light.
    pub target: Vec3,
    /// Whole angle of full light.
    pub full: f32,
    /// Whole angle beyond which there is none.
    pub dark: f32,
}

impl Object {
    /// Tells whether it emits light.
    pub fn is_light(&self) -> bool {
        self.emission != Vec3::ZERO
    }

    /// Returns the surface with another shape.
    #[must_use]
    pub fn with_shape(&self, shape: Shape) -> Self {
        Self { shape, ..self.clone() }
    }
}

/// Rec. 709 luminance.
pub fn luminance(rgb: Vec3) -> f32 {
    rgb.dot(Vec3::new(0.2126, 0.7152, 0.0722))
}
