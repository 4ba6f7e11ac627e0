//! Scenes whose picture, or noise, is known in closed form, each with its
//! derivation.
//!
//! | scenes | where |
//! |---|---|
//! | A1 to A3, A5, A8, A9: direct light of points, disks, balls, squares; lobes | [`analytic`] |
//! | A4: a ball cut by the horizon | [`horizon`] |
//! | A6, A7: upright rectangles, polygons | [`polygonal`], by [`polygon`] |
//! | A10: tubes and cones | [`tubes`] |
//! | B1, B2, B4, B5: closed rooms of one radiance, lights in a ball | [`furnace`] |
//! | B3, B7: glossy rooms, rooms by their flux | [`rooms`] |
//! | B6: concentric balls | [`concentric`] |
//! | C1 to C4: light that a mirror throws | [`mirrored`] |
//! | E1 to E4: panes, sheets and glass | [`transmission`] |
//! | D1: the corner; what whole surfaces send one another | [`exchange`] |
//! | D2 to D11: geometry that hurts | [`hard`] |
//! | S1 to S3: under the sky | [`sky`] |
//! | the noise of A2 | [`variance`], measured by [`estimators`] |
//!
//! Beside them is what it takes to build such scenes ([`stage`], [`lobe`]) and to hold a
//! renderer against them: its passes one by one ([`each_pass`]) and what one costs
//! ([`cost`]).
//!
//! ```
//! use traylib_integrators::Method;
//! use traylib_known::{analytic, pass_means, settings_by_pass};
//! use traylib_statistics::mean_interval;
//!
//! // A point light over a diffuse floor: ρ/π·I·cosθ/d².
//! let case = analytic::point_light();
//! let integrator = Method::DIRECT_LIGHT.build();
//! let passes = settings_by_pass(4, 1);
//! let (means, statistics) = pass_means(&case.scene, integrator.as_ref(), &passes);
//! assert_eq!(statistics.rejected, 0);
//! let interval = mean_interval(&means, 1e-3);
//! assert!((interval.mean / case.truth - 1.0).abs() < 1e-4);
//! ```

pub mod analytic;
mod case;
pub mod concentric;
pub mod cost;
pub mod estimators;
pub mod exchange;
pub mod frame;
pub mod furnace;
pub mod grid;
pub mod hard;
pub mod horizon;
pub mod lobe;
pub mod mirrored;
mod passes;
pub mod polygon;
pub mod polygonal;
pub mod rooms;
pub mod sky;
pub mod stage;
pub mod transmission;
pub mod tubes;
pub mod variance;

pub use case::{Case, mean_over_film, mean_over_floor};
pub use passes::{SAMPLER_VARIABLE, each_pass, pass_means, samples_in_a_pass, settings_by_pass};

/// Runs the examples of the package's README as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
