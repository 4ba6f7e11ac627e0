//! Which connections are worth a shadow ray.

use traylib_math::{Rgb, Sampler};

/// A connection that would add less than this part of what the camera path has
/// found by itself is tried in proportion to what it would add.
///
/// On `cornell` this takes the shadow rays of a pair of paths from 14.0 to 6.9
/// and adds 0.4 % to the error of as many passes; 0.1 would leave 8.6 and add
/// 0.1 %.
const HARDLY: f32 = 0.3;

/// Roulette before the shadow ray of a connection.
///
/// A connection that would add c, less than a threshold τ, is tried with
/// probability c/τ and then counts as τ. That is unbiased, and since τ is a small
/// part of what the path has found by itself, no new noise stands out. A path
/// that found nothing has no threshold.
pub(super) struct Worth<'a> {
    threshold: f32,
    sampler: &'a mut Sampler,
}

impl<'a> Worth<'a> {
    /// For connections of a camera path that has `found` this by itself.
    pub(super) fn beside(found: Rgb, sampler: &'a mut Sampler) -> Self {
        Self { threshold: HARDLY * found.max_band(), sampler }
    }

    /// The chance with which a connection that would add this is tried; `None` if
    /// it is not. It draws one number whatever the answer.
    pub(super) fn try_it(&mut self, would_add: Rgb) -> Option<f32> {
        let u = self.sampler.next_1d();
        let amount = would_add.max_band();
        if amount >= self.threshold {
            return Some(1.0);
        }
        let chance = amount / self.threshold;
        (u < chance).then_some(chance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::Purpose;

    #[test]
    fn what_is_tried_makes_up_for_what_is_not() {
        let mut sampler = Sampler::new(0, Purpose::Test, 0, 0);
        let mut worth = Worth::beside(Rgb::WHITE, &mut sampler);
        for part in [0.1, 0.5, 2.0] {
            let light = Rgb::splat(part * HARDLY);
            let n = 100_000;
            let tried = (0..n).filter_map(|_| worth.try_it(light));
            let sum: f64 = tried.map(|chance| f64::from(light.g / chance)).sum();
            let mean = sum / (f64::from(n) * f64::from(HARDLY));
            // Five standard errors of a Bernoulli mean, and rounding.
            let part = f64::from(part);
            let slack = 5.0 * (part * (1.0 - part)).max(0.0).sqrt() / f64::from(n).sqrt();
            assert!((mean - part).abs() < slack + 1e-6, "{part}: {mean}");
        }
    }

    #[test]
    fn a_path_that_found_nothing_tries_everything() {
        let mut sampler = Sampler::new(0, Purpose::Test, 0, 0);
        let mut worth = Worth::beside(Rgb::BLACK, &mut sampler);
        assert_eq!(worth.try_it(Rgb::splat(1e-30)), Some(1.0));
    }
}
