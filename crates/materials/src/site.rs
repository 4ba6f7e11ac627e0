//! A place on a surface.

use traylib_math::{Vec2, Vec3};

/// The place on a surface at which a material is asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Site {
    /// Texture coordinates.
    pub uv: Vec2,
    /// The derivatives of the place by each of them, in metres a unit; `None` where that
    /// is not known.
    pub tangents: Option<[Vec3; 2]>,
}
