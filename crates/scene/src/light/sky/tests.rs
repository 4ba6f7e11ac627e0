//! Directions of the sky and places where its light enters.

use super::picture::SkyPicture;
use super::shadow::BoxShadow;
use super::*;
use crate::{Camera, CameraSettings, Light, Object, ObjectShape, Scene, SceneBuilder};
use std::f32::consts::{PI, TAU};
use traylib_geometry::{Facing, Primitive, Quad, Sides, Sphere};
use traylib_materials::{Lambert, SurfaceModel};
use traylib_math::{Grid, Sampler, warp};

/// Rows of black, of colours and of a sun a thousand times as bright.
fn uneven() -> Grid<Rgb> {
    Grid::from_fn(7, 5, |index| match index {
        8 => Rgb::new(4e3, 3e3, 2e3),
        14..21 | 3 => Rgb::BLACK,
        34 => Rgb::new(0.0, 0.0, 1e-30),
        _ => Rgb::new(1.0, 0.5 + index as f32 / 30.0, 0.2),
    })
}

fn sampled(picture: &SkyPicture, seed: u64) -> impl Iterator<Item = Vec3> {
    let mut sampler = Sampler::numbered(seed, 0);
    std::iter::repeat_with(move || picture.sample(sampler.next_2d()))
}

/// The picture's places are where its documentation has them.
#[test]
fn a_picture_lies_around_the_scene() {
    let lit = |column: usize, row: usize, turn: f32| {
        let texel = |index| if index == 8 * row + column { Rgb::WHITE } else { Rgb::BLACK };
        SkyPicture::new(Grid::from_fn(8, 4, texel), turn.to_radians()).unwrap()
    };
    // A texel just right of the middle and above the horizon.
    let direction = |azimuth: f32, height: f32| {
        let (sin, cos) = azimuth.to_radians().sin_cos();
        Vec3::new(sin, height, -cos).normalize()
    };
    let seen =
        |picture: &SkyPicture, azimuth, height| picture.radiance(direction(azimuth, height)).g;
    let plain = lit(4, 1, 0.0);
    for azimuth in [1.0, 22.0, 44.0] {
        assert_eq!(seen(&plain, azimuth, 0.5), 1.0, "{azimuth}");
        assert_eq!(seen(&plain, azimuth, -0.5), 0.0, "{azimuth}");
        assert_eq!(seen(&plain, azimuth, 2.0), 0.0, "{azimuth}");
        assert_eq!(seen(&plain, -azimuth, 0.5), 0.0, "{azimuth}");
    }
    // A quarter turn brings what was ahead, −z, to the left, −x.
    let turned = lit(4, 1, 90.0);
    for azimuth in [-89.0, -46.0] {
        assert_eq!(seen(&turned, azimuth, 0.5), 1.0, "{azimuth}");
    }
    assert_eq!(seen(&turned, 1.0, 0.5), 0.0);
    // The first row is up.
    assert_eq!(lit(2, 0, 0.0).radiance(direction(-89.0, 3.0)).g, 1.0);
}

#[test]
fn the_density_is_one_all_around_and_follows_the_luminance() {
    for turn in [0.0, 1.0, -9.0] {
        let picture = SkyPicture::new(uneven(), turn).unwrap();
        let (n, mut sum) = (400, 0.0);
        for i in 0..n * n {
            let u = Vec2::new((i % n) as f32 + 0.5, (i / n) as f32 + 0.5) / n as f32;
            let direction = warp::uniform_sphere(u);
            let light = picture.radiance(direction);
            let pdf = picture.pdf(light);
            assert_eq!(pdf > 0.0, !light.is_black(), "{direction}");
            sum += f64::from(pdf);
        }
        let integral = sum * f64::from(2.0 * TAU) / f64::from(n * n);
        // Of the sun the grid knows the size to 1 %.
        assert!((integral - 1.0).abs() < 0.01, "{integral}");
        let luminance = picture.integral().luminance();
        for direction in sampled(&picture, 1).take(1000) {
            let light = picture.radiance(direction);
            let ratio = light.luminance() / picture.pdf(light);
            assert!((ratio / luminance - 1.0).abs() < 1e-5, "{ratio} {luminance}");
        }
    }
}

