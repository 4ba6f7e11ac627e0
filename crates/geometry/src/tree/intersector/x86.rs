//! The kernels for x86-64: AVX2, and SSE4.1 for older machines.
//!
//! A type exists only where its instructions do: that is the promise of its
//! `new`, and what makes its methods sound. They are inlined into a function that
//! is compiled for those instructions.

#![allow(unsafe_code)]
// Nodes and blocks are aligned to what is read of them; the names of the instructions
// tell where they come from.
#![allow(clippy::cast_ptr_alignment, clippy::wildcard_imports)]

mod avx2;
mod boxes;
mod exact;
mod sse41;
mod triangles;

pub(crate) use avx2::Avx2;
pub(crate) use sse41::Sse41;
pub(crate) use triangles::TriangleRay;
