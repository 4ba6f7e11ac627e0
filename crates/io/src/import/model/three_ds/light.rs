//! From 3D Studio's lights to point lights.

use super::material::linear;
use crate::import::model::ModelLight;
use crate::import::placement::Placement;
use crate::three_ds;
use std::f32::consts::PI;
use traylib_math::Vec3;

/// The light where it goes; `None` if it does not shine.
///
/// 3D Studio's light arrives as colour · multiplier at any distance, and a
/// diffuse surface shows its own colour times that. An intensity of
/// π · colour · multiplier · s² does the same at the distance s, that of the
/// middle of what there is to see.
pub(super) fn light(
    light: &three_ds::Light,
    placement: &Placement,
    middle: Vec3,
) -> Option<ModelLight> {
    let position = placement.point(light.position);
    let strength = PI * light.multiplier * position.distance_squared(middle);
    let intensity = linear(light.colour) * strength;
    let shines = light.on && light.multiplier > 0.0 && !intensity.is_black();
    (shines && position.is_finite() && intensity.is_finite())
        .then_some(ModelLight { position, intensity })
}
