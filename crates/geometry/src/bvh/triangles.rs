//! The triangles of a mesh.

use super::leaf::{Leaf, LeafVisitor, offer};
use super::{Bvh, Options, Precision, check_count, watertight, widened};
use crate::f32_filter::Shear;
use crate::shape::ShapeKind;
use crate::tree::block::Block;
use crate::tree::lanes::triangles::PacketTriangles;
use crate::tree::mask::ones;
use crate::tree::node::LEAF;
use crate::tree::query::Query;
use crate::tree::shape_block::{Line, ShapeBlock};
use crate::tree::simd::Simd;
use crate::tree::visitor::Visitors;
use crate::tree::{GRAIN, Tree, intersector, parallel};
use crate::watertight::{axes, meet};
use crate::{Aabb, Error, Mesh, Ray, ShapeHit, SidedTriangle, Sides, Triangle, Vec3};
use std::hint::black_box;
use std::ops::ControlFlow;

/// The leaf kind of a [`Bvh`] of a mesh: its triangles, whose corners are in the tree.
#[derive(Clone, Copy, Debug)]
pub struct Triangles {
    count: u32,
    precision: Precision,
}

impl Bvh {
    /// A tree over the triangles of a mesh, of which there may be none. Those
    /// without area are never hit.
    ///
    /// # Errors
    /// [`Error::TooMany`] for more than 2²⁷ triangles.
    pub fn build(mesh: &Mesh) -> Result<Self, Error> {
        Self::build_with(mesh, Options::default())
    }

    /// A tree over the triangles of a mesh, built and asked as the options say.
    ///
    /// # Errors
    /// [`Error::TooMany`] for more than 2²⁷ triangles.
    pub fn build_with(mesh: &Mesh, options: Options) -> Result<Self, Error> {
        check_count(mesh.triangle_count())?;
        let corners = |i: u32| mesh.corner_positions(i as usize);
        let count = mesh.triangle_count() as u32;
        let boxes = parallel::map(count as usize, GRAIN, |i| bounds(corners(i as u32)));
        let items = parallel::filter(boxes.len(), GRAIN, |i| !boxes[i].is_empty());
        let bounds = around(&boxes);
        let triangle =
            |i| ShapeKind::Triangle(SidedTriangle { corners: corners(i), sides: Sides::Both });
        let tree = Tree::new(boxes, items, triangle, options.quality);
        Ok(Self { tree, primitives: Triangles { count, precision: options.precision }, bounds })
    }
}

/// The box around all boxes.
fn around(boxes: &[Aabb]) -> Aabb {
    let union = |boxes: &[Aabb]| boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
    union(&parallel::chunks(boxes.len(), GRAIN, |range| union(&boxes[range])))
}

/// The box around a triangle, with room for rounding; empty without area.
fn bounds(corners: [Vec3; 3]) -> Aabb {
    if Triangle::has_area(corners) { widened(&Aabb::around(corners)) } else { Aabb::EMPTY }
}

impl Leaf for Triangles {
    const ONLY_TRIANGLES: bool = true;

    fn count(&self) -> u32 {
        self.count
    }

    #[inline(always)]
    fn triangles<L: intersector::TriangleIntersector, Q: Query>(
        &self,
        block: &Block,
        intersector: &L,
        ray: &Ray,
        query: &mut Q,
    ) -> ControlFlow<()> {
        match self.precision {
            Precision::Watertight => watertight::hits(block, intersector, ray, query),
            Precision::Fast => fast_hits(block, intersector, ray, query),
        }
    }

    #[inline(always)]
    fn packet<E: Simd, Q: Query>(
        &self,
        rays: &mut Visitors<LeafVisitor<'_, Self, Q>>,
        active: u32,
        block: &Block,
        triangles: &PacketTriangles<E>,
    ) {
        match self.precision {
            Precision::Watertight => watertight::packet(rays, active, block, triangles),
            Precision::Fast => fast_packet(rays, active, block, triangles),
        }
    }

    /// There is nothing but triangles.
    #[inline]
    fn block<E: Simd, Q: Query>(
        &self,
        _: &impl ShapeBlock,
        _: &Line<E>,
        _: &mut Q,
    ) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// As above.
    #[inline]
    fn shape<Q: Query>(&self, _: u32, _: &Ray, _: &mut Q) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}

#[inline(always)]
fn fast_packet<E: Simd, Q: Query>(
    rays: &mut Visitors<LeafVisitor<'_, Triangles, Q>>,
    active: u32,
    block: &Block,
    triangles: &PacketTriangles<E>,
) {
    let corners = triangles.corners(block);
    let corners = black_box(&corners);
    for lane in 0..LEAF {
        let Some((hits, unsettled)) = triangles.meet_fast(corners, lane, active, &rays.limits)
        else {
            continue;
        };
        let number = block.number(lane);
        rays.tell(hits.mask, |i, leaves| offer(Some(hits.hit(i)), number, &mut leaves.query));
        rays.tell(unsettled, |_, LeafVisitor { ray, query, .. }| {
            offer(unsettled_hit(block, lane, ray, query.limit()), number, query)
        });
    }
}

#[inline(always)]
fn fast_hits<L: intersector::TriangleIntersector, Q: Query>(
    block: &Block,
    intersector: &L,
    ray: &Ray,
    query: &mut Q,
) -> ControlFlow<()> {
    let filtered = intersector.filter(block, query.limit());
    for lane in ones(filtered.mask) {
        let triangle = filtered.triangle(lane);
        let hit = if triangle.is_settled() {
            triangle.meet(query.limit())
        } else {
            unsettled_hit(block, lane, ray, query.limit())
        };
        offer(hit, block.number(lane), query)?;
    }
    ControlFlow::Continue(())
}

/// Meets a triangle where signs are not certain, as exactly as can be, but between the depths of
/// the corners: a triangle that begins beyond a hit by these is not asked.
#[cold]
#[inline(never)]
fn unsettled_hit(block: &Block, lane: usize, ray: &Ray, limit: f32) -> Option<ShapeHit> {
    let triangle = Shear::along(&ray.direction).apply(&block.triangle(lane), ray);
    let axes = axes(&ray.direction);
    let hit = meet(ray, axes, f32::INFINITY, block.picked(lane, axes))?;
    let t = triangle.within(hit.t);
    (0.0 < t && t < limit).then_some(ShapeHit { t, ..hit })
}
