//! The direction in which a round shape faces.

use std::ops::Neg;

/// The side of a sphere or a cone that is its front.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Facing {
    /// Normals point away from the centre or the axis.
    #[default]
    Outward,
    /// Normals point to the centre or the axis.
    Inward,
}

impl Facing {
    /// Turns to the front what is given for the outside: a normal, or a cosine with
    /// it.
    #[inline]
    pub(crate) fn turn<T: Neg<Output = T>>(self, outward: T) -> T {
        match self {
            Self::Outward => outward,
            Self::Inward => -outward,
        }
    }
}
