//! Choosing a lamp for a point among many.
//!
//! A tree over all lamps, of up to four children a node. Of each child is known where its lamps
//! are, how strong they are together and into which directions they may shine, and from that how
//! much they may give a point ([`Node::importance`]). A choice goes down from the root, at each
//! node in proportion to what its children may give, though none that may give any has less than
//! about [`shares::RAREST`]: the strongest lamp may stand behind a wall.
//!
//! Conty Estevez and Kulla, *Importance Sampling of Many Lights with Adaptive Tree
//! Splitting*, 2018. Theirs may go both ways where a node is near; here it is one
//! lamp a choice. What the surface's normal thinks of a lamp is left out: a lobe or
//! a shading normal may care for directions that a cosine does not.

mod build;
mod cluster;
mod cone;
mod node;
mod shares;

use crate::Light;
use cluster::Cluster;
use node::{Link, Node, WIDTH};
use shares::{Rest, Shares};
use traylib_math::Vec3;

/// The lamps of a scene by place, direction and strength.
#[derive(Clone, Debug)]
pub(crate) struct LightTree {
    root: Link,
    /// Every node after all below it.
    nodes: Vec<Node>,
    /// The way to each lamp from the root: two bits for the turn at each level, the lowest
    /// for the root.
    paths: Vec<u64>,
}

/// The bits of a path that say one turn.
const TURN_BITS: u32 = WIDTH.ilog2();

impl LightTree {
    /// A tree over these lamps but for the sky; one of them must be another for there to be
    /// anything to choose. The same lamps give the same tree.
    pub(crate) fn new(lights: &[Light]) -> Self {
        let intensities: Vec<f64> = lights.iter().map(Light::intensity).collect();
        let strongest = intensities.iter().copied().fold(0.0, f64::max);
        let cluster = |(light, intensity): (&Light, f64)| {
            // No lamp is so weak that it does not count.
            let share = (intensity / strongest).max(f64::from(f32::MIN_POSITIVE));
            Cluster::of(light, share)
        };
        let lamps: Vec<Cluster> = lights.iter().zip(intensities).filter_map(cluster).collect();
        build::tree(&lamps)
    }

    /// The lamp that `u`, uniform on [0, 1), chooses for a point, and its
    /// probability. One number decides every turn: what is left of it after one is
    /// stretched for the next. With `u` in steps of 2⁻³², so are the chances.
    #[inline]
    pub(crate) fn choose(&self, x1: Vec3, u: f64) -> (u32, f32) {
        let mut rest = Rest::of(u);
        self.descend(x1, |_, shares| {
            let turn = shares.turn(rest.stretched());
            rest = turn.rest;
            turn.child
        })
    }

    /// The probability of [`choose`](Self::choose) to choose this lamp: the same
    /// products in the same order, so the same bits.
    pub(crate) fn probability(&self, lamp: u32, x1: Vec3) -> f32 {
        let path = self.paths[lamp as usize];
        self.descend(x1, |level, _| turn_of(path, level)).1
    }

    /// The lamp that a series of turns leads to and the product of their chances.
    /// `turn` is told the level and the children's shares.
    fn descend(&self, x1: Vec3, mut turn: impl FnMut(u32, &Shares) -> usize) -> (u32, f32) {
        let (mut link, mut level, mut probability) = (self.root, 0, 1.0);
        loop {
            let node = match link {
                Link::Lamp(lamp) => return (lamp, probability),
                Link::Node(index) => &self.nodes[index as usize],
            };
            let shares = Shares::new(node, x1);
            let child = turn(level, &shares);
            probability = both(probability, shares.chance(child));
            link = node.links[child];
            level += 1;
        }
    }
}

/// The child to which a path turns at a level.
fn turn_of(path: u64, level: u32) -> usize {
    (path >> (TURN_BITS * level)) as usize % WIDTH
}

/// The chance that both of two independent events happen: zero only if one of them
/// cannot. Far too rare to be met, it may be less rare than it should.
#[inline]
fn both(one: f32, other: f32) -> f32 {
    if one > 0.0 && other > 0.0 { (one * other).max(f32::MIN_POSITIVE) } else { 0.0 }
}

#[cfg(test)]
mod tests;
