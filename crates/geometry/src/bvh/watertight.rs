//! Triangles in blocks, met in double precision from the sides that they have.

use super::contents::{Holds, Leaves, offer};
use crate::tree::block::Block;
use crate::tree::eights::Eights;
use crate::tree::fan::sight::Sight;
use crate::tree::lanes;
use crate::tree::mask::ones;
use crate::tree::query::Query;
use crate::tree::visitor::Visitors;
use crate::{Ray, watertight};
use std::ops::ControlFlow;

#[inline(always)]
pub(super) fn hits<L: lanes::Triangles, Q: Query>(
    block: &Block,
    lanes: &L,
    ray: &Ray,
    query: &mut Q,
) -> ControlFlow<()> {
    let candidates = lanes.candidates(block, query.limit());
    if candidates == 0 {
        return ControlFlow::Continue(());
    }
    let hits = lanes.meet(block, candidates, ray, query.limit());
    for lane in ones(hits.mask) {
        if block.admits(lane, ray.direction) {
            offer(Some(hits.hit(lane)), block.number(lane), query)?;
        }
    }
    ControlFlow::Continue(())
}

#[inline(always)]
pub(super) fn fan<C: Holds, E: Eights, Q: Query>(
    rays: &mut Visitors<Leaves<'_, C, Q>>,
    active: u32,
    block: &Block,
    sight: &Sight<E>,
) {
    for (lane, candidates) in sight.candidates(block, active, &rays.limits) {
        let number = block.number(lane);
        if let Some(hits) = sight.meet(block, lane, candidates, &rays.limits) {
            rays.tell(hits.mask, |i, Leaves { ray, query, .. }| {
                let hit = block.admits(lane, ray.direction).then(|| hits.hit(i));
                offer(hit, number, query)
            });
        } else {
            one_by_one(rays, candidates, block, lane);
        }
    }
}

/// Where rounding decides for one of the rays.
#[cold]
#[inline(never)]
fn one_by_one<C: Holds, Q: Query>(
    rays: &mut Visitors<Leaves<'_, C, Q>>,
    candidates: u32,
    block: &Block,
    lane: usize,
) {
    rays.tell(candidates, |_, Leaves { ray, query, .. }| {
        let axes = watertight::axes(&ray.direction);
        let hit = watertight::meet(ray, axes, query.limit(), block.picked(lane, axes));
        offer(hit.filter(|_| block.admits(lane, ray.direction)), block.number(lane), query)
    });
}
