//! The axes along which scenes grow, and how far.

use crate::results::Estimate;
use clap::ValueEnum;
use serde::Serialize;

/// The quantity that grows while everything else stays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// Triangles of a rough ball under a lamp.
    Triangles,
    /// Small lamps over a floor.
    Lamps,
    /// Edges of the longest path in a room that loses little light.
    PathLength,
    /// Pixels of a picture of a few balls.
    Pixels,
    /// Threads that render it.
    Threads,
}

/// The measurement at one place of an axis.
#[derive(Clone, Debug, Serialize)]
pub struct Level {
    /// The size of what grows, as a number of them.
    pub size: u64,
    /// Seconds to build the scene: its trees of shapes and of lights.
    pub build_seconds: f64,
    /// Bytes that the scene holds.
    pub scene_bytes: u64,
    /// The most bytes beside it while a picture of two passes is made, by method.
    pub render_bytes: Vec<u64>,
    /// Seconds of a sample, by method, with the least and the most of what was measured: of
    /// the processor, but by the clock where threads grow.
    pub sample_seconds: Vec<Estimate>,
}

/// All of one axis.
#[derive(Clone, Debug, Serialize)]
pub struct AxisResults {
    /// The axis.
    pub axis: Axis,
    /// From the smallest on.
    pub levels: Vec<Level>,
}

impl Axis {
    /// All.
    pub const ALL: [Self; 5] =
        [Self::Triangles, Self::Lamps, Self::PathLength, Self::Pixels, Self::Threads];

    /// Returns its name on axes and in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Triangles => "triangles",
            Self::Lamps => "lamps",
            Self::PathLength => "edges",
            Self::Pixels => "pixels",
            Self::Threads => "threads",
        }
    }

    /// Returns the sizes at which it is measured, ascending.
    pub fn sizes(self) -> Vec<u64> {
        match self {
            Self::Triangles => vec![1_000, 10_000, 100_000, 1_000_000, 4_000_000],
            Self::Lamps => vec![1, 10, 100, 1_000, 10_000, 100_000],
            Self::PathLength => vec![1, 2, 4, 8, 16, 32, 64],
            Self::Pixels => vec![1 << 10, 1 << 12, 1 << 14, 1 << 16, 1 << 18, 1 << 20],
            Self::Threads => {
                let processors = std::thread::available_parallelism().map_or(1, usize::from) as u64;
                let powers = (0..).map(|power| 1 << power).take_while(|n| *n < processors);
                powers.chain([processors]).collect()
            }
        }
    }
}

impl AxisResults {
    /// The power of size with which a quantity grows, between one level and the next; no
    /// number where there is nothing to compare.
    pub fn growth(&self, level: usize, quantity: impl Fn(&Level) -> f64) -> f64 {
        let [Some(before), Some(after)] =
            [level.checked_sub(1).and_then(|l| self.levels.get(l)), self.levels.get(level)]
        else {
            return f64::NAN;
        };
        let times = (after.size as f64 / before.size as f64).ln();
        (quantity(after) / quantity(before)).ln() / times
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_a_power() {
        let level = |size: u64| Level {
            size,
            build_seconds: (size as f64).powf(1.5),
            scene_bytes: 7,
            render_bytes: Vec::new(),
            sample_seconds: Vec::new(),
        };
        let found = AxisResults { axis: Axis::Lamps, levels: [1, 10, 40].map(level).to_vec() };
        assert!((found.growth(1, |level| level.build_seconds) - 1.5).abs() < 1e-12);
        assert!((found.growth(2, |level| level.build_seconds) - 1.5).abs() < 1e-12);
        assert_eq!(found.growth(2, |level| level.scene_bytes as f64), 0.0);
        assert!(found.growth(0, |level| level.build_seconds).is_nan());
        assert!(found.growth(3, |level| level.build_seconds).is_nan());
    }

    #[test]
    fn sizes_ascend() {
        for axis in Axis::ALL {
            let sizes = axis.sizes();
            assert!(sizes.windows(2).all(|pair| pair[0] < pair[1]), "{sizes:?}");
        }
    }
}
