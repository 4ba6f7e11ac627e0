//! Four triangles side by side.

use super::extents::QuantisedExtents;
use super::node::LEAF;
use crate::shape::ShapeKind;
use crate::shape::SidedTriangle;
use crate::{Aabb, Sides, Triangle, Vec3};

/// The corners of up to four triangles: 160 bytes.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct Block {
    /// The corners by number, by axis, by triangle. Where there is none they are not numbers,
    /// and no ray passes them.
    pub(crate) corners: [[[f32; LEAF]; 3]; 3],
    /// The numbers of the triangles, their sides, and how large they are, as [`QuantisedExtents`]
    /// has it.
    pub(crate) words: [u32; LEAF],
}

impl Block {
    /// Stands for no triangle.
    pub(crate) const NONE: u32 = u32::MAX;

    /// The block of the triangles with these numbers.
    pub(crate) fn new(
        numbers: [u32; LEAF],
        extents: QuantisedExtents,
        kind: impl Fn(u32) -> ShapeKind,
    ) -> Self {
        let mut block = Self { corners: [[[f32::NAN; LEAF]; 3]; 3], words: numbers };
        for (lane, &number) in numbers.iter().enumerate().filter(|&(_, &n)| n != Self::NONE) {
            let ShapeKind::Triangle(SidedTriangle { corners, sides }) = kind(number) else {
                continue;
            };
            for (rows, corner) in block.corners.iter_mut().zip(corners) {
                for (axis, row) in rows.iter_mut().enumerate() {
                    row[lane] = corner[axis];
                }
            }
            let extent = Aabb::around(corners).extent().max_element();
            block.words[lane] = extents.word(number, sides, extent);
        }
        block
    }

    /// The number of one of its triangles.
    #[inline]
    pub(crate) fn number(&self, lane: usize) -> u32 {
        QuantisedExtents::number(self.words[lane])
    }

    /// Tells whether a ray in this direction meets one of its triangles from a side that is there,
    /// as [`Triangle::intersect`](crate::Triangle::intersect) decides it.
    #[inline(always)]
    pub(crate) fn admits(&self, lane: usize, direction: Vec3) -> bool {
        match QuantisedExtents::sides(self.words[lane]) {
            Sides::Both => true,
            Sides::Front => self.shows_front(lane, direction),
        }
    }

    #[inline(never)]
    fn shows_front(&self, lane: usize, direction: Vec3) -> bool {
        let normal = Triangle::normal_of(self.triangle(lane));
        normal.is_some_and(|normal| Sides::Front.admit(direction.dot(normal)))
    }

    /// The corners of one of its triangles.
    #[inline]
    pub(crate) fn triangle(&self, lane: usize) -> [Vec3; 3] {
        let corner =
            |rows: &[[f32; LEAF]; 3]| Vec3::from_array(rows.each_ref().map(|row| row[lane]));
        self.corners.each_ref().map(corner)
    }

    /// Returns the corners with their coordinates in this order.
    #[inline(always)]
    pub(crate) fn picked(&self, lane: usize, axes: [usize; 3]) -> [[f32; 3]; 3] {
        let place = |axis: usize| LEAF * axis + lane;
        let [x, y, z] = [place(axes[0]), place(axes[1]), place(axes[2])];
        let [a, b, c] = [0, 1, 2].map(|corner| self.corners[corner].as_flattened());
        [[a[x], a[y], a[z]], [b[x], b[y], b[z]], [c[x], c[y], c[z]]]
    }
}
