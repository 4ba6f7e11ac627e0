//! The kernel for any machine, which is what the others are checked against.

use super::{
    ChildIntersector, FARTHER, FilteredTriangles, NEARER, TriangleIntersector, greater, lesser,
    push,
};
use crate::Ray;
use crate::f32_filter::Shear;
use crate::tree::block::Block;
use crate::tree::node::{Child, LEAF, Node, WIDTH};
use crate::tree::simd::Portable;
use crate::tree::stack::Stack;

/// One box and one triangle at a time.
#[derive(Clone, Copy)]
pub(crate) struct Scalar<'a> {
    ray: &'a Ray,
    /// From a distance along an axis to t, for near and for far planes.
    near: [f32; 3],
    far: [f32; 3],
    /// The row of a node that holds the near plane of each axis; the far one is its neighbour.
    near_row: [usize; 3],
    /// See [`Node::order`].
    octant: i32,
    shear: Shear,
}

impl<'a> Scalar<'a> {
    pub(crate) fn new(ray: &'a Ray) -> Self {
        let reciprocal = ray.direction.recip();
        // The reciprocal of −0 is negative: sign and order agree.
        let backward = reciprocal.to_array().map(|r| r < 0.0);
        Self {
            ray,
            near: (reciprocal * NEARER).to_array(),
            far: (reciprocal * FARTHER).to_array(),
            near_row: std::array::from_fn(|axis| 2 * axis + usize::from(backward[axis])),
            octant: i32::from(backward[0])
                | i32::from(backward[1]) << 1
                | i32::from(backward[2]) << 2,
            shear: Shear::along(&ray.direction),
        }
    }
}

impl ChildIntersector for Scalar<'_> {
    type Simd = Portable;

    #[inline]
    fn simd(&self) -> Portable {
        Portable
    }

    #[inline]
    fn open(
        &self,
        node: &Node,
        names: &[Child; WIDTH],
        limit: f32,
        _in_order: bool,
        stack: &mut Stack,
    ) {
        let mut entries = [0.0; WIDTH];
        let mut mask = 0;
        for (lane, entry) in entries.iter_mut().enumerate() {
            let plane = |row: usize, axis: usize| node.planes[row][lane] - self.ray.origin[axis];
            let near = |axis: usize| plane(self.near_row[axis], axis) * self.near[axis];
            let far = |axis: usize| plane(self.near_row[axis] ^ 1, axis) * self.far[axis];
            *entry = greater(greater(near(0), near(1)), greater(near(2), 0.0));
            let leave = lesser(lesser(far(0), far(1)), lesser(far(2), limit));
            mask |= u32::from(*entry <= leave) << lane;
        }
        push(node, names, self.octant, &entries, mask, stack);
    }

    #[inline]
    fn with_reciprocals(self, near: [f32; 3], far: [f32; 3]) -> Self {
        Self { near, far, ..self }
    }
}

impl TriangleIntersector for Scalar<'_> {
    /// All there are: what a ray may meet, asking will tell.
    #[inline]
    fn candidates(&self, block: &Block, _: f32) -> u32 {
        let bit = |lane: usize| u32::from(block.words[lane] != Block::NONE) << lane;
        (0..LEAF).map(bit).sum()
    }

    #[inline]
    fn filter(&self, block: &Block, limit: f32) -> FilteredTriangles {
        let none = [[0.0; LEAF]; 3];
        let mut filtered = FilteredTriangles { mask: 0, edges: none, depths: none };
        for lane in 0..LEAF {
            let triangle = self.shear.apply(&block.triangle(lane), self.ray);
            filtered.mask |= u32::from(triangle.may_meet(limit)) << lane;
            for corner in 0..3 {
                filtered.edges[corner][lane] = triangle.edges[corner];
                filtered.depths[corner][lane] = triangle.depths[corner];
            }
        }
        filtered
    }
}
