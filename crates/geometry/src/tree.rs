//! Trees of boxes, eight a node: how they are built and how a ray walks them.
//!
//! A tree holds numbers that the caller gave, and the triangles, quads, spheres and disks
//! among what they stand for; what else they stand for it does not know.

pub(crate) mod batch;
pub(crate) mod block;
pub(crate) mod build;
mod extents;
mod interleave;
pub(crate) mod intersector;
pub(crate) mod kernel;
pub(crate) mod lanes;
pub(crate) mod mask;
pub(crate) mod node;
pub(crate) mod packet;
pub(crate) mod pages;
pub(crate) mod parallel;
mod prefetch;
pub(crate) mod query;
pub(crate) mod shape_block;
pub(crate) mod simd;
mod stack;
pub(crate) mod visitor;
mod walk;

pub(crate) use kernel::Kernel;

use crate::shape::ShapeKind;
use crate::{Aabb, Ray};
use block::Block;
use build::Quality;
use extents::QuantisedExtents;
use node::{BlockKind, Child, LEAF, Node};
use shape_block::{DiskBlock, QuadBlock, SphereBlock};
use std::fmt;
use visitor::Visitor;

/// Blocks, or triangles, that a thread takes at once.
pub(crate) const GRAIN: usize = 1 << 12;

/// The most items that can be numbered: as many as a block has room for.
pub(crate) const MOST: usize = extents::MOST as usize;

/// Trees of up to so many bytes stay in the cache that a core has for itself.
const CACHED: usize = 1 << 20;

/// Trees of more bytes hardly stay in any cache.
const LARGE: usize = 16 << 20;

/// Boxes in boxes, with numbers in the innermost.
#[derive(Clone)]
pub(crate) struct Tree {
    pub(crate) nodes: Vec<Node>,
    pub(crate) triangles: Vec<Block>,
    pub(crate) quads: Vec<QuadBlock>,
    pub(crate) spheres: Vec<SphereBlock>,
    pub(crate) disks: Vec<DiskBlock>,
    /// Numbers of what is in no block, in the order the leaves list them.
    pub(crate) order: Vec<u32>,
    root: Option<Child>,
    /// The extents of its triangles.
    extents: QuantisedExtents,
    /// True if there are any.
    has_triangles: bool,
    /// Levels of nodes.
    #[cfg(test)]
    pub(crate) depth: usize,
    pub(crate) kernel: Kernel,
    /// Bytes on the heap.
    pub(crate) memory: usize,
}

/// Shows its size. All else follows from the shapes and, in part, from the processor.
impl fmt::Debug for Tree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Tree").field("nodes", &self.nodes.len()).finish_non_exhaustive()
    }
}

impl Tree {
    /// The tree over the `items`, whose bounds are `boxes[item]`, finite and not
    /// empty. `kind` says what they are.
    pub(crate) fn new(
        boxes: Vec<Aabb>,
        items: Vec<u32>,
        kind: impl Fn(u32) -> ShapeKind + Send + Sync,
        quality: Quality,
    ) -> Self {
        let extents = QuantisedExtents::up_to(greatest_extent(&boxes));
        let built = build::build(boxes, items, |number| BlockKind::of(kind(number)), quality);
        let [triangles, quads, spheres, disks] = &built.blocks;
        let triangles = blocks(triangles, |numbers| Block::new(numbers, extents, &kind));
        let quads = blocks(quads, |numbers| QuadBlock::new(numbers, &kind));
        let spheres = blocks(spheres, |numbers| SphereBlock::new(numbers, &kind));
        let disks = blocks(disks, |numbers| DiskBlock::new(numbers, &kind));
        let memory = size_of_val(&*built.nodes)
            + size_of_val(&*triangles)
            + size_of_val(&*quads)
            + size_of_val(&*spheres)
            + size_of_val(&*disks)
            + size_of_val(&*built.shapes);
        let has_triangles = triangles.iter().any(|block| block.words[0] != Block::NONE);
        Self {
            nodes: built.nodes,
            triangles,
            quads,
            spheres,
            disks,
            order: built.shapes,
            root: built.root,
            extents,
            has_triangles,
            #[cfg(test)]
            depth: built.depth,
            kernel: Kernel::best(),
            memory,
        }
    }

    /// Takes a ray to the leaves it meets.
    #[inline]
    pub(crate) fn walk<V: Visitor>(&self, ray: &Ray, visitor: &mut V) {
        if let Some(root) = self.root.filter(|_| ray.is_traceable()) {
            self.kernel.walk(self, root, ray, visitor);
        }
    }

    /// Takes many rays to the leaves they meet.
    #[inline]
    pub(crate) fn walk_each<'a, B: batch::Batch<'a>>(&self, batch: &mut B) {
        if let Some(root) = self.root {
            self.kernel.walk_each(self, root, batch);
        }
    }

    /// Tells whether all of it is near a processor, so that rays hardly wait for memory.
    #[inline]
    pub(crate) fn is_cached(&self) -> bool {
        self.memory <= CACHED
    }

    /// Tells whether it is far larger than the memory near a processor, so that rays wait for
    /// memory more than for anything else.
    #[inline]
    pub(crate) fn is_large(&self) -> bool {
        self.memory > LARGE
    }
}

/// A block for each list of numbers.
fn blocks<B: Send>(
    numbers: &[[u32; LEAF]],
    block: impl Fn([u32; LEAF]) -> B + Send + Sync,
) -> Vec<B> {
    parallel::map(numbers.len(), GRAIN, |i| block(numbers[i]))
}

/// Returns the greatest extent of all boxes, along an axis.
fn greatest_extent(boxes: &[Aabb]) -> f32 {
    let of = |boxes: &[Aabb]| boxes.iter().map(|b| b.extent().max_element()).fold(0.0, f32::max);
    parallel::chunks(boxes.len(), GRAIN, |range| of(&boxes[range])).into_iter().fold(0.0, f32::max)
}
