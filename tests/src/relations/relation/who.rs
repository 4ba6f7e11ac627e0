//! The methods that can see the light of a scene, and those that see it so steadily that it can be
//! judged.

use super::Subject;
use crate::methods;
use crate::relations::draw::Dice;
use crate::relations::judge::Part;
use crate::relations::render::{Built, Estimator};
use crate::relations::scene::{DrawnScene, luminance};
use std::f64::consts::PI;
use std::sync::Arc;
use traylib_geometry::Ray;
use traylib_integrators::{BlindSpot, Method, SceneFacts};
use traylib_math::{Rgb, Vec2};
use traylib_scene::{Camera, Scene};

/// Exponents over this make light samples and splats find enormous light too rarely
/// to be met at all.
const SHARP: f32 = 20.0;

/// No lamp starts fewer light paths than one seventeenth of its share if all had the
/// same (`docs/conventions.md`, "Choosing a lamp").
pub(super) const RARITY: f64 = 17.0;

/// No lamp that may light a vertex is chosen for it less often than once in so many
/// times for each lamp that outshines it (the same).
pub(super) const OUTSHONE: f64 = 256.0;

/// Tells whether this method is not blind here, and its noise can be judged.
pub(super) fn sees(subject: &Subject<'_>, method: Method) -> bool {
    let drawn = subject.drawn;
    let integrator = method.build();
    let facts = SceneFacts::of(&subject.built.scene);
    let is_blind = integrator.blind_spots(&facts).into_iter().any(|spot| match spot {
        BlindSpot::SeenInMirrors => sees_mirrors(&subject.built.scene),
        BlindSpot::Interreflection
        | BlindSpot::AreaLights
        | BlindSpot::SkyLight
        | BlindSpot::PointLightCaustics
        | BlindSpot::PointLightCausticsInMirrors
        | BlindSpot::PointLightChains
        | BlindSpot::PointLightChainsInMirrors => true,
    });
    let is_steady = (!methods::never_hits(method) || drawn.sharpest() <= SHARP)
        && (!methods::walks_from_lights(method) || drawn.fronts_are_alike());
    !is_blind && is_steady
}

/// A rendering of a scene.
pub(super) fn part(drawn: &DrawnScene, built: &Arc<Built>, estimator: Estimator) -> Part {
    let is = |fact: fn(Method) -> bool| match estimator {
        Estimator::Method(method) => fact(method),
        Estimator::Among(_) => false,
    };
    let brightest = if is(methods::splats_alone) {
        brightest_splat(drawn, built)
    } else {
        brightest_walk(drawn, built)
    };
    let walks_hit = is(methods::finds_by_chance);
    let is_rare =
        walks_hit || drawn.has_mirrors() || drawn.sharpest() > SHARP || drawn.has_bright_spots();
    Part { built: Arc::clone(built), estimator, brightest, is_rare }
}

/// The greatest sample of walks from the camera: each edge may end on a lamp or in the sky,
/// and surfaces only weaken; or a point light shines on the surface nearest to it.
fn brightest_walk(drawn: &DrawnScene, built: &Built) -> f64 {
    let area = drawn.objects.iter().map(|object| luminance(object.emission)).fold(0.0, f32::max);
    let points = drawn.lights.iter().map(|light| {
        let mut dice = Dice::new(0, 0);
        let to_surface = |_| {
            let ray = Ray::new(light.position, dice.direction());
            built.scene.intersect(&ray).map(|point| (point.site.position - light.position).length())
        };
        let nearest = (0..200).filter_map(to_surface).fold(f32::INFINITY, f32::min);
        f64::from(luminance(light.intensity) / (nearest * nearest)) * lobe(drawn)
    });
    let texels = drawn.sky.iter().flat_map(|sky| &sky.texels);
    let sky = texels.map(|&texel| luminance(texel)).fold(0.0, f32::max);
    (f64::from(area + sky) + points.sum::<f64>()) * longest(drawn)
}

/// The greatest value of a lobe.
fn lobe(drawn: &DrawnScene) -> f64 {
    (f64::from(drawn.sharpest()) + 2.0) / (2.0 * PI)
}

/// The most that a light path adds to the picture, as a sample: it carries the power
/// of all lamps, or twice that of a weak one, which the brightest surface there is
/// throws at the camera from the nearest point that the camera sees.
fn brightest_splat(drawn: &DrawnScene, built: &Built) -> f64 {
    let scene = &built.scene;
    let power: f64 = scene.lights().iter().map(|light| f64::from(light.power().luminance())).sum();
    let camera = scene.camera();
    let nearest = |ray: Ray| {
        let point = scene.intersect(&ray)?;
        let distance = f64::from((point.site.position - camera.position()).length());
        Some(f64::from(camera.pdf(ray.direction).0) / (distance * distance))
    };
    let closeness = rays(camera).filter_map(nearest).fold(0.0, f64::max);
    let pixels = f64::from(camera.width() * camera.height());
    2.0 * power * lobe(drawn) * closeness / pixels * longest(drawn)
}

/// Returns how often a path may meet something, for all practical purposes.
fn longest(drawn: &DrawnScene) -> f64 {
    f64::from(drawn.max_depth.unwrap_or(10))
}

/// Nine for each pixel.
fn rays(camera: &Camera) -> impl Iterator<Item = Ray> {
    let (width, height) = (3 * camera.width(), 3 * camera.height());
    (0..width * height).map(move |i| {
        camera.ray(Vec2::new((i % width) as f32 + 0.5, (i / width) as f32 + 0.5) / 3.0)
    })
}

/// Tells whether the camera sees a mirror anywhere, also through what is before it; by
/// 9 rays a pixel.
fn sees_mirrors(scene: &Scene) -> bool {
    rays(scene.camera()).any(|mut ray| {
        for _ in 0..8 {
            let Some(point) = scene.intersect(&ray) else { return false };
            if point.model.has_delta_part() {
                return true;
            }
            if point.through == Rgb::BLACK {
                return false;
            }
            ray.origin = point.site.ray_origin(ray.direction);
        }
        true
    })
}
