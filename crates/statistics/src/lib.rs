//! Statistics of plain numbers, with stated error rates: intervals for means and variances,
//! tests of one mean against another and of counts against a law, levels of many tests at
//! once, the tail of a law, and how far one picture is from another.
//!
//! Numbers go in and verdicts come out. Nothing here knows what they were measured from,
//! reads a clock or a file, or draws a random number of its own.
//!
//! | to ask | use |
//! |---|---|
//! | where the mean of a law lies | [`mean_interval`], [`bootstrap`] for few and skewed values |
//! | where its variance lies | [`Moments`] |
//! | whether two means are the same | [`welch()`] |
//! | what the ratio of two means is, how two estimates are best averaged | [`ratio_of_means`], [`inverse_variance_weight`] |
//! | whether counts follow a law | [`chi_square`], [`binomial`], [`uniformity()`] |
//! | at which level each of many tests is held | [`sidak`], [`holm`] |
//! | whether a law has a variance at all | [`tail`], [`PowerSums`], [`Energy`], [`shortfall()`] |
//! | how fast an error falls | [`slope`] |
//! | how far a picture is from another | [`PictureError`] |
//!
//! Values have to be independent. What a renderer's passes give are; samples of one pass are
//! not, once a path adds to several pixels.
//!
//! ```
//! use traylib_statistics::{Sample, holm, welch};
//!
//! // Four places of two pictures, some passes of each: do they show the same?
//! let first = [[1.02, 0.97, 1.01], [2.00, 2.05, 1.96], [0.49, 0.51, 0.50], [3.01, 2.97, 3.02]];
//! let second = [[0.99, 1.03, 0.98], [2.02, 1.99, 2.01], [0.80, 0.79, 0.81], [2.99, 3.01, 2.98]];
//!
//! let p_values: Vec<f64> = first
//!     .iter()
//!     .zip(&second)
//!     .map(|(a, b)| welch(&Sample::of(a), &Sample::of(b)))
//!     .collect();
//! // Refused where a false alarm among all four has a probability of one per cent.
//! assert_eq!(holm(&p_values, 0.01), [false, false, true, false]);
//! ```

pub mod binomial;
pub mod bootstrap;
pub mod chi_square;
mod combine;
mod energy;
mod estimate;
mod family;
mod groups;
mod moments;
pub mod normal;
mod picture_error;
mod power_sums;
mod quantile;
mod sample;
mod shortfall;
pub mod slope;
pub mod student;
pub mod tail;
mod uniformity;
mod welch;

pub use combine::{inverse_variance_weight, ratio_of_means};
pub use energy::Energy;
pub use estimate::{Estimate, NOTHING_KNOWN};
pub use family::{holm, sidak};
pub use groups::{batch_means, tile_means, tile_sums};
pub use moments::Moments;
pub use picture_error::{PictureError, error_floor, own_rel_mse, rel_mse, relative_square_errors};
pub use power_sums::PowerSums;
pub use quantile::{median, quantile};
pub use sample::{Interval, Sample, mean_interval};
pub use shortfall::shortfall;
pub use uniformity::uniformity;
pub use welch::welch;

/// Runs the examples of the package's README as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
