//! Asking for memory before it is needed.

#![allow(unsafe_code)]

use super::Tree;
use super::block::Block;
use super::node::{Child, Node};

/// Bytes that memory moves at once.
const LINE: usize = 64;

/// The addresses of nodes and blocks of a tree.
pub(crate) struct Prefetcher {
    /// The addresses at which the nodes start and how large each is, and the same for blocks of
    /// triangles. Looked up by kind: a branch on what comes next would be hard to predict.
    lists: [(*const u8, usize); 2],
    is_of_use: bool,
}

impl Prefetcher {
    #[inline(always)]
    pub(crate) fn of(tree: &Tree) -> Self {
        let nodes = (tree.nodes.as_ptr().cast(), size_of::<Node>());
        let blocks = (tree.triangles.as_ptr().cast(), size_of::<Block>());
        Self { lists: [nodes, blocks], is_of_use: !tree.is_cached() }
    }

    /// Asks for what is in a box, which will be opened soon. For what is neither a node nor
    /// a block of triangles it asks in vain.
    #[inline(always)]
    pub(crate) fn ask(&self, child: Child) {
        if self.is_of_use {
            let (start, size) = self.lists[usize::from(child.is_leaf())];
            let start = start.wrapping_add(child.index().wrapping_mul(size));
            prefetch(start);
            prefetch(start.wrapping_add(LINE));
            prefetch(start.wrapping_add(2 * LINE));
            prefetch(start.wrapping_add(size - 1));
        }
    }
}

/// Asks for a line; does nothing on machines other than x86-64.
#[inline(always)]
fn prefetch(place: *const u8) {
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: prefetching changes nothing and fails at no address.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(place.cast()) };
    }
    #[cfg(any(not(target_arch = "x86_64"), miri))]
    let _ = place;
}
