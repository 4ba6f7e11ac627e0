//! Puts a scene into another form: other files, other places, other pieces.

pub mod cut;
pub mod exported;
pub mod files;
mod mgf;
pub mod mitsuba;
pub mod motion;
mod picture;
pub mod pictured;
mod ron;
mod sky;
mod three_ds;

pub use files::{Files, Placement};
