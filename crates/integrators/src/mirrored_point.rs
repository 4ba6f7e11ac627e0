//! Point lights by way of a mirror: a connection with one ideal reflection in its middle.

use crate::numbers::VertexNumbers;
use crate::tracer::Tracer;
use traylib_math::{Rgb, Vec3};
use traylib_scene::{PointImage, SurfacePoint, Walk};

/// So many edges join a vertex with a light by way of a mirror.
pub(crate) const MIRRORED_EDGES: u32 = 2;

/// The radiance that a vertex seen from the unit direction `wo` reflects of what point lights
/// send it by way of one ideal mirror, as far as [`Scene::point_images`](traylib_scene::Scene::point_images) knows it.
///
/// A light walk may find the same paths, a walk from the camera never: a point light cannot be
/// hit after a mirror, nor aimed at from it.
#[inline]
pub fn light_through_mirrors(
    tracer: &mut Tracer<'_>,
    point: &SurfacePoint,
    wo: Vec3,
    numbers: &VertexNumbers,
) -> Rgb {
    if tracer.scene.has_point_images() && point.model.has_smooth_part() {
        join_images(tracer, point, wo, numbers)
    } else {
        Rgb::BLACK
    }
}

/// Apart, so that scenes without such images pay for one question alone.
#[inline(never)]
fn join_images(
    tracer: &mut Tracer<'_>,
    point: &SurfacePoint,
    wo: Vec3,
    numbers: &VertexNumbers,
) -> Rgb {
    let scene = tracer.scene;
    // Numbers that area lamps alone use otherwise, and the one that chose a lamp.
    let u = [numbers.light_pick, f64::from(numbers.light_point.x)];
    let mut radiance = Rgb::BLACK;
    for PointImage { wi, seen_at, x0, irradiance } in scene.point_images(point, u) {
        // What the surface makes of it.
        let cosine = point.cosine(Walk::FromCamera, wo, wi);
        let reflected = point.evaluate(wo, wi).f * irradiance * cosine;
        if reflected.is_black() {
            continue;
        }
        // Both edges, asked from the side of the eye.
        let Some(to_mirror) = tracer.sees(&point.site.segment_to(&seen_at)) else { continue };
        let Some(to_light) = tracer.sees(&x0.segment_from(&seen_at)) else { continue };
        radiance += reflected * to_mirror * to_light;
    }
    radiance
}
