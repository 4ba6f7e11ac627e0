//! Shapes of any kind.

use super::leaf::{Leaf, LeafVisitor, offer};
use super::{Bvh, check_count, watertight, widened};
use crate::shape::ShapeList;
use crate::tree::Tree;
use crate::tree::block::Block;
use crate::tree::build::Quality;
use crate::tree::intersector::TriangleIntersector;
use crate::tree::lanes::triangles::PacketTriangles;
use crate::tree::query::Query;
use crate::tree::shape_block::{Line, ShapeBlock};
use crate::tree::simd::Simd;
use crate::tree::visitor::Visitors;
use crate::{Aabb, Error, Ray};
use std::ops::ControlFlow;

/// The leaf kind of a [`Bvh`] of shapes: spheres, quads, disks, triangles, or whatever a
/// guest brings, in a [`ShapeList`].
#[derive(Clone, Debug)]
pub struct Shapes<L>(L);

impl<L: ShapeList> Bvh<Shapes<L>> {
    /// A tree over shapes, of which there may be none.
    ///
    /// # Errors
    /// [`Error::UnboundedShape`] when bounds are infinite or not numbers,
    /// [`Error::TooMany`] for more than 2²⁷ shapes.
    pub fn of_shapes(shapes: L) -> Result<Self, Error> {
        let count = shapes.count();
        check_count(count)?;
        let (boxes, bounds) = sound((0..count).map(|index| shapes.bounds(index)))?;
        let items = (0..count as u32).collect();
        let kind = |number: u32| shapes.kind(number as usize);
        let tree = Tree::new(boxes, items, kind, Quality::default());
        Ok(Self { tree, primitives: Shapes(shapes), bounds })
    }

    /// The caller's shapes, which [`Hit::primitive`](crate::Hit::primitive) counts.
    pub fn shapes(&self) -> &L {
        &self.primitives.0
    }

    /// The caller's shapes, for another tree.
    pub fn into_shapes(self) -> L {
        self.primitives.0
    }
}

/// The boxes widened, and the box around them all.
fn sound(bounds: impl Iterator<Item = Aabb>) -> Result<(Vec<Aabb>, Aabb), Error> {
    let (mut boxes, mut all) = (Vec::with_capacity(bounds.size_hint().0), Aabb::EMPTY);
    for (index, bounds) in bounds.enumerate() {
        if !bounds.is_finite() || bounds.is_empty() {
            return Err(Error::UnboundedShape { index });
        }
        all = all.union(bounds);
        boxes.push(widened(&bounds));
    }
    Ok((boxes, all))
}

impl<L: ShapeList> Leaf for Shapes<L> {
    fn count(&self) -> u32 {
        self.0.count() as u32
    }

    #[inline(always)]
    fn triangles<T: TriangleIntersector, Q: Query>(
        &self,
        block: &Block,
        intersector: &T,
        ray: &Ray,
        query: &mut Q,
    ) -> ControlFlow<()> {
        watertight::hits(block, intersector, ray, query)
    }

    #[inline(always)]
    fn packet<E: Simd, Q: Query>(
        &self,
        rays: &mut Visitors<LeafVisitor<'_, Self, Q>>,
        active: u32,
        block: &Block,
        triangles: &PacketTriangles<E>,
    ) {
        watertight::packet(rays, active, block, triangles);
    }

    #[inline(always)]
    fn block<E: Simd, Q: Query>(
        &self,
        block: &impl ShapeBlock,
        line: &Line<E>,
        query: &mut Q,
    ) -> ControlFlow<()> {
        let limit = query.limit();
        block.each_hit(line, limit, |number, hit| offer(Some(hit), number, query))
    }

    #[inline]
    fn shape<Q: Query>(&self, number: u32, ray: &Ray, query: &mut Q) -> ControlFlow<()> {
        offer(self.0.intersect(number as usize, ray), number, query)
    }
}
