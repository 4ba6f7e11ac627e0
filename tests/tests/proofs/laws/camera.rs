//! Laws of the camera: the film point of a ray is where its points appear, the
//! density of a pixel's rays is one ray, and splats fill the picture.

use super::{FAST, LONG, sampler};
use std::f64::consts::PI;
use traylib_geometry::{Vec2, Vec3};
use traylib_integrators::Method;
use traylib_known::furnace::{diffuse_walls, glowing_ball};
use traylib_known::grid::{Counts, SIDE, even};
use traylib_known::stage::{Stage, black, camera_of_size, disk_facing_down, lambert, rectangle};
use traylib_known::{each_pass, samples_in_a_pass, settings_by_pass};
use traylib_scene::{Camera, Scene};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::laws::chi_square::follows;
use traylib_tests::laws::verdict::{Known, has_mean, same_bits, within, worse};
use traylib_tests::methods;

/// Fields of view in degrees, and films. Single precision keeps a direction to
/// 10⁻⁷, so a pixel must fill some 10⁻⁴ radians for a thousandth of it to be seen.
const CAMERAS: [(f32, [u32; 2]); 6] = [
    (40.0, [1, 1]),
    (90.0, [32, 32]),
    (40.0, [640, 361]),
    (120.0, [37, 211]),
    (160.0, [100, 100]),
    (60.0, [1920, 1080]),
];

fn views() -> impl Iterator<Item = (String, Camera)> {
    CAMERAS.into_iter().map(|(fov, film)| {
        let [width, height] = film;
        let (position, target) = (Vec3::new(0.3, -0.2, 1.0), Vec3::new(1.0, 0.5, -0.4));
        (format!("{width} × {height} film, {fov}°"), camera_of_size(position, target, fov, film))
    })
}

/// Film points a thousandth of a pixel inside the borders of their pixel, in all
/// columns of the first and last row, all rows of the first and last column,
/// and along a diagonal.
fn film_points(camera: &Camera) -> Vec<(u32, u32, Vec2)> {
    let (width, height) = (camera.width(), camera.height());
    let across = (0..width).flat_map(|x| [(x, 0), (x, height - 1), (x, x * height / width)]);
    let down = (0..height).flat_map(|y| [(0, y), (width - 1, y)]);
    let corners = [1e-3, 0.999].map(|x| [1e-3, 0.999].map(|y| Vec2::new(x, y))).concat();
    across
        .chain(down)
        .flat_map(|(x, y)| {
            let pixel = Vec2::new(x as f32, y as f32);
            corners.iter().map(move |&inside| (x, y, pixel + inside)).collect::<Vec<_>>()
        })
        .collect()
}

#[test]
fn points_appear_where_their_rays_went() {
    let finding = |(name, camera): (String, Camera)| {
        let points = film_points(&camera);
        let misplaced = points.iter().filter(|&&(x, y, point)| {
            let ray = camera.ray(point);
            [4.0, 300.0].into_iter().any(|far| {
                let seen = camera.project(ray.at(far));
                seen.map(|seen| (seen.x, seen.y)) != Some((x, y))
            })
        });
        let misplaced = misplaced.count();
        same_bits(format!("{name}: pixels of projected points"), misplaced, points.len())
    };
    settle(&views().map(finding).collect::<Vec<_>>());
}

/// The solid angle of the film's part left of and above a point at distance one:
/// ∫∫ (1 + x² + y²)^(−3/2) = atan(xy/√(1 + x² + y²)).
fn solid_angle(x: f64, y: f64) -> f64 {
    (x * y / (1.0 + x * x + y * y).sqrt()).atan()
}

/// ∫ We·cos over each pixel, as the sum over 4 × 4 parts of their solid angle by
/// the density in their middle, is one: so it is the number of pixels over the
/// whole film.
fn density_finding(name: &str, camera: &Camera, fov: f32) -> Finding {
    const FINE: u32 = 4;
    let (width, height) = (camera.width(), camera.height());
    let pixel = 2.0 * (f64::from(fov) / 360.0 * PI).tan() / f64::from(width);
    let edge = |i: u32, size: u32| pixel * (f64::from(i) / f64::from(FINE) - 0.5 * f64::from(size));
    let part = |x: u32, y: u32| {
        let ([left, right], [top, bottom]) =
            ([x, x + 1].map(|x| edge(x, width)), [y, y + 1].map(|y| edge(y, height)));
        let patch =
            solid_angle(right, bottom) - solid_angle(left, bottom) - solid_angle(right, top)
                + solid_angle(left, top);
        let middle = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / FINE as f32;
        patch * f64::from(camera.pdf(camera.ray(middle).direction).0)
    };
    let of_pixel = |x: u32, y: u32| {
        let parts = (0..FINE * FINE).map(|i| part(FINE * x + i % FINE, FINE * y + i / FINE));
        parts.sum::<f64>()
    };
    let (mut worst, mut total) = (0.0, 0.0);
    for y in 0..height {
        for x in 0..width {
            let integral = of_pixel(x, y);
            worst = worse(worst, (integral - 1.0).abs());
            total += integral;
        }
    }
    let mean = total / f64::from(width * height);
    within(
        format!("{name}: ∫ We cos over pixels = 1, sum = pixels"),
        worse(worst, (mean - 1.0).abs()),
        1e-3,
        0,
    )
}

#[test]
fn rays_of_a_pixel_have_density_one() {
    // A view of one pixel or of 160° changes too much from part to part, and the
    // spot's solid angles are differences of nearly equal numbers.
    let cases = [(90.0, [32, 32]), (40.0, [64, 37]), (120.0, [37, 211]), (10.0, [192, 108])];
    let findings = cases.map(|(fov, [width, height])| {
        let camera = camera_of_size(Vec3::ZERO, Vec3::new(1.0, 0.2, 0.3), fov, [width, height]);
        density_finding(&format!("{width} × {height} film, {fov}°"), &camera, fov)
    });
    settle(&findings);
}

