//! Eight boxes in one register.

use super::boxes::{PLANES, RayBoxes};
use crate::Ray;
use crate::tree::block::Block;
use crate::tree::intersector::{ChildIntersector, FilteredTriangles, Hits, TriangleIntersector};
use crate::tree::node::{Child, LEAF, Node, WIDTH};
use crate::tree::simd::Avx2Simd;
use crate::tree::stack::Stack;
use std::arch::x86_64::*;

/// Eight boxes at once.
#[derive(Clone, Copy)]
pub(crate) struct Avx2<T> {
    origin: [__m256; 3],
    near: [__m256; 3],
    far: [__m256; 3],
    octant: i32,
    /// See [`PLANES`].
    planes: [usize; 6],
    /// The shift of the order of its octant, in all places.
    order_shift: __m256i,
    triangles: T,
}

/// For each set of boxes the numbers of those in it, one a byte, lowest first.
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

impl<T: Copy> Avx2<T> {
    /// # Safety
    /// The machine must have AVX2 and FMA.
    #[inline(always)]
    pub(crate) unsafe fn new(ray: &Ray, triangles: T) -> Self {
        // SAFETY: the caller promises AVX2, which includes SSE4.1, and FMA.
        unsafe {
            let boxes = RayBoxes::of(ray);
            let double = |v: [__m128; 3]| v.map(|x| _mm256_set_m128(x, x));
            Self {
                origin: ray.origin.to_array().map(|x| _mm256_set1_ps(x)),
                near: double(boxes.near()),
                far: double(boxes.far()),
                octant: boxes.octant,
                planes: PLANES[boxes.octant as usize % 8],
                order_shift: _mm256_set1_epi32(3 * boxes.octant),
                triangles,
            }
        }
    }
}

/// The boxes of a node that a ray meets.
struct MetBoxes {
    /// The t at which the ray enters, by box.
    enter: __m256,
    /// The boxes by place, the farthest first; `None` for box by box.
    order: Option<__m256i>,
    /// One bit for each place whose box is met.
    mask: u32,
}

impl<T: Copy> Avx2<T> {
    #[inline(always)]
    fn meet(&self, node: &Node, limit: f32, in_order: bool) -> MetBoxes {
        // SAFETY: `self` shows that the machine has AVX2; a node is aligned to 64
        // bytes and has six rows of 32, at whose starts the offsets are.
        unsafe {
            let planes = node.planes.as_ptr();
            let from_origin = |offset: usize, axis: usize| {
                _mm256_sub_ps(*planes.byte_add(offset).cast::<__m256>(), self.origin[axis])
            };
            let near =
                |axis: usize| _mm256_mul_ps(from_origin(self.planes[axis], axis), self.near[axis]);
            let far = |axis: usize| {
                _mm256_mul_ps(from_origin(self.planes[axis + 3], axis), self.far[axis])
            };
            // What is not a number leaves the second operand.
            let enter = _mm256_max_ps(
                _mm256_max_ps(near(0), near(1)),
                _mm256_max_ps(near(2), _mm256_setzero_ps()),
            );
            let leave = _mm256_min_ps(
                _mm256_min_ps(far(0), far(1)),
                _mm256_min_ps(far(2), _mm256_set1_ps(limit)),
            );
            let met = _mm256_cmp_ps::<_CMP_LE_OQ>(enter, leave);
            let of_octant = || {
                let order = _mm256_load_si256(node.order.as_ptr().cast());
                _mm256_srlv_epi32(order, self.order_shift)
            };
            let order = in_order.then(of_octant);
            let met = order.map_or(met, |order| _mm256_permutevar8x32_ps(met, order));
            MetBoxes { enter, order, mask: _mm256_movemask_ps(met) as u32 }
        }
    }

    /// Writes the boxes that are met where the stack goes on, without taking them
    /// over.
    #[inline(always)]
    fn write(names: &[Child; WIDTH], met: &MetBoxes, stack: &mut Stack) {
        // SAFETY: a `MetBoxes` shows that the machine has AVX2; names are 32 bytes, and there
        // is spare room for eight numbers each.
        unsafe {
            let packed = _mm_cvtsi64_si128(PACK[met.mask as usize & 0xff].cast_signed());
            let places = _mm256_cvtepu8_epi32(packed);
            let boxes = met.order.map_or(places, |o| _mm256_permutevar8x32_epi32(o, places));
            let (enter_room, child_room) = stack.spare();
            let enter = _mm256_permutevar8x32_ps(met.enter, boxes);
            _mm256_storeu_ps(enter_room.as_mut_ptr().cast(), enter);
            let names = _mm256_loadu_si256(names.as_ptr().cast());
            let names = _mm256_permutevar8x32_epi32(names, boxes);
            _mm256_storeu_si256(child_room.as_mut_ptr().cast(), names);
        }
    }
}

impl<T: TriangleIntersector> ChildIntersector for Avx2<T> {
    type Simd = Avx2Simd;

    #[inline(always)]
    fn simd(&self) -> Avx2Simd {
        // SAFETY: `self` shows that the machine has AVX2 and FMA.
        unsafe { Avx2Simd::new() }
    }

    #[inline(always)]
    fn open(
        &self,
        node: &Node,
        names: &[Child; WIDTH],
        limit: f32,
        in_order: bool,
        stack: &mut Stack,
    ) {
        let met = self.meet(node, limit, in_order);
        Self::write(names, &met, stack);
        // SAFETY: as many were written first as there are bits.
        unsafe { stack.grow(met.mask.count_ones() as usize) };
    }

    /// The last box does not go through the stack, which would take longer.
    #[inline(always)]
    fn open_next(
        &self,
        node: &Node,
        limit: f32,
        in_order: bool,
        stack: &mut Stack,
    ) -> Option<Child> {
        let met = self.meet(node, limit, in_order);
        let Some(last) = met.mask.checked_ilog2() else { return stack.pop(limit) };
        let lane =
            if in_order { node.order[last as usize % WIDTH] >> (3 * self.octant) } else { last };
        if !met.mask.is_power_of_two() {
            Self::write(&node.children, &met, stack);
            // SAFETY: one less than were written.
            unsafe { stack.grow(met.mask.count_ones() as usize - 1) };
        }
        Some(node.children[lane as usize % WIDTH])
    }

    #[inline(always)]
    fn with_reciprocals(self, near: [f32; 3], far: [f32; 3]) -> Self {
        // SAFETY: `self` shows that the machine has AVX2.
        let splat = |x: f32| unsafe { _mm256_set1_ps(x) };
        Self { near: near.map(splat), far: far.map(splat), ..self }
    }
}

impl<T: TriangleIntersector> TriangleIntersector for Avx2<T> {
    #[inline(always)]
    fn candidates(&self, block: &Block, limit: f32) -> u32 {
        self.triangles.candidates(block, limit)
    }

    #[inline(always)]
    fn filter(&self, block: &Block, limit: f32) -> FilteredTriangles {
        self.triangles.filter(block, limit)
    }

    #[inline(always)]
    fn meet(&self, block: &Block, candidates: u32, ray: &Ray, limit: f32) -> Hits<LEAF> {
        self.triangles.meet(block, candidates, ray, limit)
    }
}
