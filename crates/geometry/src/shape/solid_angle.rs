//! Flat shapes as a point in front of them sees them: where each steradian of theirs is drawn
//! as often as any other, light of theirs has no more noise than the surface it falls on
//! gives it. By area, what is close weighs without bound.
//!
//! All in double precision, in which single coordinates leave room for the nearest and the
//! most slanting view.

mod rectangle;
mod triangle;

pub(crate) use rectangle::SphericalRectangle;
pub(crate) use triangle::SphericalTriangle;

use crate::Vec3;

/// A view of less than so many steradians is not parted any further: what double precision
/// rounds is then 2⁻²² of it, as much as single precision rounds of any number.
const LEAST: f64 = 1.0 / (1 << 30) as f64;

/// Tells whether a shape is sampled by area, since its centre, here from the viewpoint, is further
/// away than it is wide. Its points' density per steradian is then nowhere more than 27 times what
/// it is elsewhere, (1.5 / 0.5)³, and seldom twice, so that evening it out gains little more.
#[inline]
fn is_far(width_squared: f32, centre: Vec3) -> bool {
    width_squared < centre.length_squared()
}

#[cfg(test)]
mod tests;
