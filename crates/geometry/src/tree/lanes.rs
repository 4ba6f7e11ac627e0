//! One ray against eight boxes or four triangles, for each instruction set.
//!
//! All do the same operations in the same order, so they agree to the bit.

mod scalar;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use scalar::Scalar;
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::{Avx2, Sse41};

use super::block::Block;
use super::node::{LEAF, Node, WIDTH};

/// A ray prepared for tests of many boxes and triangles at once.
pub(crate) trait Lanes {
    /// Where the ray enters each box, and one bit for each box that it meets
    /// before `limit`.
    ///
    /// A ray parallel to a plane and in it gets 0 · ∞ here, which must not count
    /// against the box: a minimum or a maximum with what is not a number is the
    /// other operand.
    fn enter(&self, node: &Node, limit: f32) -> ([f32; WIDTH], u32);

    /// One bit for each triangle that the ray passes, if a point of it can be at
    /// 0 < t < `limit`, with what [`Shear::flatten`](crate::watertight::Shear)
    /// gives for them.
    fn pass(&self, block: &Block, limit: f32) -> Passed;
}

/// The triangles of a block that a ray passes, one bit each.
pub(crate) struct Passed {
    pub(crate) mask: u32,
    pub(crate) edges: [[f32; LEAF]; 3],
    pub(crate) depths: [[f32; LEAF]; 3],
}
