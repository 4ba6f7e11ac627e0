//! Sums of powers of a stream of values, and how peaked their law is.

/// Sums of the first four powers of values that come one by one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PowerSums {
    count: f64,
    sums: [f64; 4],
}

impl PowerSums {
    /// Takes in one value.
    pub fn add(&mut self, value: f64) {
        self.count += 1.0;
        let mut power = 1.0;
        for sum in &mut self.sums {
            power *= value;
            *sum += power;
        }
    }

    /// Excess kurtosis, E[(X − μ)⁴]/σ⁴ − 3; `None` for a constant.
    pub fn excess_kurtosis(&self) -> Option<f64> {
        let [m1, m2, m3, m4] = self.sums.map(|sum| sum / self.count);
        let variance = m2 - m1 * m1;
        let fourth = m4 - 4.0 * m1 * m3 + 6.0 * m1 * m1 * m2 - 3.0 * m1.powi(4);
        // Less is what rounding leaves of the sums of a constant.
        (variance > 1e-12 * m2).then(|| fourth / (variance * variance) - 3.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A coin that shows 0.7 with probability F and 0 else: the excess kurtosis is
    /// (1 − 6F(1 − F))/(F(1 − F)). Exact, for the shares of a finite list.
    #[test]
    fn kurtosis_of_two_values() {
        for (hits, all) in [(1, 2), (1, 10), (1, 1000)] {
            let mut sums = PowerSums::default();
            (0..all).for_each(|i| sums.add(if i < hits { 0.7 } else { 0.0 }));
            let spread = f64::from(hits * (all - hits)) / f64::from(all * all);
            let known = (1.0 - 6.0 * spread) / spread;
            let found = sums.excess_kurtosis().unwrap();
            assert!((found - known).abs() < 1e-9 * known.abs(), "{found} {known}");
        }
        let mut constant = PowerSums::default();
        (0..1000).for_each(|_| constant.add(0.1));
        assert_eq!(constant.excess_kurtosis(), None);
    }
}
