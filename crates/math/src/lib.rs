//! The ground floor of `TrayLib`: vectors, colour, measures, random numbers and
//! the sampling formulas everything above is built from.
//!
//! Nothing here knows of rays, surfaces, files or threads.
//!
//! ```
//! use traylib_math::{Sampler, Vec3, warp};
//!
//! let mut sampler = Sampler::numbered(0, 0);
//! let direction = warp::cosine_hemisphere(Vec3::Z, sampler.next_2d());
//! assert!(direction.z >= 0.0);
//! ```

pub mod discrete;
pub mod fnv;
pub mod frame;
pub mod grid;
pub mod measure;
pub mod mis;
pub mod rgb;
pub mod sampler;
pub mod sobol;
pub mod warp;

pub use discrete::DiscreteDistribution;
pub use fnv::Fnv;
pub use frame::Frame;
pub use glam::{self, Vec2, Vec3};
pub use grid::Grid;
pub use measure::{AreaPdf, SolidAnglePdf, solid_angle_per_area};
pub use mis::Heuristic;
pub use rgb::Rgb;
pub use sampler::Sampler;

/// Runs the examples of the package's README as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
