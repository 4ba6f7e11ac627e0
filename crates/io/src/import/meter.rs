//! An exposure where light has no unit: what a meter beside the surfaces in view shows.
//!
//! A 3DS file's lights say how bright each is, not what of it a picture shall keep: many
//! of them add up, and near ones are stronger by the square of the distance. So the light
//! that lamps throw on what the camera sees is measured: what part of white a surface
//! would show there that reflects all. Under the exposure taken this is one half on
//! average, what is brighter than white counted as white, and what no lamp reaches left
//! out: a surface that reflects half is shown as middle grey, as in MGF files.

use std::f32::consts::FRAC_1_PI;
use traylib_geometry::Ray;
use traylib_math::{Rgb, Vec2, solid_angle_per_area};
use traylib_scene::{MAX_PASS_THROUGHS, Scene, SurfacePoint};

/// Points that are looked at, across the picture and down.
const GRID: [u32; 2] = [32, 24];
/// Tries to reach a lamp from each.
const TRIES: u32 = 16;
/// Part of white that a white surface shows on average.
const AVERAGE: f64 = 0.5;
/// Multiples of these lie evenly in [0, 1), in one to three dimensions together (Roberts,
/// *The unreasonable effectiveness of quasirandom sequences*, 2018).
const EVEN: [f64; 3] = [0.819_172_513_396_164_5, 0.671_043_606_703_789_2, 0.549_700_477_901_970_1];

/// The factor on radiance that shows the scene well; `None` if no lamp reaches anything
/// in view.
pub(super) fn exposure(scene: &Scene) -> Option<f64> {
    let camera = scene.camera();
    let size = Vec2::new(camera.width() as f32, camera.height() as f32);
    let [columns, rows] = GRID;
    let mut lit = Vec::new();
    for index in 0..columns * rows {
        let cell = Vec2::new((index % columns) as f32, (index / columns) as f32);
        let at = (cell + 0.5) / Vec2::new(columns as f32, rows as f32) * size;
        let Some(point) = surface(scene, scene.camera().ray(at)) else { continue };
        let light = incident(scene, &point, index * TRIES);
        if light > 0.0 && light.is_finite() {
            lit.push(light);
        }
    }
    factor(&mut lit)
}

/// The first surface of a ray that light does not pass through for the most part.
fn surface(scene: &Scene, mut ray: Ray) -> Option<SurfacePoint> {
    for _ in 0..MAX_PASS_THROUGHS {
        let point = scene.intersect(&ray)?;
        if point.through.luminance() <= 0.5 {
            return Some(point);
        }
        ray.origin = point.site.ray_origin(ray.direction);
    }
    None
}

/// The radiance of a diffuse white surface there, under lamps alone.
fn incident(scene: &Scene, point: &SurfacePoint, first: u32) -> f64 {
    let tried = |index| light(scene, point, f64::from(first + index + 1)).unwrap_or(Rgb::BLACK);
    let sum: f64 = (0..TRIES).map(|index| f64::from(tried(index).luminance())).sum();
    sum / f64::from(TRIES)
}

/// One try to reach a lamp.
fn light(scene: &Scene, point: &SurfacePoint, number: f64) -> Option<Rgb> {
    let [u, v, w] = EVEN.map(|step| (step * number).fract());
    let x1 = point.site.position;
    let choice = scene.choose_light_for(x1, u);
    if point.light == Some(choice.id) {
        return None;
    }
    let (x0, pdf) = scene.sample_light(choice.id, x1, Vec2::new(v as f32, w as f32));
    let offset = x0.site.position - x1;
    let wi = offset.try_normalize()?;
    let (cosine, falloff) = (point.normal.dot(wi), x0.falloff(-wi));
    if pdf.0 <= 0.0 || cosine <= 0.0 || falloff <= 0.0 {
        return None;
    }
    let passed = scene.transmittance(&x0.segment_from(&point.site));
    let measure = solid_angle_per_area(falloff, offset.length_squared());
    Some(passed * x0.emitted * (FRAC_1_PI * cosine * measure / (choice.probability * pdf.0)))
}

/// Under which the average of the values, each at most one, is as wanted.
fn factor(values: &mut [f64]) -> Option<f64> {
    values.sort_unstable_by(f64::total_cmp);
    let wanted = AVERAGE * values.len() as f64;
    let (mut below, mut found) = (0.0, None);
    for (index, &value) in values.iter().enumerate() {
        below += value;
        let clipped = values.len() - 1 - index;
        let factor = (wanted - clipped as f64) / below;
        let fits = factor * value <= 1.0;
        found = if factor > 0.0 && fits { Some(factor) } else { found };
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_average_of_what_a_screen_can_show_is_one_half() {
        assert_eq!(factor(&mut [0.25; 4]), Some(2.0));
        // One is clipped, two others show 0.25 each.
        assert_eq!(factor(&mut [0.1, 1e9, 0.1]), Some(2.5));
        assert_eq!(factor(&mut []), None);
    }
}
