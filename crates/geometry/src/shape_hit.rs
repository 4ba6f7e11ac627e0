//! The hit of a ray with one shape.

/// The hit of a ray with one shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShapeHit {
    /// The parameter along the ray, in units of its direction's length.
    pub t: f32,
    /// First surface coordinate; see [`Hit`](crate::Hit).
    pub u: f32,
    /// Second surface coordinate; see [`Hit`](crate::Hit).
    pub v: f32,
}
