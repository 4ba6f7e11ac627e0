//! Tests whether values are spread evenly.

/// Probability that values drawn evenly from [0, 1] are spread as unevenly as
/// these or more, by the greatest distance between the two distributions.
///
/// Kolmogorov's limit with the correction of Stephens, *EDF statistics for
/// goodness of fit and some comparisons*, 1974, good from about five values on.
pub fn uniformity(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let n = sorted.len() as f64;
    let distance = sorted
        .iter()
        .enumerate()
        .map(|(i, value)| (value - i as f64 / n).max((i + 1) as f64 / n - value))
        .fold(0.0, f64::max);
    let x = distance * (n.sqrt() + 0.12 + 0.11 / n.sqrt());
    let term = |k: i32| {
        let k = f64::from(k);
        let sign = if k % 2.0 == 0.0 { -2.0 } else { 2.0 };
        sign * (-2.0 * k * k * x * x).exp()
    };
    (1..=100).map(term).sum::<f64>().clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::Sampler;

    #[test]
    fn evenly_spread_values_are_told_from_others() {
        let even: Vec<f64> = (0..100).map(|i| (f64::from(i) + 0.5) / 100.0).collect();
        assert!(uniformity(&even) > 0.999);
        // Squares lie 1/4 off at most: Kolmogorov's law beyond 2.5 is 7e-6.
        let squares: Vec<f64> = even.iter().map(|x| x * x).collect();
        let p = uniformity(&squares);
        assert!((2e-6..2e-5).contains(&p), "{p}");
        // Of 1000 distances of ten random values a twentieth is below 0.05.
        let mut sampler = Sampler::numbered(0, 0);
        let mut draw = || {
            let values: Vec<f64> = (0..10).map(|_| f64::from(sampler.next_1d())).collect();
            usize::from(uniformity(&values) < 0.05)
        };
        let rare: usize = (0..1000).map(|_| draw()).sum();
        assert!((25..80).contains(&rare), "{rare}");
    }
}
