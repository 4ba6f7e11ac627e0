//! All scenes of a run together: how far two methods are apart on average.

use crate::relations::judge::First;
use traylib_statistics::Interval;
use traylib_statistics::normal::two_sided_quantile;

/// Spreads of single scenes below this weigh alike, so that no scene decides alone.
const FLOOR: f64 = 0.01;
/// The probability that the interval misses by chance, both sides.
const LEVEL: f64 = 1e-4;

/// The mean of the logarithm of right over left, over scenes in which both are
/// known to a tenth; `None` if there are too few.
///
/// Scenes weigh by 1/(s² + 1 %²), s being the relative error of the ratio. The
/// logarithm of a noisy mean is half its relative variance too small on average,
/// which is made good. The interval is by the spread of scenes themselves.
pub fn ratio(firsts: &[First]) -> Option<(Interval, usize)> {
    let mut terms: Vec<(f64, f64)> = Vec::new();
    for First { means, variances, .. } in firsts {
        let relative = [0, 1].map(|side| variances[side] / (means[side] * means[side]));
        let variance = relative[0] + relative[1];
        if means[0] > 0.0 && means[1] > 0.0 && variance < 0.01 {
            let log = (means[1] / means[0]).ln() + 0.5 * (relative[1] - relative[0]);
            terms.push((log, 1.0 / (variance + FLOOR * FLOOR)));
        }
    }
    if terms.len() < 10 {
        return None;
    }
    let total: f64 = terms.iter().map(|(_, weight)| weight).sum();
    let mean = terms.iter().map(|(log, weight)| log * weight).sum::<f64>() / total;
    let squares: f64 = terms.iter().map(|(log, weight)| (weight * (log - mean)).powi(2)).sum();
    Some((
        Interval { mean, half_width: two_sided_quantile(LEVEL) * squares.sqrt() / total },
        terms.len(),
    ))
}
