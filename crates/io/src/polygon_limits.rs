//! Bounds on files of polygons.

use crate::Limit;

/// Bounds on what is taken in of a file of polygons. What exceeds it is an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PolygonLimits {
    /// The most bytes of a file.
    pub bytes: usize,
    /// The most corners of a polygon.
    pub corners: usize,
    /// The most that the squares of the corners of large polygons may sum up to, which is
    /// what cutting them takes.
    pub cutting: u64,
}

impl Default for PolygonLimits {
    /// Allows 2²⁸ bytes, 4096 corners, and 48 Mi of their squares.
    fn default() -> Self {
        Self { bytes: 1 << 28, corners: 4096, cutting: 48 << 20 }
    }
}

/// A polygon asks for too much.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PolygonFault {
    /// A polygon has too many corners.
    #[error("the polygon has more than {0} corners; {more}", more = Limit::Corners.remedy(*.0 as u64))]
    TooManyCorners(usize),
    /// Large polygons take too long to cut.
    #[error("polygons take too long to cut; {}", Limit::Cutting.remedy(*.0))]
    TooMuchCutting(u64),
}

/// Holds the polygons of a file against its limits, one after the other.
#[derive(Debug)]
pub(crate) struct PolygonBudget {
    limits: PolygonLimits,
    /// Squares of corners that are left.
    cutting: u64,
}

impl PolygonBudget {
    /// Polygons of no more corners are cut in no time.
    const SMALL: usize = 16;

    pub(crate) fn new(limits: PolygonLimits) -> Self {
        Self { limits, cutting: limits.cutting }
    }

    /// Takes what a polygon of this many corners costs.
    ///
    /// # Errors
    /// It has too many, or there is not so much left.
    pub(crate) fn take(&mut self, corners: usize) -> Result<(), PolygonFault> {
        if corners > self.limits.corners {
            return Err(PolygonFault::TooManyCorners(self.limits.corners));
        }
        if corners > Self::SMALL {
            let square = (corners as u64).saturating_mul(corners as u64);
            let left = self.cutting.checked_sub(square);
            self.cutting = left.ok_or(PolygonFault::TooMuchCutting(self.limits.cutting))?;
        }
        Ok(())
    }
}
