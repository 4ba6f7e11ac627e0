//! The instruction set that walks the tree: told once, when the tree is built.

#![allow(unsafe_code)]

use super::Tree;
use super::batch::{Batch, walk_each};
use super::intersector::Scalar;
use super::node::Child;
use super::packet::walk_packets;
use super::simd::Portable;
use super::visitor::Visitor;
use super::walk::walk;
use crate::Ray;
use std::hint::black_box;
use std::ops::Range;

#[cfg(target_arch = "x86_64")]
use super::intersector::{Avx2, NoTriangles, Sse41, TriangleRay};
#[cfg(target_arch = "x86_64")]
use super::simd::{Avx2Simd, Sse41Simd};

/// An instruction set that this machine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Kernel(Set);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Set {
    Scalar,
    #[cfg(target_arch = "x86_64")]
    Sse41,
    #[cfg(target_arch = "x86_64")]
    Avx2,
}

impl Kernel {
    /// Returns all that this machine can run, the slowest first.
    pub(crate) fn available() -> Vec<Self> {
        let mut sets = vec![Set::Scalar];
        #[cfg(all(target_arch = "x86_64", not(miri)))]
        {
            if is_x86_feature_detected!("sse4.1") {
                sets.push(Set::Sse41);
            }
            if is_x86_feature_detected!("avx2")
                && is_x86_feature_detected!("fma")
                && is_x86_feature_detected!("bmi1")
                && is_x86_feature_detected!("bmi2")
                && is_x86_feature_detected!("lzcnt")
                && is_x86_feature_detected!("popcnt")
            {
                sets.push(Set::Avx2);
            }
        }
        sets.into_iter().map(Self).collect()
    }

    /// The fastest that this machine can run.
    pub(crate) fn best() -> Self {
        Self::available().pop().unwrap_or(Self(Set::Scalar))
    }

    #[inline]
    pub(crate) fn walk<V: Visitor>(self, tree: &Tree, root: Child, ray: &Ray, visitor: &mut V) {
        match self.0 {
            Set::Scalar => walk(tree, root, &Scalar::new(ray), visitor),
            // SAFETY: `available` has seen that the machine has these instructions.
            #[cfg(target_arch = "x86_64")]
            Set::Sse41 if tree.has_triangles => unsafe { walk_sse41(tree, root, ray, visitor) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Set::Sse41 => unsafe { walk_shapes_sse41(tree, root, ray, visitor) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Set::Avx2 if tree.has_triangles => unsafe { walk_avx2(tree, root, ray, visitor) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Set::Avx2 => unsafe { walk_shapes_avx2(tree, root, ray, visitor) },
        }
    }

    #[inline]
    pub(crate) fn walk_each<'a, B: Batch<'a>>(self, tree: &Tree, root: Child, batch: &mut B) {
        match self.0 {
            Set::Scalar => {
                let left = walk_packets(tree, root, Scalar::new, Portable, batch);
                walk_each(tree, root, Scalar::new, batch, left);
            }
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Set::Sse41 => unsafe {
                let left = walk_packets_sse41(tree, root, batch);
                walk_each_sse41(tree, root, batch, left);
            },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            Set::Avx2 => unsafe {
                let left = walk_packets_avx2(tree, root, batch);
                walk_each_avx2(tree, root, batch, left);
            },
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "sse4.1")]
fn walk_sse41<V: Visitor>(tree: &Tree, root: Child, ray: &Ray, visitor: &mut V) {
    // SAFETY: this function runs only where SSE4.1 is.
    let intersector = unsafe { Sse41::new(ray, TriangleRay::<false>::new(ray, tree.extents)) };
    // Behind a black box it stays in memory, where instructions read it as they go;
    // all of it is too much for the registers.
    walk(tree, root, black_box(&intersector), visitor);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
fn walk_avx2<V: Visitor>(tree: &Tree, root: Child, ray: &Ray, visitor: &mut V) {
    // SAFETY: this function runs only where AVX2 and FMA are.
    let intersector = unsafe { Avx2::new(ray, TriangleRay::<true>::new(ray, tree.extents)) };
    walk(tree, root, black_box(&intersector), visitor);
}

/// Through a tree without triangles.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "sse4.1")]
fn walk_shapes_sse41<V: Visitor>(tree: &Tree, root: Child, ray: &Ray, visitor: &mut V) {
    // SAFETY: this function runs only where SSE4.1 is.
    let intersector = unsafe { Sse41::new(ray, NoTriangles) };
    walk(tree, root, black_box(&intersector), visitor);
}

/// Through a tree without triangles.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
fn walk_shapes_avx2<V: Visitor>(tree: &Tree, root: Child, ray: &Ray, visitor: &mut V) {
    // SAFETY: this function runs only where AVX2 and FMA are.
    let intersector = unsafe { Avx2::new(ray, NoTriangles) };
    walk(tree, root, black_box(&intersector), visitor);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "sse4.1")]
fn walk_packets_sse41<'a, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    batch: &mut B,
) -> Vec<Range<usize>> {
    // SAFETY: this function runs only where SSE4.1 is.
    let intersector =
        |ray| unsafe { Sse41::new(ray, TriangleRay::<false>::new(ray, tree.extents)) };
    walk_packets(tree, root, intersector, Sse41Simd, batch)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "sse4.1")]
fn walk_each_sse41<'a, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    batch: &mut B,
    left: Vec<Range<usize>>,
) {
    // SAFETY: this function runs only where SSE4.1 is.
    walk_each(
        tree,
        root,
        |ray| unsafe { Sse41::new(ray, TriangleRay::<false>::new(ray, tree.extents)) },
        batch,
        left,
    );
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
fn walk_packets_avx2<'a, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    batch: &mut B,
) -> Vec<Range<usize>> {
    // SAFETY: this function runs only where AVX2 and FMA are.
    let intersector = |ray| unsafe { Avx2::new(ray, TriangleRay::<true>::new(ray, tree.extents)) };
    // SAFETY: as above.
    let simd = unsafe { Avx2Simd::new() };
    walk_packets(tree, root, intersector, simd, batch)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
fn walk_each_avx2<'a, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    batch: &mut B,
    left: Vec<Range<usize>>,
) {
    // SAFETY: this function runs only where AVX2 and FMA are.
    walk_each(
        tree,
        root,
        |ray| unsafe { Avx2::new(ray, TriangleRay::<true>::new(ray, tree.extents)) },
        batch,
        left,
    );
}
