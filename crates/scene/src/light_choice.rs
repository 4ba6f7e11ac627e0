//! The choice of the lamp that a surface aims at: the sky in a fixed part of all cases, else one of
//! the tree's.

use crate::Light;
use crate::light_tree::LightTree;
use traylib_math::Vec3;

/// The sky is chosen no more rarely than this, and leaves as much to all other lamps
/// together: power does not tell which of them a surface sees.
const LEAST: f64 = 0.25;

/// Chooses a lamp for a point.
#[derive(Clone, Debug)]
pub(crate) struct LightForPoint {
    sky: Option<SkyShare>,
    tree: LightTree,
}

/// The sky and its chance, one where there is nothing else.
#[derive(Clone, Copy, Debug)]
struct SkyShare {
    lamp: u32,
    chance: f64,
}

impl LightForPoint {
    /// For these lamps, of which there must be one, and their powers in W. The sky has its part
    /// of the power as its chance, but no less than [`LEAST`] and no more than leaves that to
    /// the rest.
    pub(crate) fn new(lights: &[Light], powers: &[f32]) -> Self {
        let share = |(lamp, light): (u32, &Light)| match light {
            Light::Area { .. } | Light::Point(_) => None,
            Light::Sky(_) => Some(SkyShare { lamp, chance: chance(powers, lamp as usize) }),
        };
        Self { sky: (0..).zip(lights).find_map(share), tree: LightTree::new(lights) }
    }

    /// The lamp that `u`, uniform on [0, 1), chooses for a point, and its chance: see
    /// [`LightTree::choose`].
    #[inline]
    pub(crate) fn choose(&self, x1: Vec3, u: f64) -> (u32, f32) {
        let Some(sky) = self.sky else { return self.tree.choose(x1, u) };
        if u < sky.chance {
            return (sky.lamp, sky.chance as f32);
        }
        // What is left of the number is uniform again.
        let (lamp, chance) = self.tree.choose(x1, (u - sky.chance) / (1.0 - sky.chance));
        (lamp, sky.leaves(chance))
    }

    /// The chance of [`choose`](Self::choose) to choose this lamp, in the same bits.
    #[inline]
    pub(crate) fn probability(&self, lamp: u32, x1: Vec3) -> f32 {
        match self.sky {
            None => self.tree.probability(lamp, x1),
            Some(sky) if sky.lamp == lamp => sky.chance as f32,
            Some(sky) => sky.leaves(self.tree.probability(lamp, x1)),
        }
    }
}

impl SkyShare {
    /// The chance of a lamp that has this one where there is no sky; zero only if that is.
    fn leaves(self, chance: f32) -> f32 {
        let left = (f64::from(chance) * (1.0 - self.chance)) as f32;
        if chance > 0.0 { left.max(f32::MIN_POSITIVE) } else { 0.0 }
    }
}

/// The chance of the sky among lamps of these powers.
fn chance(powers: &[f32], sky: usize) -> f64 {
    if powers.len() == 1 {
        return 1.0;
    }
    let all: f64 = powers.iter().map(|&power| f64::from(power)).sum();
    (f64::from(powers[sky]) / all).clamp(LEAST, 1.0 - LEAST)
}
