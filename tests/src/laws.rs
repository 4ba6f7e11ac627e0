//! The measures that the laws of single parts are held against: goodness of fit, the lobe's own
//! coordinates, charts of lamps.
//!
//! Everything here is in double precision and written from the definitions, not
//! from the code under test.

pub mod chart;
pub mod chi_square;
pub mod frequency;
pub mod verdict;

/// The chance with which a correct program raises a false alarm, in each family of tests.
pub const FAMILY_LEVEL: f64 = 1e-3;
