//! The shares of the children of a node in its choices.

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
    /// The shares, not yet of one in all.
    each: [f64; WIDTH],
    sum: f64,
}

/// One turn of a choice.
pub(super) struct Turn {
    pub(super) child: usize,
    /// The rest of the number that decided it.
    pub(super) rest: Rest,
}

/// A number that is uniform on an interval from zero.
#[derive(Clone, Copy)]
pub(super) struct Rest {
    at: f64,
    end: f64,
}

impl Rest {
    /// One that is uniform on [0, 1).
    #[inline]
    pub(super) fn of(u: f64) -> Self {
        Self { at: u, end: 1.0 }
    }

    /// Stretched to [0, 1). Not before it is needed: it never is of the last turn.
    #[inline]
    pub(super) fn stretched(self) -> f64 {
        (self.at / self.end).min(BELOW_ONE)
    }
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
    #[expect(clippy::needless_bitwise_bool, reason = "a lazy `and` would be a branch")]
    pub(super) fn turn(&self, u: f64) -> Turn {
        let at = u * self.sum;
        let [a, b, c, _] = self.each;
        let starts = [0.0, a, a + b, a + b + c];
        let mut child = 0;
        for (other, (&share, start)) in self.each.iter().zip(starts).enumerate() {
            // The last that has any share is taken at the latest: what is above all ends
            // is rounding. Without a branch: chance decides, which no processor foresees.
            let is_reached = (share > 0.0) & (at >= start);
            child = if is_reached { other } else { child };
        }
        Turn { child, rest: Rest { at: at - starts[child], end: self.each[child] } }
    }
}
