//! The same scene in another form: other files, other places, other pieces.

pub mod cut;
pub mod files;
mod mgf;
pub mod motion;
mod picture;
mod ron;
mod three_ds;

pub use files::Files;
