//! A diffuse colour and a highlight as one of our models.

use traylib_materials::{Error, Lambert, Phong, SurfaceModel};
use traylib_math::Rgb;

/// Said where a material had to be scaled down.
pub(super) const SCALED: &str = "material reflecting more than arrives, scaled down";

/// The sharpest lobe there is.
pub(super) const SHARPEST: f32 = 1e6;

/// Phong with kd, ks and n, or Lambert where there is no highlight, of which this share is
/// there; and whether it had to be scaled down: where kd + ks exceeds one, both are divided by
/// the largest band of the sum.
///
/// # Errors
/// A number that makes no material.
pub(super) fn surface_model(
    [diffuse, specular]: [Rgb; 2],
    exponent: f32,
    share: f32,
) -> Result<(SurfaceModel, bool), Error> {
    let sum = (diffuse + specular).max_band();
    let [diffuse, specular] = [diffuse, specular].map(|part| part / sum.max(1.0) * share);
    let model = if specular.is_black() {
        SurfaceModel::Lambert(Lambert::new(diffuse)?)
    } else {
        SurfaceModel::Phong(Phong::new(diffuse, specular, exponent)?)
    };
    Ok((model, sum > 1.0))
}
