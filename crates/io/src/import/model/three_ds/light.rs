//! From 3D Studio's lights to point lights.

use super::material::linear;
use crate::import::placement::Placement;
use crate::three_ds;
use std::f32::consts::PI;
use traylib_geometry::Aabb;
use traylib_scene::{PointLight, SpotCone};

/// The least distance to the middle, of that from there to the corners.
const LEAST_PART: f32 = 0.25;

/// The light where it goes; `None` if it does not shine.
///
/// 3D Studio's light arrives as colour · multiplier at any distance, and a
/// diffuse surface shows its own colour times that. An intensity of
/// π · colour · multiplier · s² does the same at the distance s, that of the
/// middle of what there is to see. For one in the middle itself a part of the way to the
/// corners is taken, or it would not shine.
pub(super) fn light(
    light: &three_ds::Light,
    placement: &Placement,
    around: &Aabb,
) -> Option<PointLight> {
    let position = placement.point(light.position);
    let least = LEAST_PART * 0.5 * around.extent().length();
    let distance = position.distance(around.centre()).max(least);
    let strength = PI * light.multiplier * distance * distance;
    let intensity = linear(light.colour) * strength;
    let shines = light.on && light.multiplier > 0.0 && !intensity.is_black();
    (shines && position.is_finite() && intensity.is_finite()).then(|| PointLight {
        position,
        intensity,
        cone: cone(light, placement),
    })
}

/// The cone of a spot light, between whose two angles the light falls off
/// smoothly; none of a cone that makes no sense.
fn cone(light: &three_ds::Light, placement: &Placement) -> Option<SpotCone> {
    let spot = light.spot.as_ref().filter(|spot| !spot.overshoot)?;
    let axis = placement.direction(light.direction()?);
    let dark = spot.falloff_degrees.clamp(0.0, 360.0);
    let full = spot.hotspot_degrees.clamp(0.0, dark);
    let [full, dark] = [full, dark].map(|whole| (0.5 * whole).to_radians().cos());
    SpotCone::new(axis, full, dark).ok()
}
