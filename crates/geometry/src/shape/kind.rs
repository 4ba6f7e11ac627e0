//! The kinds of shapes that trees meet by themselves.

use super::{Disk, Quad, Sides, Sphere};
use crate::Vec3;

/// The kinds of shapes that a tree tells apart: one of those that it keeps copies of and meets
/// several at once, as [`Triangle::intersect`](super::Triangle::intersect) and its likes do and to
/// the same bits, or something else.
#[derive(Clone, Copy, Debug)]
pub enum ShapeKind {
    /// A triangle.
    Triangle(SidedTriangle),
    /// A quad, and where rays may meet it.
    Quad(Quad, Sides),
    /// A sphere, and where rays may meet it.
    Sphere(Sphere, Sides),
    /// A disk, and where rays may meet it.
    Disk(Disk, Sides),
    /// A shape that the one who asks the tree has to meet.
    Other,
}

/// A triangle as trees keep it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SidedTriangle {
    /// Counter-clockwise from the front.
    pub corners: [Vec3; 3],
    /// The sides on which rays may meet it.
    pub sides: Sides,
}