/// Directions within a texel are drawn alike: means of their coordinates are those of all of it.
#[test]
fn the_same_all_around_is_drawn_all_around() {
    let picture = SkyPicture::new(Grid::filled(1, 1, Rgb::splat(0.3)), 0.4).unwrap();
    assert!((picture.integral().g / (0.3 * 4.0 * PI) - 1.0).abs() < 1e-6);
    let (mut sum, mut squares, n) = (Vec3::ZERO, Vec3::ZERO, 100_000);
    for direction in sampled(&picture, 2).take(n) {
        assert!((picture.pdf(picture.radiance(direction)) * 4.0 * PI - 1.0).abs() < 1e-6);
        assert!(direction.is_normalized(), "{direction}");
        sum += direction / n as f32;
        squares += direction * direction / n as f32;
    }
    // Five standard errors.
    assert!(sum.abs().max_element() < 5.0 / (3.0 * n as f32).sqrt(), "{sum}");
    assert!((squares - 1.0 / 3.0).abs().max_element() < 5.0 * 0.3 / (n as f32).sqrt(), "{squares}");
}

#[test]
fn a_black_sky_is_none() {
    assert!(SkyPicture::new(Grid::filled(3, 2, Rgb::BLACK), 0.0).is_none());
    assert!(SkyPicture::new(Grid::filled(0, 0, Rgb::WHITE), 0.0).is_none());
    let mut builder = builder();
    builder.set_sky(Grid::filled(3, 2, Rgb::BLACK), 0.0).unwrap();
    assert!(matches!(builder.build(), Err(crate::Error::Dark)));
    let negative = Grid::filled(1, 1, Rgb::new(1.0, -1.0, 1.0));
    assert!(self::builder().set_sky(negative, 0.0).is_err());
}

/// Rays from the shadow cover a ball within the box as its cross-section has it.
#[test]
fn light_enters_alike_everywhere() {
    let bounds = Aabb { min: Vec3::new(-1.0, 2.0, 0.0), max: Vec3::new(3.0, 3.0, 0.5) };
    let shadow = BoxShadow::of(&bounds);
    let mut sampler = Sampler::numbered(3, 0);
    let ball = (Vec3::new(0.0, 2.4, 0.3), 0.15_f32);
    for _ in 0..20 {
        let toward = warp::uniform_sphere(sampler.next_2d());
        let n = 20_000;
        let mut met = 0;
        for _ in 0..n {
            let start = shadow.sample(toward, sampler.next_2d());
            let offset = ball.0 - start;
            // It starts outside of all that the box holds, and before the ball that it meets.
            assert!(!bounds.contains(start), "{start}");
            let meets = offset.cross(toward).length() < ball.1;
            assert!(!meets || offset.dot(-toward) > 0.0, "{start}");
            met += u32::from(meets);
        }
        let chance = PI * ball.1 * ball.1 / shadow.area(toward);
        let (mean, deviation) = (n as f32 * chance, (n as f32 * chance * (1.0 - chance)).sqrt());
        assert!((met as f32 - mean).abs() < 5.0 * deviation, "{toward}: {met} {mean}");
    }
    // Mean area over directions, as Cauchy has it.
    let directions = 20_000;
    let sum: f32 =
        (0..directions).map(|_| shadow.area(warp::uniform_sphere(sampler.next_2d()))).sum();
    assert!((sum / directions as f32 / shadow.mean_area() - 1.0).abs() < 0.02);
}

fn builder() -> SceneBuilder {
    let camera = CameraSettings {
        position: Vec3::new(0.0, 0.0, 9.0),
        target: Vec3::ZERO,
        up: Vec3::Y,
        fov_degrees: 40.0,
        width: 8,
        height: 8,
    };
    SceneBuilder::new(Camera::new(camera).unwrap())
}

