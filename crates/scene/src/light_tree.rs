//! Choosing a lamp for a point among many.
//!
//! A binary tree over all lamps: each node knows where its lamps are, how strong
//! they are together and into which directions they may shine, and from that how
//! much they may give a point ([`Node::importance`]). A choice goes down from the
//! root, at each pair in proportion to what the two may give, though never more than
//! [`RAREST`] to one: the strongest lamp may stand behind a wall.
//!
//! Conty Estevez and Kulla, *Importance Sampling of Many Lights with Adaptive Tree
//! Splitting*, 2018. Theirs may go both ways where a node is near; here it is one
//! lamp a choice. What the surface's normal thinks of a lamp is left out: a lobe or
//! a shading normal may care for directions that a cosine does not.

mod build;
mod cluster;
mod cone;
mod node;

use crate::Light;
use cluster::Cluster;
use node::{Link, Node};
use traylib_math::Vec3;

/// The largest number below one.
const BELOW_ONE: f64 = 1.0 - f64::EPSILON / 2.0;

/// The least chance of a node that may give a point light, against its neighbour.
const RAREST: f32 = 1.0 / 256.0;

/// The lamps of a scene by place, direction and strength.
#[derive(Clone, Debug)]
pub(crate) struct LightTree {
    /// The root first; the two children of a node side by side.
    nodes: Vec<Node>,
    /// The way to each lamp from the root: bit i is set where it turns right at
    /// level i.
    paths: Vec<u64>,
}

impl LightTree {
    /// A tree over these lamps, of which there must be one. The same lamps give
    /// the same tree.
    pub(crate) fn new(lights: &[Light]) -> Self {
        let intensities: Vec<f64> = lights.iter().map(Light::intensity).collect();
        let strongest = intensities.iter().copied().fold(0.0, f64::max);
        let cluster = |(light, intensity): (&Light, f64)| {
            // No lamp is so weak that it does not count.
            let share = (intensity / strongest).max(f64::from(f32::MIN_POSITIVE));
            Cluster::of(light, share)
        };
        let lamps: Vec<Cluster> = lights.iter().zip(intensities).map(cluster).collect();
        build::tree(&lamps)
    }

    /// The lamp that `u`, uniform on [0, 1), chooses for a point, and its
    /// probability. One number decides every turn: what is left of it after one is
    /// stretched for the next. With `u` in steps of 2⁻³², so are the chances.
    pub(crate) fn choose(&self, x1: Vec3, mut u: f64) -> (u32, f32) {
        self.descend(x1, |_, chances| {
            let [left, right] = chances.map(f64::from);
            let turns_right = u >= left;
            u = if turns_right { (u - left) / right } else { u / left };
            u = u.min(BELOW_ONE);
            turns_right
        })
    }

    /// The probability of [`choose`](Self::choose) to choose this lamp: the same
    /// products in the same order, so the same bits.
    pub(crate) fn probability(&self, lamp: u32, x1: Vec3) -> f32 {
        let path = self.paths[lamp as usize];
        self.descend(x1, |level, _| path >> level & 1 == 1).1
    }

    /// The lamp that a series of turns leads to and the product of their chances.
    /// `turns_right` is told the level and the chances of left and right.
    fn descend(&self, x1: Vec3, mut turns_right: impl FnMut(u32, [f32; 2]) -> bool) -> (u32, f32) {
        let mut node = &self.nodes[0];
        let (mut level, mut probability) = (0, 1.0);
        loop {
            let first = match node.link {
                Link::Lamp(lamp) => return (lamp, probability),
                Link::Pair(first) => first as usize,
            };
            let pair = &self.nodes[first..first + 2];
            let chances = chances(&pair[0], &pair[1], x1);
            let right = usize::from(turns_right(level, chances));
            probability = both(probability, chances[right]);
            node = &pair[right];
            level += 1;
        }
    }
}

/// The chance that both of two independent things happen: zero only if one of them
/// cannot. Far too rare to be met, it may be less rare than it should.
#[inline]
fn both(one: f32, other: f32) -> f32 {
    if one > 0.0 && other > 0.0 { (one * other).max(f32::MIN_POSITIVE) } else { 0.0 }
}

/// The chances of two nodes: as what they may give, or one of them none where it
/// cannot light the point. Where neither can, or the squares of distances leave the
/// range of single precision, they are as the strengths.
#[inline]
fn chances(left: &Node, right: &Node, x1: Vec3) -> [f32; 2] {
    match (left.importance(x1), right.importance(x1)) {
        (Some(_), None) => [1.0, 0.0],
        (None, Some(_)) => [0.0, 1.0],
        (Some(a), Some(b)) if a + b > 0.0 && (a + b).is_finite() => in_proportion(a, b),
        (Some(_), Some(_)) | (None, None) => in_proportion(left.intensity, right.intensity),
    }
}

/// Chances in proportion to two numbers, neither below [`RAREST`].
#[inline]
fn in_proportion(a: f32, b: f32) -> [f32; 2] {
    [a / (a + b), b / (a + b)].map(|chance| chance.clamp(RAREST, 1.0 - RAREST))
}

#[cfg(test)]
mod tests;
