//! How the children of a node share its choices.

use super::node::{Importance, Node, WIDTH};
use traylib_math::Vec3;
use traylib_math::glam::Vec4;

/// The largest number below one.
pub(super) const BELOW_ONE: f64 = 1.0 - f64::EPSILON / 2.0;

/// The least share of a child that may give a point light, in the sum of what all may
/// give.
pub(super) const RAREST: f32 = 1.0 / 256.0;

/// Shares of children in proportion to what they may give a point: those that cannot light
/// it have none. Where none can, or the squares of distances leave the range of single
/// precision, they are as the strengths.
pub(super) struct Shares {
    /// Not yet of one in all.
    each: [f64; WIDTH],
    sum: f64,
}

/// One turn of a choice.
pub(super) struct Turn {
    pub(super) child: usize,
    /// What is left of the number that decided it, stretched to [0, 1) again.
    pub(super) rest: f64,
}

impl Shares {
    #[inline]
    pub(super) fn new(node: &Node, x1: Vec3) -> Self {
        let Importance { value, shines } = node.importance(x1);
        let candidates = if shines.any() { shines } else { node.exists() };
        let [value, intensity] =
            [value, node.intensity].map(|weights| Vec4::select(candidates, weights, Vec4::ZERO));
        let total = value.element_sum();
        // Of less, the floor would be rounded.
        let known = total > f32::MIN_POSITIVE / RAREST && total.is_finite();
        let (weights, total) =
            if known { (value, total) } else { (intensity, intensity.element_sum()) };
        let shares = weights.max(Vec4::splat(RAREST * total));
        let each = Vec4::select(candidates, shares, Vec4::ZERO).to_array().map(f64::from);
        Self { each, sum: each.iter().sum() }
    }

    /// The chance of a child.
    #[inline]
    pub(super) fn chance(&self, child: usize) -> f32 {
        (self.each[child] / self.sum) as f32
    }

    /// The child to which a number from [0, 1) falls. Of shares in single precision, sums in
    /// double precision are exact, so each falls as often as its chance says.
    #[inline]
    pub(super) fn turn(&self, u: f64) -> Turn {
        let at = u * self.sum;
        let (mut child, mut start, mut end) = (0, 0.0, 0.0);
        for (other, &share) in self.each.iter().enumerate() {
            // The last that has any share is taken at the latest: what is above all ends
            // is rounding.
            if share > 0.0 && at >= end {
                (child, start) = (other, end);
            }
            end += share;
        }
        Turn { child, rest: ((at - start) / self.each[child]).min(BELOW_ONE) }
    }
}