/// A ball, and two lamps, or none, under the sky.
fn scene(has_lamps: bool) -> Scene {
    let mut builder = builder();
    let grey = Lambert::new(Rgb::splat(0.5)).unwrap();
    let material = builder.add_material(SurfaceModel::Lambert(grey));
    let mut add = |primitive, radiance| {
        let (shape, sides) = (ObjectShape::Primitive(primitive), Sides::Both);
        let object = Object { shape, sides, material, emission: Rgb::splat(radiance) };
        builder.add_object(object).unwrap();
    };
    add(Primitive::Sphere(Sphere::new(Vec3::ZERO, 1.0, Facing::Outward).unwrap()), 0.0);
    if has_lamps {
        let square = Quad::new(Vec3::new(-3.0, -1.0, 0.0), Vec3::X, Vec3::Y).unwrap();
        add(Primitive::Quad(square), 5.0);
        builder.add_point_light(Vec3::new(0.0, 4.0, 0.0), Rgb::splat(7.0)).unwrap();
    }
    builder.set_sky(uneven(), 30.0).unwrap();
    builder.build().unwrap()
}

/// The densities that weights are made of are those that points are drawn with, and lamps are
/// chosen as often as their chances say.
#[test]
fn densities_are_those_of_the_draws() {
    for (has_lamps, lamps) in [(false, 1), (true, 3)] {
        let scene = scene(has_lamps);
        assert_eq!(scene.lights().len(), lamps);
        let mut sampler = Sampler::numbered(4, 0);
        let (mut chosen, n) = ([0; 3], 20_000);
        let x1 = Vec3::new(0.0, 2.0, 2.0);
        for _ in 0..n {
            let choice = scene.choose_light_for(x1, sampler.next_fine());
            chosen[choice.id.0 as usize] += 1;
            let (x0, pdf) = scene.sample_light(choice.id, x1, sampler.next_2d());
            let (toward, distance_squared) = x0.seen_from(x1).unwrap();
            let densities = scene.light_densities(choice.id, &x0, x1, -toward);
            let drawn = choice.probability * pdf.0;
            assert!((densities.toward / drawn - 1.0).abs() < 1e-3, "{x0:?} {densities:?}");
            if let Light::Sky(sky) = choice.light {
                assert!(x0.is_sky && distance_squared == 1.0 && x0.cosine(-toward) == 1.0);
                assert_eq!(x0.emitted, sky.radiance(toward));
                let shadow = densities.direction.0 * sky.shadow.area(toward);
                assert!((shadow - 1.0).abs() < 1e-5);
                let ray = traylib_geometry::Ray::new(x1, toward);
                let behind = scene.sky_behind(&ray).unwrap();
                let (id, seen) = scene.emitting_point(&behind).unwrap();
                assert_eq!((id, seen.emitted), (choice.id, x0.emitted));
            }
        }
        let chance = |id| {
            let (light, by_power) = (scene.light(id), &scene.stage.light_by_power);
            let (x0, _) = scene.sample_light(id, x1, Vec2::splat(0.5));
            let (toward, _) = x0.seen_from(x1).unwrap();
            let densities = scene.light_densities(id, &x0, x1, -toward);
            let started = by_power.probability(id.0 as usize) * light.emission_pdf(&x0).0;
            assert_eq!(densities.emission, started);
            f64::from(densities.toward / light.toward_pdf(x1, &x0).0)
        };
        let chances: Vec<f64> = scene.light_ids().map(chance).collect();
        assert!((chances.iter().sum::<f64>() - 1.0).abs() < 1e-6, "{chances:?}");
        for (chance, found) in chances.iter().zip(chosen) {
            let deviation = (chance * (1.0 - chance) * f64::from(n)).sqrt();
            assert!(
                (f64::from(found) - chance * f64::from(n)).abs() <= 5.0 * deviation,
                "{chances:?}"
            );
        }
    }
}

/// What stands in the way to the sky blocks it, and panes weaken it, however far the way is.
#[test]
fn surfaces_hide_the_sky() {
    let scene = scene(false);
    let Some(Light::Sky(_)) = scene.lights().last() else { panic!() };
    let site = |position: Vec3| SurfaceSite { position, error: Vec3::ZERO, normal: Vec3::Y };
    let sky = scene.sky().unwrap();
    let below = sky.point(Vec3::Y).segment_from(&site(Vec3::new(0.0, -2.0, 0.0)));
    let above = sky.point(Vec3::Y).segment_from(&site(Vec3::new(0.0, 2.0, 0.0)));
    assert!(scene.transmittance(&below).is_black() && !scene.transmittance(&above).is_black());
}
