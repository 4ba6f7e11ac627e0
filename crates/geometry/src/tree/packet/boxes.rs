//! A packet before boxes.

use crate::tree::intersector::{FARTHER, NEARER};
use crate::tree::lanes::rays::Rays;
use crate::tree::node::Node;
use crate::tree::simd::{F32x8, Float, PACKET, Simd};

/// A packet as boxes see it.
#[derive(Clone, Copy)]
pub(super) struct PacketBoxes<E: Simd> {
    simd: E,
    origin: [f32; 3],
    /// For each axis 1 if they go backward along it.
    backward: [usize; 3],
    /// For each axis, from a distance along it to t, for near and for far planes.
    near: [E::F32x8; 3],
    far: [E::F32x8; 3],
}

impl<E: Simd> PacketBoxes<E> {
    #[inline(always)]
    pub(super) fn of(rays: &Rays<E>) -> Self {
        let simd = rays.simd;
        let [x, y, z] = rays.directions;
        let [x, y, z] = [x.reciprocal(), y.reciprocal(), z.reciprocal()];
        let [nearer, farther] = [simd.splat(NEARER), simd.splat(FARTHER)];
        Self {
            simd,
            origin: rays.origin.to_array(),
            backward: rays.backward,
            near: [x * nearer, y * nearer, z * nearer],
            far: [x * farther, y * farther, z * farther],
        }
    }

    /// The reciprocals with which a box is open that is open to any of the rays: of each axis the
    /// nearest to zero for near planes, the farthest from it for far ones.
    #[inline(always)]
    pub(super) fn widest(&self) -> [[f32; 3]; 2] {
        let signed = |axis: usize, size: f32| {
            if self.backward[axis] == 0 { size } else { -size }
        };
        let near = |axis: usize| signed(axis, self.near[axis].abs().smallest());
        let far = |axis: usize| signed(axis, self.far[axis].abs().largest());
        [[near(0), near(1), near(2)], [far(0), far(1), far(2)]]
    }

    /// One bit for each ray that meets a box of a node before its limit.
    #[inline(always)]
    pub(super) fn meet(&self, node: &Node, lane: usize, limits: &[f32; PACKET]) -> u32 {
        let plane = |axis: usize, side: usize| {
            self.simd.splat(node.planes[2 * axis + side % 2][lane] - self.origin[axis])
        };
        let limits = self.simd.load(*limits);
        let near = |axis: usize| plane(axis, self.backward[axis]) * self.near[axis];
        let far = |axis: usize| plane(axis, 1 ^ self.backward[axis]) * self.far[axis];
        let enter = near(0).greater(near(1)).greater(near(2).greater(self.simd.splat(0.0)));
        let leave = far(0).lesser(far(1)).lesser(far(2).lesser(limits));
        enter.at_most(leave)
    }
}
