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
use super::node::{Child, LEAF, Node, WIDTH};
use super::stack::Stack;
use crate::coarse::Flat;

/// Distances to near planes are made smaller and those to far planes larger, which covers
/// both the rounding here and, since errors of an intersection grow with its distance too,
/// that of the shapes: four roundings, sixteen times as many on rays that all but graze.
const NEARER: f32 = 1.0 - 64.0 * f32::EPSILON;
const FARTHER: f32 = 1.0 + 64.0 * f32::EPSILON;

/// A ray prepared for tests of many boxes and triangles at once.
pub(crate) trait Lanes {
    /// Puts the boxes that the ray meets before `limit` on the stack, in the order
    /// of its octant.
    ///
    /// A ray parallel to a plane and in it gets 0 · ∞ here, which must not count
    /// against the box: a minimum or a maximum with what is not a number is the
    /// other operand.
    fn open(&self, node: &Node, limit: f32, stack: &mut Stack);

    /// [`open`](Self::open), and the box to open next.
    #[inline(always)]
    fn open_next(&self, node: &Node, limit: f32, stack: &mut Stack) -> Option<Child> {
        self.open(node, limit, stack);
        stack.pop(limit)
    }

    /// One bit for each triangle that the ray may meet at 0 < t < `limit`; of few that it
    /// does not meet. How the ray sees them has the last word.
    fn candidates(&self, block: &Block, limit: f32) -> u32;

    /// One bit for each triangle that the line of the ray passes and of which a point
    /// can be at 0 < t < `limit`, in single precision.
    fn pass(&self, block: &Block, limit: f32) -> Passed;

    /// As [`watertight::axes`](crate::watertight::axes) gives them for the ray.
    fn axes(&self) -> [usize; 3];
}

/// The triangles of a block that a ray passes, one bit each, and how it sees all of
/// them.
pub(crate) struct Passed {
    pub(crate) mask: u32,
    /// By corner, by triangle.
    pub(crate) edges: [[f32; LEAF]; 3],
    pub(crate) depths: [[f32; LEAF]; 3],
}

impl Passed {
    /// One of the triangles.
    #[inline(always)]
    pub(crate) fn flat(&self, lane: usize) -> Flat {
        let of_lane = |rows: &[[f32; LEAF]; 3]| rows.each_ref().map(|row| row[lane]);
        Flat { edges: of_lane(&self.edges), depths: of_lane(&self.depths) }
    }
}

/// Puts the boxes whose bit is set on the stack.
#[inline(always)]
fn push(node: &Node, octant: i32, enter: &[f32; WIDTH], mask: u32, stack: &mut Stack) {
    for word in node.order {
        let lane = (word >> (3 * octant)) as usize % WIDTH;
        if mask >> lane & 1 != 0 {
            stack.push(enter[lane], node.children[lane]);
        }
    }
}
