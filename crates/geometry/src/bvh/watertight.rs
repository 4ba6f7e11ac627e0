//! Triangles in blocks, met in double precision from the sides that they have.

use super::leaf::{Leaf, LeafVisitor, offer};
use crate::tree::block::Block;
use crate::tree::intersector;
use crate::tree::lanes::triangles::PacketTriangles;
use crate::tree::mask::ones;
use crate::tree::query::Query;
use crate::tree::simd::Simd;
use crate::tree::visitor::Visitors;
use crate::{Ray, watertight};
use std::ops::ControlFlow;

#[inline(always)]
pub(super) fn hits<L: intersector::TriangleIntersector, Q: Query>(
    block: &Block,
    intersector: &L,
    ray: &Ray,
    query: &mut Q,
) -> ControlFlow<()> {
    let candidates = intersector.candidates(block, query.limit());
    if candidates == 0 {
        return ControlFlow::Continue(());
    }
    let hits = intersector.meet(block, candidates, ray, query.limit());
    for lane in ones(hits.mask) {
        if block.admits(lane, ray.direction) {
            offer(Some(hits.hit(lane)), block.number(lane), query)?;
        }
    }
    ControlFlow::Continue(())
}

#[inline(always)]
pub(super) fn packet<C: Leaf, E: Simd, Q: Query>(
    rays: &mut Visitors<LeafVisitor<'_, C, Q>>,
    active: u32,
    block: &Block,
    triangles: &PacketTriangles<E>,
) {
    for (lane, candidates) in triangles.candidates(block, active, &rays.limits) {
        let number = block.number(lane);
        if let Some(hits) = triangles.meet(block, lane, candidates, &rays.limits) {
            rays.tell(hits.mask, |i, LeafVisitor { ray, query, .. }| {
                let hit = block.admits(lane, ray.direction).then(|| hits.hit(i));
                offer(hit, number, query)
            });
        } else {
            one_by_one(rays, candidates, block, lane);
        }
    }
}

/// Meets the rays one by one, where rounding decides for one of them.
#[cold]
#[inline(never)]
fn one_by_one<C: Leaf, Q: Query>(
    rays: &mut Visitors<LeafVisitor<'_, C, Q>>,
    candidates: u32,
    block: &Block,
    lane: usize,
) {
    rays.tell(candidates, |_, LeafVisitor { ray, query, .. }| {
        let axes = watertight::axes(&ray.direction);
        let hit = watertight::meet(ray, axes, query.limit(), block.picked(lane, axes));
        offer(hit.filter(|_| block.admits(lane, ray.direction)), block.number(lane), query)
    });
}
