//! The slope of the error over the number of passes, on logarithmic scales.

/// The exponent in *variance of the mean ~ passes^slope*, −1 for independent
/// passes of a law that has a variance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Slope {
    /// The exponent.
    pub slope: f64,
    /// Standard deviation of the fit, as if its points were independent.
    pub deviation: f64,
}

/// A number of passes and, for each pixel, the variance over the runs of its
/// mean after so many passes.
///
/// In units of the pixel's own: its variance of single passes. So no few pixels
/// decide, however noisy.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Passes.
    pub passes: f64,
    /// One a pixel.
    pub variances: Vec<f64>,
}

/// Fits a line through the logarithms of mean variance and number of passes,
/// each point weighted by how far the pixels agree. `None` without two points
/// that have a variance.
pub fn fit(levels: &[Level]) -> Option<Slope> {
    let points: Vec<[f64; 3]> = levels.iter().filter_map(point).collect();
    let total: f64 = points.iter().map(|[.., weight]| weight).sum();
    let mean = |axis: usize| points.iter().map(|p| p[2] * p[axis]).sum::<f64>() / total;
    let (x0, y0) = (mean(0), mean(1));
    let xx: f64 = points.iter().map(|[x, _, weight]| weight * (x - x0).powi(2)).sum();
    let xy: f64 = points.iter().map(|[x, y, weight]| weight * (x - x0) * (y - y0)).sum();
    (points.len() > 1 && xx > 0.0).then(|| Slope { slope: xy / xx, deviation: xx.powf(-0.5) })
}

/// Abscissa, ordinate and weight: the inverse of the ordinate's variance, which
/// is that of the mean over the pixels, relative.
fn point(level: &Level) -> Option<[f64; 3]> {
    let n = level.variances.len() as f64;
    let mean = level.variances.iter().sum::<f64>() / n;
    let spread = level.variances.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (n - 1.0);
    let weight = mean * mean / (spread / n);
    (mean > 0.0 && weight.is_finite()).then(|| [level.passes.ln(), mean.ln(), weight])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Variances c·N^slope in two pixels, one twice as noisy as the other.
    fn levels(slope: f64) -> Vec<Level> {
        let level = |passes: f64| Level {
            passes,
            variances: [1.0, 2.0].map(|c| c * passes.powf(slope)).to_vec(),
        };
        [16.0, 32.0, 64.0, 128.0].map(level).to_vec()
    }

    #[test]
    fn a_power_law_has_its_exponent() {
        for exponent in [-1.0, -0.5, 0.0] {
            let found = fit(&levels(exponent)).unwrap();
            assert!((found.slope - exponent).abs() < 1e-12, "{found:?}");
            assert!(found.deviation > 0.0);
        }
    }

    #[test]
    fn one_point_and_no_noise_have_no_slope() {
        assert_eq!(fit(&levels(-1.0)[..1]), None);
        let still = |passes: f64| Level { passes, variances: vec![0.0; 2] };
        assert_eq!(fit(&[still(1.0), still(2.0)]), None);
    }
}
