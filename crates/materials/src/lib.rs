//! Surface models and materials: how surfaces scatter light.
//!
//! A surface answers the paper's three questions: *how much* light goes from one
//! direction into another (`getF`), *pick* me a direction (`generatePath`), and
//! *how likely* were you to pick it (`getP`). [`SurfaceModel::evaluate`] answers
//! the first and third together, since they share their costly part, and
//! [`SurfaceModel::sample`] the second.
//!
//! Directions are unit vectors that leave the surface: `wo` toward where the
//! walk came from, `wi` toward where it goes next. The unit `normal` is on the
//! side of `wo`. All models are isotropic, so any orthonormal coordinates do.
//!
//! A [`Material`] is a model with what lies over it: textures, and light that
//! passes straight through.
//!
//! ```
//! use traylib_materials::{Lambert, SurfaceModel};
//! use traylib_math::{Rgb, Vec3};
//!
//! let chalk = SurfaceModel::Lambert(Lambert::new(Rgb::splat(0.8))?);
//! let scattered = chalk.evaluate(Vec3::Z, Vec3::Z, Vec3::new(0.6, 0.0, 0.8));
//! assert!((scattered.f.g - 0.8 / std::f32::consts::PI).abs() < 1e-6);
//! # Ok::<(), traylib_materials::Error>(())
//! ```

mod error;
mod lobe_choice;
mod maps;
mod material;
mod model;
mod scattering;
mod site;
mod texture;

pub use error::Error;
pub use maps::{Bump, Layer, Maps};
pub use material::{Material, Shading};
pub use model::*;
pub use scattering::{BsdfSample, Scattering};
pub use site::Site;
pub use texture::{Texture, Tiling};

/// The examples of the package are run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
