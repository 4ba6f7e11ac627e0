//! The estimators whose noise is known in A2, and single samples of them.

use crate::analytic::disk;
use crate::passes::{each_pass, settings_by_pass};
use crate::variance::{mean, of_both, of_light_samples, of_walks};
use traylib_integrators::{DirectLight, Method};
use traylib_math::Heuristic;
use traylib_statistics::Moments;

/// An estimator of light that arrives straight from a lamp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Estimator {
    /// Walks that may hit the lamp: `puremc`.
    Walks,
    /// Points on the lamp: `directlight`.
    LightSamples,
    /// One of each, weighted: `directlight --combine`.
    Both(Heuristic),
}

impl Estimator {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::Walks,
        Self::LightSamples,
        Self::Both(Heuristic::Balance),
        Self::Both(Heuristic::Power),
    ];

    /// Variance of one sample by theory, in units of (ρ·Le)².
    pub fn theory(self, radius: f64) -> f64 {
        match self {
            Self::Walks => of_walks(radius),
            Self::LightSamples => of_light_samples(radius),
            Self::Both(heuristic) => of_both(radius, heuristic),
        }
    }

    /// The method.
    pub fn method(self) -> Method {
        match self {
            Self::Walks => Method::PURE_MC,
            Self::LightSamples => Method::DIRECT_LIGHT,
            Self::Both(heuristic) => Method::DirectLight(DirectLight {
                combine: Some(heuristic),
                ..DirectLight::default()
            }),
        }
    }

    /// Moments of single samples, in units of ρ·Le. A pixel of a spot in one pass is
    /// one sample, so a pass has 4096 of them.
    ///
    /// # Panics
    /// If a sample is not a sound number.
    pub fn samples(self, radius: f64, passes: u32, seed: u64) -> Moments {
        let case = disk(radius);
        let unit = case.truth / mean(radius);
        let settings = settings_by_pass(passes, seed);
        let mut samples = Vec::new();
        let statistics =
            each_pass(&case.scene, self.method().build().as_ref(), &settings, |pass| {
                samples.extend(pass.values().iter().map(|bands| bands[1] / unit));
            });
        assert_eq!(statistics.rejected, 0);
        Moments::of(&samples)
    }
}

/// The root of the parabola through values at `middle − step`, `middle` and
/// `middle + step` that lies nearest to the middle; not a number if it has none.
pub fn root_near(middle: f64, step: f64, [a, b, c]: [f64; 3]) -> f64 {
    let (slope, bend) = (0.5 * (c - a) / step, 0.5 * (a - 2.0 * b + c) / (step * step));
    // Of b + slope·x + bend·x², without cancellation.
    let root = (slope * slope - 4.0 * bend * b).sqrt();
    middle - 2.0 * b / (slope + root.copysign(slope))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_parabolas_are_found() {
        let at = |f: fn(f64) -> f64| root_near(2.0, 0.5, [f(1.5), f(2.0), f(2.5)]);
        assert!((at(|x| (x - 2.2) * (x + 5.0)) - 2.2).abs() < 1e-12);
        assert!((at(|x| (1.7 - x) * (x + 5.0)) - 1.7).abs() < 1e-12);
        assert!((at(|x| 3.0 * (x - 2.1)) - 2.1).abs() < 1e-12, "a line");
        assert!(at(|x| x * x + 1.0).is_nan());
    }
}
