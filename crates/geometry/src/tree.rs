//! Trees of boxes, eight a node: how they are built and how a ray walks them.
//!
//! What lies in the leaves is numbered by the caller; a tree holds no shape, only
//! the corners of triangles.

mod build;
mod node;
mod parallel;
