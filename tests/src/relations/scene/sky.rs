//! The sky of a drawn scene.

use traylib_math::Vec3;

/// Light from infinitely far away, as a latitude-longitude picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Sky {
    /// Columns of the picture.
    pub width: usize,
    /// Radiance in W/(m²·sr), row by row from the top; of values that a Radiance picture holds
    /// exactly, unless there is only one.
    pub texels: Vec<Vec3>,
    /// Degrees about y.
    pub turn: f32,
}

impl Sky {
    /// Makes one that is the same from everywhere.
    pub fn even(radiance: Vec3) -> Self {
        Self { width: 1, texels: vec![radiance], turn: 0.0 }
    }

    /// Tells whether it is the same from everywhere.
    pub fn is_even(&self) -> bool {
        self.texels.len() == 1
    }
}
