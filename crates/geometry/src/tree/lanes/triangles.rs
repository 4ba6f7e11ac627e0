//! A packet before triangles.

use super::rays::Rays;
use crate::tree::block::Block;
use crate::tree::extents::QuantisedExtents;
use crate::tree::node::LEAF;
use crate::tree::simd::{F32x4, F32x8, Simd};

/// A packet as triangles see it; the longest coordinate comes last.
#[derive(Clone, Copy)]
pub(crate) struct PacketTriangles<E: Simd> {
    pub(crate) simd: E,
    pub(super) axes: [usize; 3],
    pub(super) origin: [f32; 3],
    pub(super) direction: [E::F32x8; 3],
    /// The slopes of the rays along the two that stay.
    slope: [E::F32x8; 2],
    /// From depth to t.
    pub(super) reciprocal: E::F32x8,
    /// From depth to how far it is in front: 1 or −1.
    pub(super) in_front: f32,
    pub(super) extents: QuantisedExtents,
}

/// Coordinates of the corners of triangles: by corner, by axis, by triangle.
pub(crate) type Corners = [[[f32; LEAF]; 3]; 3];

impl<E: Simd> PacketTriangles<E> {
    #[inline(always)]
    pub(crate) fn of(rays: &Rays<E>, extents: QuantisedExtents) -> Self {
        let axes = rays.axes;
        let direction = [0, 1, 2].map(|i| rays.directions[axes[i]]);
        let reciprocal = direction[2].reciprocal();
        Self {
            simd: rays.simd,
            axes,
            origin: axes.map(|axis| rays.origin[axis]),
            direction,
            slope: [direction[0] * reciprocal, direction[1] * reciprocal],
            reciprocal,
            in_front: if rays.backward[axes[2]] == 0 { 1.0 } else { -1.0 },
            extents,
        }
    }

    /// The corners of triangles from the origin, in the order of the axes.
    #[inline(always)]
    pub(crate) fn corners(&self, block: &Block) -> Corners {
        arrays(self.relative(block))
    }

    /// [`corners`](Self::corners) before they go to memory.
    #[inline(always)]
    pub(super) fn relative(&self, block: &Block) -> [[E::F32x4; 3]; 3] {
        let corner = |corner: usize| {
            [self.row(block, corner, 0), self.row(block, corner, 1), self.row(block, corner, 2)]
        };
        [corner(0), corner(1), corner(2)]
    }

    #[inline(always)]
    fn row(&self, block: &Block, corner: usize, i: usize) -> E::F32x4 {
        let row = block.corners[corner][self.axes[i]];
        self.simd.load_four(row) - self.simd.splat_four(self.origin[i])
    }

    /// The edge functions of a triangle for each ray: see
    /// [`ShearedTriangle`](crate::f32_filter::ShearedTriangle).
    #[inline(always)]
    pub(super) fn edges(
        &self,
        corners: &Corners,
        lane: usize,
        minus_product: impl Fn(E::F32x8, E::F32x8, E::F32x8) -> E::F32x8,
    ) -> [E::F32x8; 3] {
        let a = self.place(&corners[0], lane, &minus_product);
        let b = self.place(&corners[1], lane, &minus_product);
        let c = self.place(&corners[2], lane, &minus_product);
        let cross = |p: [E::F32x8; 2], q: [E::F32x8; 2]| minus_product(p[0] * q[1], p[1], q[0]);
        [cross(b, c), cross(c, a), cross(a, b)]
    }

    /// Returns the place of a corner for each ray, in single precision.
    #[inline(always)]
    fn place(
        &self,
        corner: &[[f32; LEAF]; 3],
        lane: usize,
        minus_product: impl Fn(E::F32x8, E::F32x8, E::F32x8) -> E::F32x8,
    ) -> [E::F32x8; 2] {
        let x = self.simd.splat(corner[0][lane]);
        let y = self.simd.splat(corner[1][lane]);
        let depth = self.simd.splat(corner[2][lane]);
        [minus_product(x, self.slope[0], depth), minus_product(y, self.slope[1], depth)]
    }
}

/// In memory, from where instructions take one number eight times.
#[inline(always)]
pub(super) fn arrays<F: F32x4>([a, b, c]: [[F; 3]; 3]) -> Corners {
    let rows = |[x, y, z]: [F; 3]| [x.to_array(), y.to_array(), z.to_array()];
    [rows(a), rows(b), rows(c)]
}