/// Film points drawn as the integrators draw them fill their pixel evenly.
fn pixel_laws(samples: u64) {
    let mut sampler = sampler("film points");
    let camera = camera_of_size(Vec3::ZERO, Vec3::NEG_Z, 90.0, [SIDE as u32, SIDE as u32]);
    // Straight views have a plain inverse.
    let mut counts = Counts::new(0);
    for _ in 0..samples {
        let direction = camera.ray(sampler.next_2d() * SIDE as f32).direction;
        let [x, y] = [direction.x, -direction.y].map(|part| f64::from(part / -direction.z));
        counts.add([0.5 + 0.5 * x, 0.5 + 0.5 * y]);
    }
    settle(&[follows("rays through the film", &even(), &counts.cells)]);
}

#[test]
fn rays_fill_the_film() {
    pixel_laws(FAST);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn rays_fill_the_film_at_length() {
    pixel_laws(LONG);
}

/// Means of each column and each row, one number a pass.
fn lines(scene: &Scene, max_depth: u32, passes: u32) -> Vec<Vec<f64>> {
    let integrator = methods::PARTICLE.up_to(Some(max_depth)).build();
    let settings = settings_by_pass(passes, 181);
    let (width, height) = (scene.camera().width() as usize, scene.camera().height() as usize);
    let mut lines = vec![Vec::new(); width + height];
    let statistics = each_pass(scene, integrator.as_ref(), &settings, |pass| {
        let green = |x: usize, y: usize| pass.get(x, y)[1];
        for (x, line) in lines[..width].iter_mut().enumerate() {
            line.push((0..height).map(|y| green(x, y)).sum::<f64>() / height as f64);
        }
        for (y, line) in lines[width..].iter_mut().enumerate() {
            line.push((0..width).map(|x| green(x, y)).sum::<f64>() / width as f64);
        }
    });
    assert_eq!(statistics.rejected, 0);
    lines
}

/// In a ball that glows evenly every row and column is as bright as any other,
/// the first and the last too. With two edges a third of the light is splatted.
fn splat_laws(passes: u32, widest: f64) {
    let case = glowing_ball(diffuse_walls(), Some(2));
    let lines = lines(&case.scene, 2, passes);
    let samples = u64::from(passes) * lines.len() as u64 / 2;
    let known = Known { truth: case.truth, slack: 1e-4, widest };
    let findings = lines.iter().enumerate().map(|(i, line)| {
        let kind = if i < lines.len() / 2 { "column" } else { "row" };
        let claim = format!("splats in a glowing ball: {kind} {}", i % (lines.len() / 2));
        has_mean(claim, line, known, samples)
    });
    settle(&findings.collect::<Vec<_>>());
}

/// A line that got no splats would be darker by 0.5.
#[test]
fn splats_fill_the_picture() {
    splat_laws(200, 0.15);
}

#[test]
#[ignore = "at length: cargo xtask prove"]
fn splats_fill_the_picture_at_length() {
    splat_laws(20_000, 0.015);
}

/// A small white disk in front of a black wall, lit from nearby.
fn small_disk() -> Scene {
    let camera = camera_of_size(Vec3::new(0.0, 0.0, 0.0), Vec3::new(0.1, 0.2, 3.0), 40.0, [24, 20]);
    let centre = Vec3::new(0.35, 0.25, 3.0);
    let wall = rectangle(Vec3::new(-9.0, -9.0, 5.0), 18.0 * Vec3::X, 18.0 * Vec3::Y);
    Stage::new(camera)
        .surface(wall, black())
        .surface(disk_facing_down(centre, 0.12), lambert(0.9))
        .point(centre - 0.1 * Vec3::Z, 1.0)
        .build()
}

/// Column and row of the middle of the light.
fn centroid(scene: &Scene, method: Method, passes: u32) -> [f64; 2] {
    let integrator = method.up_to(Some(2)).build();
    let settings = settings_by_pass(passes, 182);
    let (mut moments, mut total) = ([0.0; 2], 0.0);
    each_pass(scene, integrator.as_ref(), &settings, |pass| {
        for (i, bands) in pass.values().iter().enumerate() {
            for (moment, place) in moments.iter_mut().zip([i % pass.width(), i / pass.width()]) {
                *moment += bands[1] * (place as f64 + 0.5);
            }
            total += bands[1];
        }
    });
    moments.map(|moment| moment / total)
}

/// A surface is seen and splatted in the same place. The disk's points deviate by 0.7 pixels from
/// its middle and a fifth of all light paths hit it, so 400 passes leave a standard error of 0.004
/// pixels: a twelfth of what is allowed. A picture that is a pixel off is far beyond.
fn place_laws(passes: u32) {
    let scene = small_disk();
    let [seen, splatted] =
        [methods::PURE_MC, methods::PARTICLE].map(|method| centroid(&scene, method, passes));
    let samples = u64::from(passes) * samples_in_a_pass(&scene);
    let findings = ["column", "row"].into_iter().zip(seen.into_iter().zip(splatted));
    let findings = findings.map(|(name, (seen, splatted))| {
        let claim = format!("a small disk, seen and splatted: {name}");
        within(claim, (seen - splatted).abs(), 0.05, samples)
    });
    settle(&findings.collect::<Vec<_>>());
}

#[test]
fn splats_land_where_rays_go() {
    place_laws(400);
}
