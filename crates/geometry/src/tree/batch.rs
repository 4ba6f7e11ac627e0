//! Many rays at a time: while one waits for memory, the others go on.

use super::Tree;
use super::lanes::Lanes;
use super::node::{Child, Content};
use super::prepared::Prepared;
use super::stack::{Room, Stack};
use super::walk::Visitor;
use crate::Ray;

/// Rays that are under way at once.
pub(crate) const SLOTS: usize = 4;

/// Questions about many rays, and where the answers go.
pub(crate) trait Batch<'a> {
    type Visitor: Visitor;

    fn rays(&self) -> &'a [Ray];

    fn begin(&self, ray: &'a Ray) -> Self::Visitor;

    fn end(&mut self, index: usize, visitor: &Self::Visitor);
}

struct Slot<'a, 'r, L, V> {
    index: usize,
    current: Child,
    ray: Prepared<'a>,
    lanes: L,
    visitor: V,
    stack: Stack<'r>,
}

#[inline(always)]
pub(crate) fn walk_each<'a, L: Lanes, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    lanes: impl Fn(&Prepared<'a>) -> L,
    batch: &mut B,
) {
    let rays = batch.rays();
    let mut next = 0;
    let mut rooms = [const { Room::new() }; SLOTS];
    let mut rooms = rooms.iter_mut();
    let mut slots: Vec<Slot<L, B::Visitor>> = Vec::with_capacity(SLOTS);
    let mut more = |batch: &B| {
        while next < rays.len() {
            next += 1;
            if rays[next - 1].is_traceable() {
                let ray = Prepared::new(&rays[next - 1]);
                return Some((next - 1, ray, lanes(&ray), batch.begin(&rays[next - 1])));
            }
        }
        None
    };
    for room in &mut rooms {
        let Some((index, ray, lanes, visitor)) = more(batch) else { break };
        slots.push(Slot { index, current: root, ray, lanes, visitor, stack: Stack::new(room) });
    }
    while !slots.is_empty() {
        let mut k = 0;
        while k < slots.len() {
            let slot = &mut slots[k];
            let done = step(tree, slot);
            if done {
                batch.end(slot.index, &slot.visitor);
                if let Some((index, ray, lanes, visitor)) = more(batch) {
                    slot.index = index;
                    slot.current = root;
                    slot.ray = ray;
                    slot.lanes = lanes;
                    slot.visitor = visitor;
                    slot.stack.clear();
                } else {
                    slots.swap_remove(k);
                    continue;
                }
            }
            k += 1;
        }
    }
}

#[inline(always)]
fn step<L: Lanes, V: Visitor>(tree: &Tree, slot: &mut Slot<L, V>) -> bool {
    match slot.current.open() {
        Content::Node(index) => {
            slot.lanes.open(&tree.nodes[index], slot.visitor.limit(), &mut slot.stack);
        }
        Content::Block(index) => {
            let block = &tree.blocks[index];
            let passed = slot.lanes.pass(block);
            if passed.mask != 0 && slot.visitor.triangles(&slot.ray, block, &passed).is_break() {
                return true;
            }
        }
        Content::Shapes(places) => {
            if slot.visitor.shapes(places).is_break() {
                return true;
            }
        }
    }
    match slot.stack.pop(slot.visitor.limit()) {
        Some(next) => {
            slot.current = next;
            tree.prefetch(next);
            false
        }
        None => true,
    }
}
