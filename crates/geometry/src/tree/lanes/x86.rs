//! The kernels for x86-64: AVX2, and SSE4.1 for older machines.
//!
//! Each type exists only where its instructions do: that is the promise of its
//! `new`, and what makes its methods sound. They are inlined into a function that
//! is compiled for those instructions.

#![allow(unsafe_code)]

use super::{Lanes, Passed, push};
use crate::tree::block::Block;
use crate::tree::node::{LEAF, Node, WIDTH};
use crate::tree::prepared::Prepared;
use crate::tree::stack::Stack;
use std::arch::x86_64::*;

/// Eight boxes at once.
pub(crate) struct Avx2 {
    origin: [__m256; 3],
    near: [__m256; 3],
    far: [__m256; 3],
    near_row: [usize; 3],
    /// Three times its number, in each lane.
    octant: __m256i,
    triangles: TriangleRay,
}

/// For each set of lanes the numbers of those in it, one a byte, lowest first.
static PACK: [u64; 256] = {
    let mut table = [0; 256];
    let mut mask = 0;
    while mask < 256 {
        let (mut lane, mut place) = (0, 0);
        while lane < 8 {
            if mask >> lane & 1 != 0 {
                table[mask] |= lane << (8 * place);
                place += 1;
            }
            lane += 1;
        }
        mask += 1;
    }
    table
};

impl Avx2 {
    /// # Safety
    /// The machine must have AVX2.
    #[inline(always)]
    pub(crate) unsafe fn new(ray: &Prepared) -> Self {
        let boxes = &ray.boxes;
        // SAFETY: the caller promises AVX2.
        let splat = |values: [f32; 3]| values.map(|x| unsafe { _mm256_set1_ps(x) });
        Self {
            origin: splat(boxes.origin),
            near: splat(boxes.near),
            far: splat(boxes.far),
            near_row: boxes.near_row,
            octant: unsafe { _mm256_set1_epi32(3 * boxes.octant as i32) },
            // SAFETY: AVX2 includes SSE4.1.
            triangles: unsafe { TriangleRay::new(ray) },
        }
    }
}

impl Lanes for Avx2 {
    #[inline(always)]
    fn open(&self, node: &Node, limit: f32, stack: &mut Stack) {
        // SAFETY: `self` shows that the machine has AVX2; rows are 32 bytes long
        // and, in a node, lie at multiples of 32.
        unsafe {
            let distance = |row: usize, axis: usize| {
                let plane = _mm256_load_ps(node.planes[row].as_ptr());
                _mm256_sub_ps(plane, self.origin[axis])
            };
            let mut enter = _mm256_setzero_ps();
            let mut leave = _mm256_set1_ps(limit);
            for axis in 0..3 {
                let row = self.near_row[axis];
                // What is not a number leaves the second operand.
                enter = _mm256_max_ps(_mm256_mul_ps(distance(row, axis), self.near[axis]), enter);
                leave = _mm256_min_ps(_mm256_mul_ps(distance(row ^ 1, axis), self.far[axis]), leave);
            }
            let met = _mm256_cmp_ps::<_CMP_LE_OQ>(enter, leave);
            let order = _mm256_load_si256(node.order.as_ptr().cast());
            let order = _mm256_srlv_epi32(order, self.octant);
            let mask = _mm256_movemask_ps(_mm256_permutevar8x32_ps(met, order)) as usize;
            let packed = _mm_cvtsi64_si128(PACK[mask & 0xff] as i64);
            let order = _mm256_permutevar8x32_epi32(order, _mm256_cvtepu8_epi32(packed));
            let children = _mm256_load_si256(node.children.as_ptr().cast());
            let (enter_room, child_room) = stack.spare();
            _mm256_storeu_ps(enter_room.as_mut_ptr().cast(), _mm256_permutevar8x32_ps(enter, order));
            _mm256_storeu_si256(
                child_room.as_mut_ptr().cast(),
                _mm256_permutevar8x32_epi32(children, order),
            );
            stack.grow(mask.count_ones() as usize);
        }
    }

    #[inline(always)]
    fn pass(&self, block: &Block) -> Passed {
        self.triangles.pass(block)
    }
}

/// Four boxes at once, twice.
pub(crate) struct Sse41 {
    origin: [__m128; 3],
    near: [__m128; 3],
    far: [__m128; 3],
    near_row: [usize; 3],
    octant: usize,
    triangles: TriangleRay,
}

impl Sse41 {
    /// # Safety
    /// The machine must have SSE4.1.
    #[inline(always)]
    pub(crate) unsafe fn new(ray: &Prepared) -> Self {
        let boxes = &ray.boxes;
        // SAFETY: the caller promises SSE4.1.
        let splat = |values: [f32; 3]| values.map(|x| unsafe { _mm_set1_ps(x) });
        Self {
            origin: splat(boxes.origin),
            near: splat(boxes.near),
            far: splat(boxes.far),
            near_row: boxes.near_row,
            octant: boxes.octant,
            // SAFETY: the same promise.
            triangles: unsafe { TriangleRay::new(ray) },
        }
    }

