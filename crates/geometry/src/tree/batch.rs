//! Many rays at a time: while one waits for memory or for a result, others go on.

use super::Tree;
use super::lanes::Lanes;
use super::node::{Child, Content};
use super::prefetch::Ahead;
use super::stack::{Room, Stack};
use super::walk::{Visitor, visit};
use crate::Ray;
use std::ops::Range;

/// The most rays under way at once.
const MOST: usize = 8;

/// So many are best where the tree fits into the caches.
const FEW: usize = 4;

/// Questions about many rays, and where the answers go.
pub(crate) trait Batch<'a> {
    type Visitor: Visitor;

    fn rays(&self) -> &'a [Ray];

    /// What ray `index` asks of the leaves.
    fn begin(&self, index: usize) -> Self::Visitor;

    /// Takes the answer for ray `index`, once all its leaves have been visited.
    fn end(&mut self, index: usize, visitor: &Self::Visitor);
}

/// A ray under way.
struct Slot<'r, L, V> {
    index: usize,
    next: Option<usize>,
    current: Child,
    lanes: L,
    visitor: V,
    stack: Stack<'r>,
}

/// Takes the rays at these places to their leaves, each one box further in turn.
#[inline(always)]
pub(crate) fn walk_each<'a, L: Lanes, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    lanes: impl Fn(&'a Ray) -> L,
    batch: &mut B,
    left: Vec<Range<usize>>,
) {
    let (rays, ahead) = (batch.rays(), Ahead::of(tree));
    let (mut left, mut places) = (left.into_iter(), 0..0);
    let mut waiting = std::iter::from_fn(|| {
        loop {
            match places.next() {
                Some(index) if rays[index].is_traceable() => return Some(index),
                Some(_) => {}
                None => places = left.next()?,
            }
        }
    });
    let mut rooms = [const { Room::new() }; MOST];
    let mut slots = Vec::with_capacity(MOST);
    for room in rooms.iter_mut().take(if tree.is_large() { MOST } else { FEW }) {
        let Some(index) = waiting.next() else { break };
        let (lanes, visitor) = (lanes(&rays[index]), batch.begin(index));
        slots.push(Slot {
            index,
            next: Some(index),
            current: root,
            lanes,
            visitor,
            stack: Stack::new(room),
        });
    }
    while !slots.is_empty() {
        let mut done = false;
        for slot in &mut slots {
            if step(tree, &ahead, slot) {
                continue;
            }
            batch.end(slot.index, &slot.visitor);
            slot.next = waiting.next();
            if let Some(index) = slot.next {
                slot.index = index;
                slot.current = root;
                slot.lanes = lanes(&rays[index]);
                slot.visitor = batch.begin(index);
                slot.stack.clear();
            } else {
                done = true;
            }
        }
        if done {
            slots.retain(|slot| slot.next.is_some());
        }
    }
}

/// Opens one box; tells whether there is another.
#[inline(always)]
fn step<L: Lanes, V: Visitor>(tree: &Tree, ahead: &Ahead, slot: &mut Slot<L, V>) -> bool {
    let Slot { current, lanes, visitor, stack, .. } = slot;
    if let Content::Node(index) = current.open() {
        let node = &tree.nodes[index];
        lanes.open(node, &node.children, visitor.limit(), stack);
    } else if visit(tree, *current, lanes, visitor).is_break() {
        return false;
    }
    let Some(next) = stack.pop(visitor.limit()) else { return false };
    *current = next;
    ahead.ask(next);
    true
}
