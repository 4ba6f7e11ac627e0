//! Bounds on the chance that rare large values were missed.

/// Probability, at most, that the mean of `samples` values in 0..`largest`, whose law has this
/// `mean`, falls `short` of it by so much, whatever the law is: exp(−n·d²/(2Mμ)). It needs no
/// variance, which says nothing where large values are so rare that none was met.
///
/// Their second moment is Mμ at most: Maurer, *A bound on the deviation probability for sums
/// of non-negative random variables*, 2003.
pub fn shortfall(samples: f64, largest: f64, mean: f64, short: f64) -> f64 {
    if short <= 0.0 { 1.0 } else { (-samples * short * short / (2.0 * largest * mean)).exp() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One value in a thousand is 1, the others 0: that all of 1000 are 0 has the probability
    /// 0.999^1000 = e⁻¹, and the bound is e^(−1/2).
    #[test]
    fn the_bound_is_one() {
        let bound = shortfall(1000.0, 1.0, 1e-3, 1e-3);
        assert!((bound - (-0.5_f64).exp()).abs() < 1e-12 && bound > 0.999_f64.powi(1000));
        assert_eq!(shortfall(1000.0, 1.0, 1e-3, -1e-3), 1.0);
    }
}
