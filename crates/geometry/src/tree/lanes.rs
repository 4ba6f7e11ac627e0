//! Eight rays side by side, a lane each, and the triangles that they meet together.

mod candidates;
mod exact;
mod fast;
pub(crate) mod rays;
pub(crate) mod triangles;
