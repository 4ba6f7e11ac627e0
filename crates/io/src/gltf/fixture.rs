//! Lights that are no surfaces, and cameras.

use super::json;
use super::nodes::Placed;
use super::{Camera, Light, WarningKind};
use crate::warning_counts::WarningCounts;
use std::f32::consts::{FRAC_PI_4, PI};
use traylib_math::glam::DVec3;
use traylib_math::{Rgb, Vec3};

/// Reads a light in its place; `None` of one that is skipped.
pub(super) fn light(
    light: &json::Light,
    placed: &Placed<'_>,
    warnings: &mut WarningCounts<WarningKind>,
) -> Option<Light> {
    let intensity = Rgb::from(light.color) * light.intensity;
    let cone = match light.kind.as_str() {
        "point" => Some(None),
        "spot" => cone(light.spot.as_ref()).map(Some),
        "directional" => {
            warnings.add(WarningKind::DirectionalLight);
            return None;
        }
        _ => None,
    };
    let is_sound = intensity.is_finite() && intensity.min_band() >= 0.0;
    let Some(cone) = cone.filter(|_| is_sound) else {
        warnings.add(WarningKind::OddLight);
        return None;
    };
    warnings.add_many(WarningKind::LightRange, usize::from(light.range.is_some()));
    let position = placed.place.translation.as_vec3();
    Some(Light { position, direction: direction(placed, DVec3::NEG_Z), intensity, cone })
}

/// The half angles of a spot light; `None` if they make no sense.
fn cone(spot: Option<&json::Spot>) -> Option<[f32; 2]> {
    let inner = spot.map_or(0.0, |spot| spot.inner_cone_angle);
    let outer = spot.and_then(|spot| spot.outer_cone_angle).unwrap_or(FRAC_PI_4);
    let is_cone = 0.0 <= inner && inner <= outer && 0.0 < outer && outer <= PI;
    is_cone.then_some([inner, outer])
}

/// Reads a camera in its place; `None` of one that is skipped.
pub(super) fn camera(
    camera: &json::Camera,
    placed: &Placed<'_>,
    warnings: &mut WarningCounts<WarningKind>,
) -> Option<Camera> {
    let Some(perspective) = &camera.perspective else {
        warnings.add(WarningKind::Orthographic);
        return None;
    };
    let camera = Camera {
        position: placed.place.translation.as_vec3(),
        direction: direction(placed, DVec3::NEG_Z),
        up: direction(placed, DVec3::Y),
        yfov: perspective.yfov,
        aspect: perspective.aspect_ratio.filter(|aspect| aspect.is_finite() && *aspect > 0.0),
    };
    let has_place = camera.position.is_finite() && camera.direction.cross(camera.up) != Vec3::ZERO;
    if !(has_place && 0.0 < camera.yfov && camera.yfov < PI) {
        warnings.add(WarningKind::OddCamera);
        return None;
    }
    Some(camera)
}

/// A unit vector of a node in the scene.
fn direction(placed: &Placed<'_>, of_node: DVec3) -> Vec3 {
    placed.place.transform_vector3(of_node).normalize_or_zero().as_vec3()
}
