//! Which method reaches which error in which time.

pub mod pictures;
pub mod results;
