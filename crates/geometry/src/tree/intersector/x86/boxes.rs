//! From distances along the axes to t.

use crate::Ray;
use crate::tree::intersector::{FARTHER, NEARER};
use std::arch::x86_64::*;

/// A direction as boxes are tested by it, in registers: through memory, where numbers would be
/// written one by one and read together, it takes longer than all the rest.
#[derive(Clone, Copy)]
pub(super) struct RayBoxes {
    /// From a distance along an axis to t, for near and for far planes.
    near: __m128,
    far: __m128,
    /// See [`Node::order`](crate::tree::node::Node).
    pub(super) octant: i32,
}

/// The offsets in a node, in bytes, of the near plane of each axis, and then of the far one of
/// each, for each octant.
pub(super) static PLANES: [[usize; 6]; 8] = {
    let mut table = [[0; 6]; 8];
    let mut octant = 0;
    while octant < 8 {
        let mut axis = 0;
        while axis < 3 {
            let backward = octant >> axis & 1;
            table[octant][axis] = 32 * (2 * axis + backward);
            table[octant][axis + 3] = 32 * (2 * axis + (1 - backward));
            axis += 1;
        }
        octant += 1;
    }
    table
};

impl RayBoxes {
    /// # Safety
    /// The machine must have SSE4.1.
    #[inline(always)]
    pub(super) unsafe fn of(ray: &Ray) -> Self {
        let [x, y, z] = ray.direction.to_array();
        // SAFETY: the caller promises SSE4.1.
        unsafe {
            let reciprocal = _mm_div_ps(_mm_set1_ps(1.0), _mm_setr_ps(x, y, z, 1.0));
            Self {
                near: _mm_mul_ps(reciprocal, _mm_set1_ps(NEARER)),
                far: _mm_mul_ps(reciprocal, _mm_set1_ps(FARTHER)),
                octant: _mm_movemask_ps(reciprocal) & 7,
            }
        }
    }

    /// The reciprocals for near planes, each in all four places.
    #[inline(always)]
    pub(super) fn near(&self) -> [__m128; 3] {
        spread(self.near)
    }

    /// The reciprocals for far planes, each in all four places.
    #[inline(always)]
    pub(super) fn far(&self) -> [__m128; 3] {
        spread(self.far)
    }
}

#[inline(always)]
fn spread(v: __m128) -> [__m128; 3] {
    // SAFETY: every x86-64 machine has SSE.
    unsafe {
        [_mm_shuffle_ps::<0x00>(v, v), _mm_shuffle_ps::<0x55>(v, v), _mm_shuffle_ps::<0xaa>(v, v)]
    }
}
