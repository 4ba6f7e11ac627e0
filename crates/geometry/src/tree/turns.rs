//! Ways through a tree that take turns: while one waits for memory or for a result, others
//! go on.

use super::Tree;
use super::prefetch::Ahead;
use super::stack::{Room, Stack};

/// So many at once are best where the tree does not fit into the cache of a core.
const MANY: usize = 8;

/// Questions under way.
pub(super) trait Way<B> {
    /// Opens one box; tells whether there is another.
    fn step(&mut self, tree: &Tree, ahead: &Ahead, stack: &mut Stack) -> bool;

    /// Hands the answers over, once there is no box left.
    fn end(&self, batch: &mut B);
}

/// Questions to begin with, one after the other.
pub(super) trait Waiting<B, W: Way<B>> {
    /// Tells one from the others.
    type Question;

    fn next(&mut self) -> Option<Self::Question>;

    fn begin(&self, question: Self::Question, batch: &B) -> W;

    /// [`begin`](Self::begin) in the place of a way that has come to its end.
    fn begin_anew(&self, question: Self::Question, batch: &B, way: &mut W);
}

/// One of those that take turns.
struct Slot<'r, W> {
    way: W,
    stack: Stack<'r>,
    is_done: bool,
}

/// Takes all ways to their ends, each one box further in turn: up to `few` at once where the
/// tree fits into the cache of a core, and [`MANY`] where it does not.
#[inline(always)]
pub(super) fn take_turns<B, W: Way<B>>(
    tree: &Tree,
    few: usize,
    batch: &mut B,
    waiting: &mut impl Waiting<B, W>,
) {
    let ahead = Ahead::of(tree);
    let count = if tree.is_cached() { few } else { MANY };
    let mut rooms = [const { Room::new() }; MANY];
    let mut slots = Vec::with_capacity(MANY);
    for room in rooms.iter_mut().take(count) {
        let Some(question) = waiting.next() else { break };
        let way = waiting.begin(question, batch);
        slots.push(Slot { way, stack: Stack::new(room), is_done: false });
    }
    while !slots.is_empty() {
        let mut is_any_done = false;
        for Slot { way, stack, is_done } in &mut slots {
            if way.step(tree, &ahead, stack) {
                continue;
            }
            way.end(batch);
            if let Some(question) = waiting.next() {
                waiting.begin_anew(question, batch, way);
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
