//! Cameras as files of shapes have them, and angles of view.

use traylib_math::Vec3;

/// The camera of a file.
#[derive(Clone, Copy, Debug)]
pub(super) struct ModelCamera {
    pub(super) position: Vec3,
    pub(super) target: Vec3,
    pub(super) up: Vec3,
    pub(super) fov: Fov,
    /// Width by height of the picture that it is made for, if the file says.
    pub(super) aspect: Option<f32>,
    /// Width and height of that picture in pixels, if the file says.
    pub(super) resolution: Option<(u32, u32)>,
}

/// An angle of view in degrees.
#[derive(Clone, Copy, Debug)]
pub(super) enum Fov {
    /// From the left edge to the right one.
    Horizontal(f32),
    /// From the lower edge to the upper one.
    Vertical(f32),
}

impl Fov {
    /// From the left edge to the right one, of a picture this much wider than high.
    pub(super) fn horizontal(self, aspect: f32) -> f32 {
        match self {
            Self::Horizontal(degrees) => degrees,
            Self::Vertical(degrees) => {
                let half = (0.5 * degrees).to_radians().tan();
                2.0 * (aspect * half).atan().to_degrees()
            }
        }
    }
}
