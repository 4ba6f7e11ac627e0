//! The random numbers of paths.

mod path_sampler;
mod points;
mod real;

pub use path_sampler::PathSampler;
pub use points::PointSet;
use points::SEQUENCES;
pub use real::Dimensions;
pub(crate) use real::{RealNumbers, rotation};

use traylib_math::{Sampler, Vec2};

/// The end of a path that a stream is for: the first part of its number, with [`Sampler::TESTS`]
/// for neither.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// Camera paths, numbered by pixel.
    Camera = 0,
    /// Light paths, numbered within the pass.
    Light = 1,
}

impl Purpose {
    /// The stream of one path. Paths have streams of their own, so a picture depends
    /// neither on the number of threads nor on their order.
    pub(crate) fn sampler(self, seed: u64, pass: u64, path: u32) -> Sampler {
        Sampler::new(seed, [self as u64, pass, u64::from(path)])
    }
}

/// The numbers one path vertex may need, all uniform on [0, 1), in steps of 2⁻²⁴
/// but where said otherwise.
///
/// All are drawn at every vertex, used or not, so that switching a technique
/// off does not shift the numbers of the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexNumbers {
    /// The number that picks, among the surfaces that light can pass straight through, the one at
    /// which the edge to this vertex ends.
    pub pass_through: f32,
    /// Lobe, and two for the direction.
    pub bsdf: [f32; 3],
    /// Russian roulette.
    pub roulette: f32,
    /// The number that picks the light; in steps of 2⁻³², for lamps that are rarely chosen.
    pub light_pick: f64,
    /// The numbers that pick the point on the light.
    pub light_point: Vec2,
}

impl VertexNumbers {
    /// Independent numbers; those of a path are from its [`PathSampler`].
    #[inline]
    pub fn next(sampler: &mut Sampler) -> Self {
        Self {
            pass_through: sampler.next_1d(),
            bsdf: sampler.next_3d(),
            roulette: sampler.next_1d(),
            light_pick: sampler.next_fine(),
            light_point: sampler.next_2d(),
        }
    }
}

#[cfg(test)]
mod tests;
