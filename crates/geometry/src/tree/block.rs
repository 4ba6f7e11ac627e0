//! Four triangles side by side.

use super::node::LEAF;
use crate::Vec3;
use crate::precise::DVec3;

/// The corners of up to four triangles: 160 bytes.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct Block {
    /// By corner, by axis, by triangle. Where there is none they are not numbers,
    /// and no ray passes them.
    pub(crate) corners: [[[f32; LEAF]; 3]; 3],
    /// Which triangles they are.
    pub(crate) numbers: [u32; LEAF],
}

impl Block {
    /// Stands for no triangle.
    pub(crate) const NONE: u32 = u32::MAX;

    /// The block of the triangles with these numbers.
    pub(crate) fn new(numbers: [u32; LEAF], triangle: impl Fn(u32) -> [Vec3; 3]) -> Self {
        let mut corners = [[[f32::NAN; LEAF]; 3]; 3];
        for (lane, &number) in numbers.iter().enumerate().filter(|&(_, &n)| n != Self::NONE) {
            for (rows, corner) in corners.iter_mut().zip(triangle(number)) {
                for (axis, row) in rows.iter_mut().enumerate() {
                    row[lane] = corner[axis];
                }
            }
        }
        Self { corners, numbers }
    }

    /// [`triangle`](Self::triangle) in double precision.
    #[inline]
    pub(crate) fn triangle_f64(&self, lane: usize) -> [DVec3; 3] {
        let corner = |rows: &[[f32; LEAF]; 3]| {
            DVec3::new(rows[0][lane].into(), rows[1][lane].into(), rows[2][lane].into())
        };
        self.corners.each_ref().map(corner)
    }

    /// The corners of one of its triangles.
    #[inline]
    pub(crate) fn triangle(&self, lane: usize) -> [Vec3; 3] {
        let corner =
            |rows: &[[f32; LEAF]; 3]| Vec3::from_array(rows.each_ref().map(|row| row[lane]));
        self.corners.each_ref().map(corner)
    }
}
