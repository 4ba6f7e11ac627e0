//! The choice of the longest path.

use super::bands::grey;
use super::pilot::{LONGEST, Pilot};
use super::plan::Request;

/// The longest path that the methods shall follow: that of the request, or the shortest that
/// loses no more than it may.
pub(super) fn longest(pilot: &Pilot, request: &Request) -> Option<u32> {
    if request.may_lose <= 0.0 {
        return request.max_depth;
    }
    let lost = lost_beyond(&light_by_edges(pilot));
    let found = (2..=LONGEST).find(|&edges| lost[edges as usize] <= request.may_lose);
    match (found, request.max_depth) {
        (Some(found), Some(given)) => Some(found.min(given)),
        (found, given) => found.or(given),
    }
}

/// The light of paths with 0, 1, 2 … edges.
pub(super) fn light_by_edges(pilot: &Pilot) -> Vec<f64> {
    let mut light = vec![0.0; LONGEST as usize + 1];
    for found in &pilot.found {
        light[found.path.edges()] += grey(found.path.balanced());
    }
    light
}

/// The part of all light on paths with more than 0, 1, 2 … edges. Beyond the last that the
/// pilot followed light falls as it did on the way there: by the root of the ratio of two
/// lengths that are far apart, so that the noise of each counts little.
pub(super) fn lost_beyond(light: &[f64]) -> Vec<f64> {
    let last = light.len() - 1;
    let middle = last.div_ceil(2);
    let about = |edges: usize| light[edges - 1..=edges].iter().sum::<f64>();
    let ratio = (about(last) / about(middle)).powf(1.0 / (last - middle) as f64);
    let ratio = if ratio.is_finite() { ratio.min(0.99) } else { 0.0 };
    let tail = light[last] * ratio / (1.0 - ratio);
    let all = light.iter().sum::<f64>() + tail;
    let mut rest = all;
    let beyond = |own: &f64| {
        rest -= own;
        if all > 0.0 { (rest / all).max(0.0) } else { 0.0 }
    };
    light.iter().map(beyond).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A furnace of albedo a has aᵏ⁻¹ of its light on paths of k edges, and aᵏ beyond.
    #[test]
    fn the_tail_of_a_furnace_is_its_own() {
        for albedo in [0.2_f64, 0.5, 0.8, 0.95] {
            let light: Vec<f64> =
                (0..=16).map(|k| if k == 0 { 0.0 } else { albedo.powi(k - 1) }).collect();
            for (k, lost) in (0..).zip(lost_beyond(&light)) {
                let expected = albedo.powi(k);
                assert!((lost - expected).abs() < 1e-9, "{albedo} {k}: {lost} {expected}");
            }
        }
    }

    #[test]
    fn no_light_loses_nothing() {
        assert!(lost_beyond(&[0.0; 17]).iter().all(|&lost| lost == 0.0));
        let mut direct = vec![0.0; 17];
        direct[2] = 1.0;
        assert_eq!(lost_beyond(&direct)[1..4], [1.0, 0.0, 0.0]);
    }
}
