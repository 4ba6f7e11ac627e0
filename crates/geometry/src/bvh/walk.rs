//! The way of a ray through the tree.

use super::node::{BoxRay, Child, Content, WIDTH};
use super::{Bvh, build};
use crate::Ray;
use std::ops::ControlFlow;

/// In which order the boxes of a node are opened.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// Near boxes first, to shorten the ray early.
    NearestFirst,
    /// As they come, where any hit ends the walk.
    Any,
}

/// Waiting entries a tree of this many levels can need: each level leaves all
/// but one of its boxes behind, and the last has just added one more.
const fn stack_for(depth: usize) -> usize {
    (WIDTH - 1) * depth + 1
}

const SHALLOW: usize = 5;
const USUAL: usize = 16;

/// A box to be opened later, and where the ray enters it.
type Waiting = (f32, Child);

impl<S> Bvh<S> {
    /// Calls `visit` with the shapes of each leaf whose box the ray meets until it
    /// breaks. It may shorten the ray it is given.
    #[inline]
    pub(super) fn walk(
        &self,
        ray: &Ray,
        order: Order,
        visit: impl FnMut(&mut Ray, &[u32]) -> ControlFlow<()>,
    ) {
        let Some(root) = self.root.filter(|_| ray.is_traceable()) else { return };
        // Clearing a stack for the deepest tree would cost small scenes dearly.
        if self.depth <= SHALLOW {
            self.walk_from::<{ stack_for(SHALLOW) }>(root, *ray, order, visit);
        } else if self.depth <= USUAL {
            self.walk_from::<{ stack_for(USUAL) }>(root, *ray, order, visit);
        } else {
            self.walk_from::<{ stack_for(build::MAX_DEPTH) }>(root, *ray, order, visit);
        }
    }

    #[inline]
    fn walk_from<const STACK: usize>(
        &self,
        root: Child,
        mut ray: Ray,
        order: Order,
        mut visit: impl FnMut(&mut Ray, &[u32]) -> ControlFlow<()>,
    ) {
        let box_ray = BoxRay::new(&ray);
        let mut stack: [Waiting; STACK] = [(0.0, root); STACK];
        let mut waiting = 1;
        while waiting > 0 {
            waiting -= 1;
            let (enter, child) = stack[waiting];
            if enter > ray.t_max {
                continue;
            }
            match child.open() {
                Content::Shapes(range) => {
                    if visit(&mut ray, &self.order[range]).is_break() {
                        return;
                    }
                }
                Content::Node(index) => {
                    let node = &self.nodes[index];
                    let (enter, met) = box_ray.meet(node, ray.t_max);
                    let enter = enter.to_array();
                    waiting = push(&mut stack, waiting, order, enter, met, &node.children);
                }
            }
        }
    }
}

/// Adds the boxes in the bit set `met`, the last to open first; returns the new
/// number of entries.
#[inline]
fn push(
    stack: &mut [Waiting],
    bottom: usize,
    order: Order,
    enter: [f32; WIDTH],
    mut met: u32,
    children: &[Child; WIDTH],
) -> usize {
    let mut top = bottom;
    while met != 0 {
        let lane = met.trailing_zeros() as usize % WIDTH;
        met &= met - 1;
        let mut place = top;
        let nearest_first = order == Order::NearestFirst;
        while nearest_first && place > bottom && stack[place - 1].0 < enter[lane] {
            stack[place] = stack[place - 1];
            place -= 1;
        }
        stack[place] = (enter[lane], children[lane]);
        top += 1;
    }
    top
}
