//! What a tree can hold.

use crate::precise::DVec3;
use crate::shape::ShapeHit;
use crate::tree::Passed;
use crate::tree::batch::Batch;
use crate::tree::block::Block;
use crate::tree::node::LEAF;
use crate::tree::query::Query;
use crate::tree::walk::Visitor;
use crate::watertight::Flat;
use crate::{Hit, Ray};
use std::ops::{ControlFlow, Range};

/// What a [`Bvh`](crate::Bvh) can hold: [`Triangles`](crate::Triangles),
/// [`Shapes`](crate::Shapes) or [`Instances`](crate::Instances).
#[expect(private_bounds, reason = "there are these three; others come as shapes")]
pub trait Contents: Holds {}

impl<C: Holds> Contents for C {}

pub(crate) trait Holds: Send + Sync {
    /// Numbers of shapes are below this.
    fn count(&self) -> u32;

    /// Where the ray meets triangle `number`, which it passes inside, at
    /// 0 < t < `limit`.
    fn triangle(
        &self,
        number: u32,
        corners: impl Fn() -> [DVec3; 3],
        flat: &Flat,
        ray: &Ray,
        limit: f32,
    ) -> Option<ShapeHit>;

    /// Offers the hits with shape `number`, which is no triangle.
    fn shape<Q: Query>(&self, number: u32, ray: &Ray, query: &mut Q) -> ControlFlow<()>;
}

/// Asks the contents of the leaves that a ray comes to.
pub(crate) struct Leaves<'a, C, Q> {
    pub(crate) contents: &'a C,
    pub(crate) order: &'a [u32],
    pub(crate) ray: &'a Ray,
    pub(crate) query: Q,
}

impl<C: Holds, Q: Query> Leaves<'_, C, Q> {
    /// The ray as far as anything counts.
    #[inline]
    fn ray(&self) -> Ray {
        Ray { t_max: self.query.limit(), ..*self.ray }
    }

    #[inline(always)]
    fn triangle(&self, block: &Block, lane: usize, flat: &Flat) -> Option<ShapeHit> {
        let corners = || block.triangle_f64(lane);
        self.contents.triangle(block.numbers[lane], corners, flat, self.ray, self.limit())
    }

    /// Rare, and apart so that a [`Flat`] usually stays in registers.
    #[cold]
    #[inline(never)]
    fn unsettled_triangle(&self, block: &Block, lane: usize, flat: Flat) -> Option<ShapeHit> {
        let flat = flat.settled(&block.triangle(lane), self.ray)?;
        self.triangle(block, lane, &flat)
    }
}

impl<C: Holds, Q: Query> Visitor for Leaves<'_, C, Q> {
    #[inline]
    fn limit(&self) -> f32 {
        self.query.limit()
    }

    #[inline(always)]
    fn triangles(&mut self, block: &Block, passed: &Passed) -> ControlFlow<()> {
        let mut mask = passed.mask;
        while mask != 0 {
            let lane = mask.trailing_zeros() as usize % LEAF;
            mask &= mask - 1;
            let flat = passed.flat(lane);
            let hit = if flat.is_settled() {
                self.triangle(block, lane, &flat)
            } else {
                self.unsettled_triangle(block, lane, flat)
            };
            if let Some(ShapeHit { t, u, v }) = hit {
                self.query.offer(Hit { t, primitive: block.numbers[lane], u, v })?;
            }
        }
        ControlFlow::Continue(())
    }

    #[inline]
    fn shapes(&mut self, places: Range<usize>) -> ControlFlow<()> {
        for &number in &self.order[places] {
            let ray = self.ray();
            self.contents.shape(number, &ray, &mut self.query)?;
        }
        ControlFlow::Continue(())
    }
}

/// Rays that all ask the same question, and what is done with the answers.
pub(crate) struct Each<'a, B, A> {
    pub(crate) rays: &'a [Ray],
    pub(crate) begin: B,
    pub(crate) answer: A,
}

impl<'a, C, Q, B, A> Batch<'a> for Each<'a, B, A>
where
    C: Holds + 'a,
    Q: Query,
    B: Fn(&'a Ray) -> Leaves<'a, C, Q>,
    A: FnMut(usize, &Q),
{
    type Visitor = Leaves<'a, C, Q>;

    fn rays(&self) -> &'a [Ray] {
        self.rays
    }

    #[inline(always)]
    fn begin(&self, index: usize) -> Self::Visitor {
        (self.begin)(&self.rays[index])
    }

    #[inline(always)]
    fn end(&mut self, index: usize, visitor: &Self::Visitor) {
        (self.answer)(index, &visitor.query);
    }
}
