//! What stands where: camera, lights, objects and the film.
//!
//! A scene is built once by [`SceneBuilder`] and is immutable afterwards. It
//! knows nothing of files, threads or algorithms. All randomness enters as
//! numbers `u`, uniform on [0, 1).

mod builder;
mod camera;
mod coincidence;
mod error;
mod film;
mod light;
mod light_id;
mod light_tree;
mod scene;
mod seat;
mod surface_point;
mod surfaces;

pub use builder::{MaterialId, Object, ObjectShape, SceneBuilder};
pub use camera::{Camera, CameraSettings, Projection};
pub use coincidence::Coincidences;
pub use error::Error;
pub use film::{Film, MergeError, PassImage};
pub use light::{Emission, Light, LightPoint, PointLight, SpotCone};
pub use light_id::LightId;
pub use scene::{LightChoice, LightDensities, MOST_PASSAGES, Scene};
pub use surface_point::{SurfacePoint, Walk};
