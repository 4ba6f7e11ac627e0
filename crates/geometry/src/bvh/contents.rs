//! What a tree can hold.

use crate::shape::ShapeHit;
use crate::tree::batch::Batch;
use crate::tree::block::Block;
use crate::tree::eights::Eights;
use crate::tree::fan::sight::Sight;
use crate::tree::lanes::Triangles;
use crate::tree::query::Query;
use crate::tree::visitor::{Visitor, Visitors};
use crate::{Hit, Ray};
use std::ops::{ControlFlow, Range};

/// What a [`Bvh`](crate::Bvh) can hold: [`Triangles`](crate::Triangles),
/// [`Shapes`](crate::Shapes) or [`Instances`](crate::Instances).
#[expect(private_bounds, reason = "there are these three; others come as shapes")]
pub trait Contents: Holds {}

impl<C: Holds> Contents for C {}

pub(crate) trait Holds: Send + Sync + Sized {
    /// Numbers of shapes are below this.
    fn count(&self) -> u32;

    /// Offers the hits with the triangles of a block. `lanes` are those of the ray.
    fn triangles<T: Triangles, Q: Query>(
        &self,
        block: &Block,
        lanes: &T,
        ray: &Ray,
        query: &mut Q,
    ) -> ControlFlow<()>;

    /// Offers the hits with the triangles of a block to those rays of a fan that have a bit.
    fn fan<E: Eights, Q: Query>(
        &self,
        rays: &mut Visitors<Leaves<'_, Self, Q>>,
        active: u32,
        block: &Block,
        sight: &Sight<E>,
    );

    /// Offers the hits with shape `number`, which is no triangle.
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
    pub(super) fn ray(&self) -> Ray {
        Ray { t_max: self.query.limit(), ..*self.ray }
    }
}

impl<C: Holds, Q: Query> Visitor for Leaves<'_, C, Q> {
    const IN_ORDER: bool = Q::IN_ORDER;

    #[inline]
    fn limit(&self) -> f32 {
        self.query.limit()
    }

    #[inline(always)]
    fn triangles<T: Triangles>(&mut self, block: &Block, lanes: &T) -> ControlFlow<()> {
        self.contents.triangles(block, lanes, self.ray, &mut self.query)
    }

    #[inline(always)]
    fn fan<E: Eights>(rays: &mut Visitors<Self>, active: u32, block: &Block, sight: &Sight<E>) {
        rays.each[0].contents.fan(rays, active, block, sight);
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
