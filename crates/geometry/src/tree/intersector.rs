//! One ray against eight boxes or four triangles, for each instruction set.
//!
//! The operations that decide are the same in the same order for all, so they agree to the bit;
//! those that only leave out may differ.

mod scalar;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use scalar::Scalar;
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::{Avx2, Sse41, TriangleRay};

use super::block::Block;
use super::mask::ones;
use super::node::{Child, LEAF, Node, WIDTH};
use super::simd::Simd;
use super::stack::Stack;
use crate::ShapeHit;
use crate::f32_filter::ShearedTriangle;
use crate::{Ray, watertight};

/// Distances to near planes are made smaller and those to far planes larger, which covers
/// both the rounding here and, since errors of an intersection grow with its distance too,
/// that of the shapes: four roundings, and more than ten times as many for what is met in
/// single precision by rays that all but graze.
pub(super) const NEARER: f32 = 1.0 - 64.0 * f32::EPSILON;
pub(super) const FARTHER: f32 = 1.0 + 64.0 * f32::EPSILON;

/// A ray prepared for tests of many boxes, and triangles, at once.
pub(crate) trait ChildIntersector: TriangleIntersector {
    type Simd: Simd;

    /// The instruction set, for shapes of other kinds.
    fn simd(&self) -> Self::Simd;

    /// Puts the boxes that the ray meets before `limit` on the stack by these names, in
    /// the order of its octant; unless `in_order` is asked, perhaps in another.
    ///
    /// A ray parallel to a plane and in it gets 0 · ∞ here, which must not count
    /// against the box: a minimum or a maximum with what is not a number is the
    /// other operand.
    fn open(
        &self,
        node: &Node,
        names: &[Child; WIDTH],
        limit: f32,
        in_order: bool,
        stack: &mut Stack,
    );

    /// For rays that go together: from a distance along each axis to t, for near planes
    /// with the reciprocal nearest to zero and for far planes with that farthest from it, so
    /// that boxes are open to all.
    fn with_reciprocals(self, near: [f32; 3], far: [f32; 3]) -> Self;

    /// [`open`](Self::open), and the box to open next.
    #[inline(always)]
    fn open_next(
        &self,
        node: &Node,
        limit: f32,
        in_order: bool,
        stack: &mut Stack,
    ) -> Option<Child> {
        self.open(node, &node.children, limit, in_order, stack);
        stack.pop(limit)
    }
}

/// A ray prepared for tests of many triangles at once.
pub(crate) trait TriangleIntersector: Copy {
    /// One bit for each triangle that the ray may meet at 0 < t < `limit`, and perhaps for
    /// others: [`meet`](Self::meet) has the last word.
    fn candidates(&self, block: &Block, limit: f32) -> u32;

    /// One bit for each triangle that the line of the ray passes and of which a point
    /// can be at 0 < t < `limit`, in single precision.
    fn filter(&self, block: &Block, limit: f32) -> FilteredTriangles;

    /// [`watertight::meet`] for those triangles that have a bit.
    #[inline(always)]
    fn meet(&self, block: &Block, candidates: u32, ray: &Ray, limit: f32) -> Hits<LEAF> {
        meet_in_turn(block, candidates, ray, limit)
    }
}

/// The hits of a ray with the triangles of a block, or of the rays of a packet with one triangle;
/// one bit for each.
pub(crate) struct Hits<const N: usize> {
    pub(crate) mask: u32,
    pub(crate) t: [f32; N],
    pub(crate) u: [f32; N],
    pub(crate) v: [f32; N],
}

impl<const N: usize> Hits<N> {
    /// One of those that have a bit.
    #[inline(always)]
    pub(crate) fn hit(&self, lane: usize) -> ShapeHit {
        ShapeHit { t: self.t[lane % N], u: self.u[lane % N], v: self.v[lane % N] }
    }
}

#[inline(always)]
fn meet_in_turn(block: &Block, candidates: u32, ray: &Ray, limit: f32) -> Hits<LEAF> {
    let none = [0.0; LEAF];
    let mut hits = Hits { mask: 0, t: none, u: none, v: none };
    let axes = watertight::axes(&ray.direction);
    for lane in ones(candidates) {
        let corners = block.picked(lane % LEAF, axes);
        if let Some(ShapeHit { t, u, v }) = watertight::meet(ray, axes, limit, corners) {
            hits.mask |= 1 << lane;
            (hits.t[lane % LEAF], hits.u[lane % LEAF], hits.v[lane % LEAF]) = (t, u, v);
        }
    }
    hits
}

/// In the place of what meets triangles, for trees that have none: to prepare a ray takes as
/// long as to open a node.
#[derive(Clone, Copy)]
pub(crate) struct NoTriangles;

impl TriangleIntersector for NoTriangles {
    #[inline(always)]
    fn candidates(&self, _: &Block, _: f32) -> u32 {
        0
    }

    #[inline(always)]
    fn filter(&self, _: &Block, _: f32) -> FilteredTriangles {
        let none = [[0.0; LEAF]; 3];
        FilteredTriangles { mask: 0, edges: none, depths: none }
    }
}

/// The triangles of a block that a ray passes, one bit each, and how it sees all of
/// them.
pub(crate) struct FilteredTriangles {
    pub(crate) mask: u32,
    /// The edges by corner, by triangle.
    pub(crate) edges: [[f32; LEAF]; 3],
    pub(crate) depths: [[f32; LEAF]; 3],
}

impl FilteredTriangles {
    /// One of the triangles.
    #[inline(always)]
    pub(crate) fn triangle(&self, lane: usize) -> ShearedTriangle {
        let of_lane = |rows: &[[f32; LEAF]; 3]| rows.each_ref().map(|row| row[lane]);
        ShearedTriangle { edges: of_lane(&self.edges), depths: of_lane(&self.depths) }
    }
}

/// Puts the boxes whose bit is set on the stack.
#[inline(always)]
fn push(
    node: &Node,
    names: &[Child; WIDTH],
    octant: i32,
    enter: &[f32; WIDTH],
    mask: u32,
    stack: &mut Stack,
) {
    for word in node.order {
        let lane = (word >> (3 * octant)) as usize % WIDTH;
        if mask >> lane & 1 != 0 {
            stack.push(enter[lane], names[lane]);
        }
    }
}

/// Returns the greater of two numbers. A value that is not a number loses; of two, the second
/// stays.
#[inline(always)]
pub(super) fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

#[inline(always)]
pub(super) fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}
