//! Equal densities in all directions, per area.

use crate::Vec3;
use traylib_math::{AreaPdf, SolidAnglePdf, solid_angle_per_area};

/// The density per area of a point that is seen with equal density all over `solid_angle`;
/// zero where its front is turned away from `from`.
pub(crate) fn even_pdf(solid_angle: f32, from: Vec3, position: Vec3, normal: Vec3) -> AreaPdf {
    let back = from - position;
    let distance_squared = back.length_squared();
    let cosine = (back.dot(normal) / distance_squared.sqrt()).max(0.0);
    SolidAnglePdf(1.0 / solid_angle).to_area(solid_angle_per_area(cosine, distance_squared))
}