    /// Boxes `first` to `first + 3` of a node; `first` is 0 or 4.
    #[inline(always)]
    fn enter_half(&self, node: &Node, limit: f32, first: usize) -> (__m128, u32) {
        // SAFETY: `self` shows that the machine has SSE4.1; half a row is 16 bytes
        // long and, in a node, lies at a multiple of 16.
        unsafe {
            let distance = |row: usize, axis: usize| {
                let plane = _mm_load_ps(node.planes[row][first..][..4].as_ptr());
                _mm_sub_ps(plane, self.origin[axis])
            };
            let mut enter = _mm_setzero_ps();
            let mut leave = _mm_set1_ps(limit);
            for axis in 0..3 {
                let row = self.near_row[axis];
                // What is not a number leaves the second operand.
                enter = _mm_max_ps(_mm_mul_ps(distance(row, axis), self.near[axis]), enter);
                leave = _mm_min_ps(_mm_mul_ps(distance(row ^ 1, axis), self.far[axis]), leave);
            }
            (enter, _mm_movemask_ps(_mm_cmple_ps(enter, leave)) as u32)
        }
    }
}

impl Lanes for Sse41 {
    #[inline(always)]
    fn open(&self, node: &Node, limit: f32, stack: &mut Stack) {
        let (low, low_mask) = self.enter_half(node, limit, 0);
        let (high, high_mask) = self.enter_half(node, limit, 4);
        let mut entries = [0.0; WIDTH];
        // SAFETY: `self` shows that the machine has SSE4.1; both halves have room
        // for four numbers.
        unsafe {
            _mm_storeu_ps(entries[..4].as_mut_ptr(), low);
            _mm_storeu_ps(entries[4..].as_mut_ptr(), high);
        }
        push(node, self.octant, &entries, low_mask | high_mask << 4, stack);
    }

    #[inline(always)]
    fn pass(&self, block: &Block) -> Passed {
        self.triangles.pass(block)
    }
}

/// Four triangles at once. Exists only where SSE4.1 does.
struct TriangleRay {
    axes: [usize; 3],
    /// In the order of `axes`.
    origin: [__m128; 3],
    slope: [__m128; 2],
}

impl TriangleRay {
    /// # Safety
    /// The machine must have SSE4.1.
    #[inline(always)]
    unsafe fn new(ray: &Prepared) -> Self {
        let shear = &ray.shear;
        // SAFETY: the caller promises SSE4.1.
        let splat = |x: f32| unsafe { _mm_set1_ps(x) };
        let origin = ray.boxes.origin;
        Self {
            axes: shear.axes,
            origin: shear.axes.map(|axis| splat(origin[axis % 3])),
            slope: shear.slope.map(splat),
        }
    }

    /// [`Shear::edges`](crate::watertight::Shear) and
    /// [`is_inside`](crate::watertight::is_inside) for the
    /// triangles of a block.
    #[inline(always)]
    fn pass(&self, block: &Block) -> Passed {
        // SAFETY: `self` shows that the machine has SSE4.1; rows are 16 bytes long
        // and, in a block, lie at multiples of 16.
        unsafe {
            let zero = _mm_setzero_ps();
            let corner = |rows: &[[f32; LEAF]; 3]| {
                let [x, y, depth] = std::array::from_fn(|i| {
                    let row = _mm_load_ps(rows[self.axes[i]].as_ptr());
                    _mm_sub_ps(row, self.origin[i])
                });
                let x = _mm_sub_ps(x, _mm_mul_ps(self.slope[0], depth));
                let y = _mm_sub_ps(y, _mm_mul_ps(self.slope[1], depth));
                (x, y)
            };
            let cross = |(px, py): (__m128, __m128), (qx, qy): (__m128, __m128)| {
                _mm_sub_ps(_mm_mul_ps(px, qy), _mm_mul_ps(py, qx))
            };
            let [a, b, c] = [0, 1, 2].map(|i| corner(&block.corners[i]));
            let of_a = cross(b, c);
            let of_b = cross(c, a);
            let of_c = cross(a, b);
            let least = _mm_min_ps(_mm_min_ps(of_a, of_b), of_c);
            let most = _mm_max_ps(_mm_max_ps(of_a, of_b), of_c);
            let inside = _mm_or_ps(_mm_cmpge_ps(least, zero), _mm_cmple_ps(most, zero));
            let mask = _mm_movemask_ps(inside) as u32;
            let rows = |rows: [__m128; 3]| {
                rows.map(|row| {
                    let mut lanes = [0.0; LEAF];
                    _mm_storeu_ps(lanes.as_mut_ptr(), row);
                    lanes
                })
            };
            Passed { mask, edges: rows([of_a, of_b, of_c]) }
        }
    }
}
