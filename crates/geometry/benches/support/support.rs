//! The scenes and rays that benches measure: rooms of three sizes, a closed ball, sets of rays.
//!
//! The same here and in `peers`, which includes this folder by its path.
#![allow(dead_code, reason = "every bench takes what it needs")]

pub(crate) mod ball;
pub(crate) mod mixed;
pub(crate) mod rays;
pub(crate) mod room;
pub(crate) mod surfaces;
