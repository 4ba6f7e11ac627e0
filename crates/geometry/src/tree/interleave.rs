//! Interleaved traversal: while one ray or packet waits for memory or for a result, others
//! go on.

use super::Tree;
use super::prefetch::Prefetcher;
use super::stack::{Stack, StackMemory};

/// The number of rays at once that is best where the tree does not fit into the cache of a core.
const MANY: usize = 8;

/// A ray, or a packet of rays, that is on its way through the tree.
pub(super) trait InFlight<B> {
    /// Opens one box; tells whether there is another.
    fn step(&mut self, tree: &Tree, prefetcher: &Prefetcher, stack: &mut Stack) -> bool;

    /// Hands the answers over, once there is no box left.
    fn end(&self, batch: &mut B);
}

/// Rays, or packets of rays, that are to begin, one after the other.
pub(super) trait Queue<B, T: InFlight<B>> {
    /// Tells one from the others.
    type Item;

    /// The next, if there is one.
    fn next(&mut self) -> Option<Self::Item>;

    /// Puts it before the root.
    fn begin(&self, item: Self::Item, batch: &B) -> T;

    /// [`begin`](Self::begin) in the place of one that has come to its end.
    fn begin_anew(&self, item: Self::Item, batch: &B, ended: &mut T);
}

/// One of those that go on in turn.
struct Slot<'r, T> {
    in_flight: T,
    stack: Stack<'r>,
    is_done: bool,
}

/// Takes all of a queue to their ends, each one box further in turn: up to `few` at once
/// where the tree fits into the cache of a core, and [`MANY`] where it does not.
#[inline(always)]
pub(super) fn interleave<B, T: InFlight<B>>(
    tree: &Tree,
    few: usize,
    batch: &mut B,
    queue: &mut impl Queue<B, T>,
) {
    let prefetcher = Prefetcher::of(tree);
    let count = if tree.is_cached() { few } else { MANY };
    let mut memories = [const { StackMemory::new() }; MANY];
    let mut slots = Vec::with_capacity(MANY);
    for memory in memories.iter_mut().take(count) {
        let Some(item) = queue.next() else { break };
        let in_flight = queue.begin(item, batch);
        slots.push(Slot { in_flight, stack: Stack::new(memory), is_done: false });
    }
    while !slots.is_empty() {
        let mut is_any_done = false;
        for Slot { in_flight, stack, is_done } in &mut slots {
            if in_flight.step(tree, &prefetcher, stack) {
                continue;
            }
            in_flight.end(batch);
            if let Some(item) = queue.next() {
                queue.begin_anew(item, batch, in_flight);
                stack.clear();
            } else {
                (*is_done, is_any_done) = (true, true);
            }
        }
        if is_any_done {
            slots.retain(|slot| !slot.is_done);
        }
    }
}
