//! The source of the numbers of one path.

use super::{RealNumbers, VertexNumbers};
use traylib_math::{Sampler, Vec2};

/// The numbers of one path, in the order in which it needs them.
///
/// Numbers that decide where a path goes belong to it from pass to pass. What is drawn now
/// and then takes [`free`](Self::free) ones: drawn from the path's own it would shift all
/// that come after.
#[derive(Clone, Debug)]
pub struct PathSampler {
    free: Sampler,
    real: Option<RealNumbers>,
}

impl PathSampler {
    /// Independent numbers.
    pub fn independent(free: Sampler) -> Self {
        Self { free, real: None }
    }

    /// The first numbers from a point of a sequence, the others independent.
    pub(crate) fn quasi_random(free: Sampler, real: RealNumbers) -> Self {
        Self { free, real: Some(real) }
    }

    /// A point in the pixel, uniform on the unit square: a camera path's first numbers.
    #[inline]
    pub fn pixel_point(&mut self) -> Vec2 {
        let mut point = self.free.next_2d();
        if let Some(real) = &mut self.real {
            real.replace_square(&mut point);
        }
        point
    }

    /// The numbers of the next vertex.
    #[expect(
        clippy::inline_always,
        reason = "its result is large: in place it is not written to memory"
    )]
    #[inline(always)]
    pub fn vertex(&mut self) -> VertexNumbers {
        let mut numbers = VertexNumbers::next(&mut self.free);
        if let Some(real) = &mut self.real {
            real.replace_vertex(&mut numbers);
        }
        numbers
    }

    /// Independent numbers of the same path.
    #[inline]
    pub fn free(&mut self) -> &mut Sampler {
        &mut self.free
    }
}
