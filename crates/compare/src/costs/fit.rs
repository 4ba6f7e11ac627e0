//! Prices from times.

use super::Sample;
use traylib_integrators::Engine;
use traylib_integrators::planner::Work;

/// Returns the quantities that prices are multiplied with: the sample itself, a camera path's
/// further rays and shadow rays, and the same of light paths.
fn quantities(work: &Work) -> [f64; 6] {
    let Work { camera_bounces, camera_shadows, light_paths, light_bounces, light_shadows } = *work;
    [1.0, camera_bounces, camera_shadows, light_paths, light_bounces, light_shadows]
}

/// The prices of an engine, none below zero, with the least sum of squares of relative errors;
/// and the root of the mean of these. `size` is what a scene's size makes of all of them.
pub fn fit(samples: &[Sample], engine: Engine, size: impl Fn(usize) -> f64) -> ([f64; 6], f64) {
    let rows: Vec<[f64; 6]> = samples
        .iter()
        .filter(|sample| sample.method.engine() == engine)
        .map(|sample| {
            let scale = size(sample.primitives) / sample.nanoseconds;
            quantities(&sample.work).map(|quantity| quantity * scale)
        })
        .collect();
    // By turns each price is set to the best that the others leave it.
    let mut prices = [0.0; 6];
    for _ in 0..20_000 {
        for i in 0..prices.len() {
            let square: f64 = rows.iter().map(|row| row[i] * row[i]).sum();
            let left: f64 = rows.iter().map(|row| row[i] * (1.0 - without(row, &prices, i))).sum();
            prices[i] = if square > 0.0 { (left / square).max(0.0) } else { 0.0 };
        }
    }
    let error = |row: &[f64; 6]| (1.0 - without(row, &prices, prices.len())).powi(2);
    let mean = rows.iter().map(error).sum::<f64>() / rows.len().max(1) as f64;
    (prices, mean.sqrt())
}

/// Returns the cost that all prices but one explain.
fn without(row: &[f64; 6], prices: &[f64; 6], left_out: usize) -> f64 {
    (0..row.len()).filter(|&i| i != left_out).map(|i| row[i] * prices[i]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_integrators::Method;

    #[test]
    fn prices_of_made_up_times_are_found() {
        let sample = |bounces: f64, shadows: f64, primitives: usize| Sample {
            scene: String::new(),
            primitives,
            method: Method::COMBINED,
            work: Work { camera_bounces: bounces, camera_shadows: shadows, ..Work::default() },
            nanoseconds: (100.0 + 50.0 * bounces + 30.0 * shadows) * primitives as f64,
        };
        let samples = [sample(1.0, 2.0, 1), sample(3.0, 1.0, 2), sample(2.0, 5.0, 3)];
        let (prices, error) = fit(&samples, Engine::DirectLight, |size| size as f64);
        for (price, expected) in prices.into_iter().zip([100.0, 50.0, 30.0, 0.0, 0.0, 0.0]) {
            assert!((price - expected).abs() < 0.01, "{prices:?}");
        }
        assert!(error < 1e-4, "{error}");
    }
}
