//! The distribution of the energy of a stream of values: over many, or over a few large ones.

/// Bins an octave.
const FINENESS: f64 = 8.0;
/// From 2⁻⁶⁴ to 2⁶⁴.
const BINS: u16 = 1024;

/// The number of values of each size, and the sum of their squares: a histogram with
/// bins of an eighth of an octave.
#[derive(Clone, Debug)]
pub struct Energy {
    count: f64,
    bins: Vec<(f64, f64)>,
}

impl Default for Energy {
    fn default() -> Self {
        Self { count: 0.0, bins: vec![(0.0, 0.0); usize::from(BINS)] }
    }
}

impl Energy {
    /// Takes in one value.
    pub fn add(&mut self, value: f64) {
        self.count += 1.0;
        if value > 0.0 {
            let bin = value.log2() * FINENESS + f64::from(BINS / 2);
            let bin = &mut self.bins[bin.clamp(0.0, f64::from(BINS - 1)) as usize];
            bin.0 += 1.0;
            bin.1 += value * value;
        }
    }

    /// The share of the largest 0.1 % of values in the sum of squares; the last
    /// bin counts in proportion. Zero without energy.
    pub fn share_of_largest(&self) -> f64 {
        let total: f64 = self.bins.iter().map(|bin| bin.1).sum();
        let (mut wanted, mut energy) = (1e-3 * self.count, 0.0);
        for &(count, squares) in self.bins.iter().rev().filter(|bin| bin.0 > 0.0) {
            let part = (wanted / count).min(1.0);
            energy += part * squares;
            wanted -= part * count;
            if wanted <= 0.0 {
                break;
            }
        }
        if total > 0.0 { energy / total } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One value in a thousand is x, the others 1: their energy is x²/(x² + 999).
    #[test]
    fn the_largest_values_share_of_the_energy() {
        for x in [1.0, 10.0, 1e3] {
            let mut energy = Energy::default();
            (0..100_000).for_each(|i| energy.add(if i % 1000 == 0 { x } else { 1.0 }));
            let known = x * x / (x * x + 999.0);
            let found = energy.share_of_largest();
            assert!((found - known).abs() < 1e-9, "{x}: {found} {known}");
        }
        assert_eq!(Energy::default().share_of_largest(), 0.0);
    }
}
