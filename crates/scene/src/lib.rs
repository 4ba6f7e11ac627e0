//! Scenes and what they are seen by: objects, lights, camera and film.
//!
//! A scene is built once by [`SceneBuilder`] and is immutable afterwards. It
//! knows nothing of files, threads or algorithms. All randomness enters as
//! numbers `u`, uniform on [0, 1).
//!
//! ```
//! use traylib_geometry::{Primitive, Quad, Ray, Sides, Vec3};
//! use traylib_materials::{Lambert, SurfaceModel};
//! use traylib_math::Rgb;
//! use traylib_scene::{Camera, CameraSettings, Object, ObjectShape, SceneBuilder};
//!
//! let camera = Camera::new(CameraSettings {
//!     position: Vec3::new(0.0, 1.0, 4.0),
//!     target: Vec3::Y,
//!     up: Vec3::Y,
//!     fov_degrees: 45.0,
//!     width: 64,
//!     height: 48,
//! })?;
//! let mut builder = SceneBuilder::new(camera);
//! let white = builder.add_material(SurfaceModel::Lambert(Lambert::new(Rgb::splat(0.7))?));
//! // A lamp of one square metre, three metres above; its front is where X × Z points.
//! let lamp = Quad::new(Vec3::new(-0.5, 3.0, -0.5), Vec3::X, Vec3::Z)?;
//! builder.add_object(Object {
//!     shape: ObjectShape::Primitive(Primitive::Quad(lamp)),
//!     sides: Sides::Both,
//!     material: white,
//!     emission: Rgb::splat(8.0),
//! })?;
//! let scene = builder.build()?;
//!
//! let point = scene.intersect(&Ray::new(Vec3::ZERO, Vec3::Y)).expect("the lamp hangs there");
//! assert_eq!((point.site.position.y, scene.emitted(&point).g), (3.0, 8.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod builder;
mod camera;
mod coincidence;
mod error;
mod film;
mod images;
mod light;
mod light_choice;
mod light_id;
mod light_tree;
mod point_images;
mod scene;
mod seat;
mod surface_point;
mod surfaces;

pub use builder::{MaterialId, Object, SceneBuilder};
pub use camera::{Camera, CameraSettings, FilmWindow, Projection};
pub use coincidence::Coincidences;
pub use error::Error;
pub use film::{Film, FilmBlock, FilmSquares, MergeError, PassImage};
pub use images::ImageDirections;
pub use light::{Emission, Light, LightPoint, PointLight, Sky, SpotCone};
pub use light_id::LightId;
pub use point_images::PointImage;
pub use scene::{Detail, LightChoice, LightDensities, MAX_PASS_THROUGHS, Scene};
pub use surface_point::{SurfacePoint, Walk};
pub use surfaces::ObjectShape;

/// The examples of the package are run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
