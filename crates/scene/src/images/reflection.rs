//! The one point of a mirror by which a point sees another, and how much weaker light
//! arrives that way.

use traylib_math::glam::DVec3;

/// The way light of a point arrives by way of an ideal mirror.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reflection {
    /// From the point that is lit to where it sees the image, of any length.
    pub(crate) toward: DVec3,
    /// The factor on the other point's intensity for the irradiance on a surface that faces the
    /// image, in 1/m²: the solid angle into which light is sent over the area on which it arrives,
    /// the mirror's reflectance left out.
    pub(crate) spread: f64,
}
