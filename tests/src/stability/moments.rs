//! Power sums of a law, and where its energy lies.

/// Sums of the first four powers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    count: f64,
    sums: [f64; 4],
}

impl Moments {
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

/// Bins an octave.
const FINENESS: f64 = 8.0;
/// From 2⁻⁶⁴ to 2⁶⁴.
const BINS: u16 = 1024;

/// How many values of each size there are, and their squares: a histogram with
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
