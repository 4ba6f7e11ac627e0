//! The prices of work.
//!
//! The table was made by `cargo xtask costs`, which times every method on scenes of all sizes
//! and fits these numbers; only their ratios matter. A plan never looks at a clock.

use super::work::Work;
use crate::{Engine, Method};
use traylib_scene::Scene;

/// Nanoseconds of what a method does for a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Price {
    /// The sample itself, with its first ray.
    sample: f64,
    /// A further ray from the camera's side.
    camera_bounce: f64,
    /// A shadow ray of a camera path.
    camera_shadow: f64,
    /// A light path.
    light_path: f64,
    /// Each of its rays.
    light_bounce: f64,
    /// Each of its shadow rays.
    light_shadow: f64,
}

/// Shapes of the scenes that the table is for.
const FEW: f64 = 16.0;

/// The relative increase of prices with each doubling of them.
const A_DOUBLING: f64 = 0.1;

const PURE_MC: Price = Price { sample: 150.0, camera_bounce: 290.0, ..Price::NOTHING };
const DIRECT_LIGHT: Price =
    Price { sample: 30.0, camera_bounce: 220.0, camera_shadow: 240.0, ..Price::NOTHING };
const PARTICLE: Price =
    Price { sample: 75.0, light_bounce: 265.0, light_shadow: 85.0, ..Price::NOTHING };
const BDPT: Price = Price {
    sample: 75.0,
    camera_bounce: 215.0,
    camera_shadow: 280.0,
    light_path: 0.0,
    light_bounce: 320.0,
    light_shadow: 30.0,
};

impl Price {
    const NOTHING: Self = Self {
        sample: 0.0,
        camera_bounce: 0.0,
        camera_shadow: 0.0,
        light_path: 0.0,
        light_bounce: 0.0,
        light_shadow: 0.0,
    };

    fn of(engine: Engine) -> Self {
        match engine {
            Engine::PureMc => PURE_MC,
            Engine::DirectLight => DIRECT_LIGHT,
            Engine::Particle => PARTICLE,
            Engine::Bdpt => BDPT,
        }
    }

    fn of_work(self, work: &Work) -> f64 {
        self.sample
            + self.camera_bounce * work.camera_bounces
            + self.camera_shadow * work.camera_shadows
            + self.light_path * work.light_paths
            + self.light_bounce * work.light_bounces
            + self.light_shadow * work.light_shadows
    }
}

/// Returns the cost of a sample, in nanoseconds of the machine that the table was made on.
pub(super) fn price(method: Method, work: &Work, scene: &Scene) -> f64 {
    growth(scene.primitive_count()) * Price::of(method.engine()).of_work(work)
}

/// Returns the factor by which everything is dearer in a scene of so many shapes than in one of a
/// few: rays go deeper into a larger tree, and find less of it in caches.
pub fn growth(primitives: usize) -> f64 {
    let doublings = (primitives.max(1) as f64 / FEW).log2().max(0.0);
    1.0 + A_DOUBLING * doublings
}
