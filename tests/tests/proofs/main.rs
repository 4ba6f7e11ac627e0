//! The proofs: what no crate can show by itself. One method, so that they are
//! linked once and run side by side.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on says so")]
#![allow(clippy::print_stdout, reason = "the figures are worth reading")]

mod ablation;
mod agreement;
mod analytic;
mod bump_map;
mod direct_forms;
mod furnace;
mod hard_geometry;
mod interreflection;
mod laws;
mod many_lamps;
mod mirrored;
mod planner;
mod points;
mod real_files;
mod reference;
mod repeat;
mod resolution;
mod sky;
mod spot_lights;
mod stability;
mod transmission;
mod variance;
