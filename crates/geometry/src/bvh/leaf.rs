//! The leaf kinds: what trees hold.

use crate::ShapeHit;
use crate::tree::batch::Batch;
use crate::tree::block::Block;
use crate::tree::intersector::TriangleIntersector;
use crate::tree::lanes::triangles::PacketTriangles;
use crate::tree::query::Query;
use crate::tree::shape_block::{Line, ShapeBlock};
use crate::tree::simd::Simd;
use crate::tree::visitor::{Visitor, Visitors};
use crate::{Hit, Ray};
use std::ops::{ControlFlow, Range};

/// A leaf kind, which a [`Bvh`](crate::Bvh) holds: [`Triangles`](crate::Triangles),
/// [`Shapes`](crate::Shapes) or [`Instances`](crate::Instances).
#[expect(private_bounds, reason = "there are these three; others come as shapes")]
pub trait LeafKind: Leaf {}

impl<C: Leaf> LeafKind for C {}

pub(crate) trait Leaf: Send + Sync + Sized {
    /// True if all leaves are blocks of triangles.
    const ONLY_TRIANGLES: bool = false;

    /// Numbers of shapes are below this.
    fn count(&self) -> u32;

    /// Offers the hits with the triangles of a block. `intersector` is that of the ray.
    fn triangles<T: TriangleIntersector, Q: Query>(
        &self,
        block: &Block,
        intersector: &T,
        ray: &Ray,
        query: &mut Q,
    ) -> ControlFlow<()>;

    /// Offers the hits with the triangles of a block to those rays of a packet that have a bit.
    fn packet<E: Simd, Q: Query>(
        &self,
        rays: &mut Visitors<LeafVisitor<'_, Self, Q>>,
        active: u32,
        block: &Block,
        triangles: &PacketTriangles<E>,
    );

    /// Offers the hits with the shapes of a block of another kind.
    fn block<E: Simd, Q: Query>(
        &self,
        block: &impl ShapeBlock,
        line: &Line<E>,
        query: &mut Q,
    ) -> ControlFlow<()>;

    /// Offers the hits with shape `number`, which is in no block.
    fn shape<Q: Query>(&self, number: u32, ray: &Ray, query: &mut Q) -> ControlFlow<()>;
}

/// Offers a hit with a shape, if there is one.
#[inline(always)]
pub(super) fn offer<Q: Query>(
    hit: Option<ShapeHit>,
    primitive: u32,
    query: &mut Q,
) -> ControlFlow<()> {
    match hit {
        Some(ShapeHit { t, u, v }) => query.offer(Hit { t, primitive, u, v }),
        None => ControlFlow::Continue(()),
    }
}

/// Asks the primitives of the leaves that a ray comes to.
pub(crate) struct LeafVisitor<'a, C, Q> {
    pub(crate) primitives: &'a C,
    pub(crate) order: &'a [u32],
    pub(crate) ray: &'a Ray,
    pub(crate) query: Q,
}

impl<C: Leaf, Q: Query> LeafVisitor<'_, C, Q> {
    /// The ray as far as anything counts.
    #[inline]
    pub(super) fn limited_ray(&self) -> Ray {
        Ray { t_max: self.query.limit(), ..*self.ray }
    }
}

impl<C: Leaf, Q: Query> Visitor for LeafVisitor<'_, C, Q> {
    const IN_ORDER: bool = Q::IN_ORDER;
    const ONLY_TRIANGLES: bool = C::ONLY_TRIANGLES;

    #[inline]
    fn limit(&self) -> f32 {
        self.query.limit()
    }

    #[inline(always)]
    fn ray(&self) -> &Ray {
        self.ray
    }

    #[inline(always)]
    fn triangles<T: TriangleIntersector>(
        &mut self,
        block: &Block,
        intersector: &T,
    ) -> ControlFlow<()> {
        self.primitives.triangles(block, intersector, self.ray, &mut self.query)
    }

    #[inline(always)]
    fn packet<E: Simd>(
        rays: &mut Visitors<Self>,
        active: u32,
        block: &Block,
        triangles: &PacketTriangles<E>,
    ) {
        rays.each[0].primitives.packet(rays, active, block, triangles);
    }

    #[inline(always)]
    fn block<B: ShapeBlock, E: Simd>(&mut self, block: &B, line: &Line<E>) -> ControlFlow<()> {
        self.primitives.block(block, line, &mut self.query)
    }

    #[inline]
    fn shapes(&mut self, places: Range<usize>) -> ControlFlow<()> {
        for &number in &self.order[places] {
            let ray = self.limited_ray();
            self.primitives.shape(number, &ray, &mut self.query)?;
        }
        ControlFlow::Continue(())
    }
}

/// Rays that all ask the same question, and what is done with the answers.
pub(crate) struct BatchQuery<'a, B, A> {
    pub(crate) rays: &'a [Ray],
    pub(crate) begin: B,
    pub(crate) answer: A,
}

impl<'a, C, Q, B, A> Batch<'a> for BatchQuery<'a, B, A>
where
    C: Leaf + 'a,
    Q: Query,
    B: Fn(&'a Ray) -> LeafVisitor<'a, C, Q>,
    A: FnMut(usize, &Q),
{
    type Visitor = LeafVisitor<'a, C, Q>;

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
