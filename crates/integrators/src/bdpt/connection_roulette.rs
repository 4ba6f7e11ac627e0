//! The choice of the connections that are tried and of those that are worth a shadow ray.

use traylib_math::{Rgb, Sampler};

/// A connection that would add less than this part of what the camera path has
/// found by itself is tried in proportion to what it would add.
///
/// On `cornell` this takes the shadow rays of a pair of paths from 14.0 to 6.9
/// and adds 0.4 % to the error of as many passes; 0.1 would leave 8.6 and add
/// 0.1 %.
const THRESHOLD: f32 = 0.3;

/// Connections that are looked at for a pair of paths, on average: all of those of two
/// paths with 64 edges each. Time grows with the length of longer ones, not its square.
const MOST_PAIRS: f32 = 64.0 * 64.0;

/// Roulette before the shadow ray of a connection.
///
/// A connection that would add c, less than a threshold τ, is tried with
/// probability c/τ and then counts as τ. That is unbiased, and since τ is a small
/// part of what the path has found by itself, no new noise stands out. A path
/// that found nothing has no threshold.
///
/// Of very many pairs of vertices only some are looked at in the first place.
pub(super) struct ConnectionRoulette<'a> {
    threshold: f32,
    /// The chance with which a pair is looked at.
    looked_at: f32,
    sampler: &'a mut Sampler,
}

impl<'a> ConnectionRoulette<'a> {
    /// For so many connections of a camera path that has `found` this by itself.
    pub(super) fn beside(found: Rgb, pairs: usize, sampler: &'a mut Sampler) -> Self {
        let looked_at = (MOST_PAIRS / pairs as f32).min(1.0);
        Self { threshold: THRESHOLD * found.max_band(), looked_at, sampler }
    }

    /// Returns the number of pairs of vertices to leave out before the next that is looked at:
    /// ⌊ln u/ln(1 − chance)⌋, which is as rare as so many refusals. Where every pair is looked at
    /// no number is drawn.
    pub(super) fn pairs_left_out(&mut self) -> usize {
        if self.looked_at >= 1.0 {
            return 0;
        }
        // A geometric distribution, by its inverse.
        let u = 1.0 - f64::from(self.sampler.next_1d());
        (u.ln() / (-f64::from(self.looked_at)).ln_1p()) as usize
    }

    /// The chance with which a connection that would add this is looked at and tried;
    /// `None` if it is not tried. It draws one number whatever the answer.
    pub(super) fn survives(&mut self, would_add: Rgb) -> Option<f32> {
        let u = self.sampler.next_1d();
        let amount = would_add.max_band() / self.looked_at;
        if amount >= self.threshold {
            return Some(self.looked_at);
        }
        // Tried in proportion, and then counted as the threshold.
        let chance = amount / self.threshold;
        (u < chance).then_some(chance * self.looked_at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_tried_makes_up_for_what_is_not() {
        let mut sampler = Sampler::numbered(0, 0);
        let mut roulette = ConnectionRoulette::beside(Rgb::WHITE, 1, &mut sampler);
        for part in [0.1, 0.5, 2.0] {
            let light = Rgb::splat(part * THRESHOLD);
            let n = 100_000;
            let tried = (0..n).filter_map(|_| roulette.survives(light));
            let sum: f64 = tried.map(|chance| f64::from(light.g / chance)).sum();
            let mean = sum / (f64::from(n) * f64::from(THRESHOLD));
            // Five standard errors of a Bernoulli mean, and rounding.
            let part = f64::from(part);
            let slack = 5.0 * (part * (1.0 - part)).max(0.0).sqrt() / f64::from(n).sqrt();
            assert!((mean - part).abs() < slack + 1e-6, "{part}: {mean}");
        }
    }

    /// As many pairs are looked at as one path may have, and each counts for those that are not.
    #[test]
    fn some_of_many_pairs_stand_for_all() {
        let mut sampler = Sampler::numbered(1, 0);
        for pairs in [10, 4096, 5000, 1_000_000] {
            let mut roulette = ConnectionRoulette::beside(Rgb::BLACK, pairs, &mut sampler);
            let (mut looked_at, mut sum) = (0.0, 0.0);
            let mut next = roulette.pairs_left_out();
            while next < pairs {
                looked_at += 1.0;
                sum += 1.0 / f64::from(roulette.survives(Rgb::WHITE).unwrap());
                next += 1 + roulette.pairs_left_out();
            }
            let mean = f64::from(MOST_PAIRS).min(pairs as f64);
            // Five standard deviations of a binomial number.
            let slack = 5.0 * (mean * (1.0 - mean / pairs as f64)).sqrt();
            assert!(f64::abs(looked_at - mean) <= slack, "{pairs}: {looked_at}");
            assert!((sum / pairs as f64 - looked_at / mean).abs() < 1e-5, "{pairs}: {sum}");
        }
    }

    #[test]
    fn a_path_that_found_nothing_tries_everything() {
        let mut sampler = Sampler::numbered(0, 0);
        let mut roulette = ConnectionRoulette::beside(Rgb::BLACK, 1, &mut sampler);
        assert_eq!(roulette.survives(Rgb::splat(1e-30)), Some(1.0));
    }
}
