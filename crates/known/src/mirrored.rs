//! C1 to C4 and C6: light that mirrors throw onto the floor.
//!
//! A lamp at the height 1 shines up at a plane mirror at the height 2, and from
//! there onto a diffuse floor at the height 0. By the method of images the floor
//! sees, in the mirror, a lamp at the height 3: with the mirror's reflectance km
//! it has the radiance L = ρ·km·Le·F, F that of the part of the image that is
//! seen through the mirror and beside the lamp itself, which is black from
//! behind and casts a shadow. Paths have three edges.

use crate::case::Case;
use crate::polygon::{clip, factor, square_at, through};
use crate::stage::{
    Stage, ball, black, camera, disk_facing_down, disk_facing_up, floor, lambert, mirror,
    rectangle, spot,
};
use glam::DVec3;
use std::f64::consts::PI;
use std::sync::Arc;
use traylib_geometry::{Primitive, Vec3};
use traylib_materials::{Layer, Maps, Material, SurfaceModel, Texture};
use traylib_math::{Grid, Rgb, Vec2};
use traylib_scene::{Camera, Scene};

const FLOOR: f64 = 0.8;
const MIRROR: f64 = 0.9;
const RADIANCE: f64 = 100.0;
/// The intensity of a point light in the lamp's place, in W/sr.
const INTENSITY: f64 = 5.0;
/// Half-side of the lamp.
const LAMP: f64 = 0.1;
/// Half-side of a mirror that cuts nothing off what the camera sees: the way
/// from the floor at 1.2 to the far end of the image crosses it at 0.47.
pub const WIDE_MIRROR: f64 = 0.6;
/// Half-side of a mirror that cuts off the light of the outer parts of the view,
/// with half shadows from 0.7 to 1.1.
pub const NARROW_MIRROR: f64 = 0.3;

/// A scene and what each pixel of its picture should be.
#[derive(Debug)]
pub struct Picture {
    /// The name of the picture in a report.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// The longest path, in edges.
    pub max_depth: Option<u32>,
    /// The mean radiance over each pixel, in W/m²/sr.
    pub truth: Grid<f64>,
}

/// C1: seen from right below the lamp, 64 × 64 pixels over |x|, |y| ≤ 1.2.
pub fn mirrored_light(mirror_half_side: f64) -> Picture {
    let scene = below_mirror(overhead(), mirror_half_side, mirror(MIRROR as f32, 0.0)).build();
    let lit = |x: DVec3| FLOOR * MIRROR * RADIANCE * image_factor(x, mirror_half_side);
    let truth = over_pixels(scene.camera(), lit);
    let name = format!("C1 half-side {mirror_half_side}");
    Picture { name, scene, max_depth: Some(3), truth }
}

/// C2: the point (1, 0) of the floor of C1 seen in a second mirror, the plane
/// x = 1.6 near the floor: one more factor km and one more edge. The second
/// mirror stands behind the point, and what it reflects onto the floor has more
/// edges still before it is seen.
pub fn mirrored_light_in_a_mirror() -> Case {
    let scene = second_mirror(below_mirror(in_mirror(), WIDE_MIRROR, mirror(MIRROR as f32, 0.0)));
    let seen = image_factor(DVec3::X, WIDE_MIRROR);
    let truth = FLOOR * MIRROR * MIRROR * RADIANCE * seen;
    Case { name: "C2".into(), scene: scene.build(), max_depth: Some(4), truth }
}

/// C2 by a mirror of which nothing is there beyond x₀, in the middle of the lamp's image: light
/// passes into the void there. A texture of 4096 pixels has the step, x₀ at the edge of one.
pub fn mirrored_light_in_a_mirror_with_a_hole() -> Case {
    const PIXELS: usize = 4096;
    // The image of the lamp's middle is seen at x = 1/3.
    let from_corner = |x: f64| (x + WIDE_MIRROR) / (2.0 * WIDE_MIRROR);
    let there = (from_corner(1.0 / 3.0) * PIXELS as f64).round() as usize;
    let x_0 = there as f64 / PIXELS as f64 * 2.0 * WIDE_MIRROR - WIDE_MIRROR;
    let pixels = (0..PIXELS).map(|i| if i < there { Rgb::WHITE } else { Rgb::BLACK }).collect();
    let texture = Grid::from_values(PIXELS, 1, pixels).and_then(Texture::new).map(Arc::new);
    let maps = Maps { opacity: texture.map(Layer::new), ..Maps::default() };
    let pierced = Material { maps: Some(Box::new(maps)), ..mirror(MIRROR as f32, 0.0).into() };
    let scene = second_mirror(below_mirror(in_mirror(), WIDE_MIRROR, pierced));
    let whole = square_at(2.0, WIDE_MIRROR);
    let rest = clip(&whole, x_0 * DVec3::X, DVec3::NEG_X);
    let truth = FLOOR * MIRROR * MIRROR * RADIANCE * image_factor_through(DVec3::X, &rest);
    Case { name: "C2 with a hole".into(), scene: scene.build(), max_depth: Some(4), truth }
}

/// C3: C1 with a point light I and a black plate of radius 0.2 below it. Its
/// image at the height 3 gives L = ρ/π·km·I·cosθ/d² = ρ/π·km·I·3/d³ outside the
/// plate's shadow, a disk of radius 0.2·3/(3 − 0.98). Direct light begins
/// beyond x = 10.
pub fn mirrored_point() -> Case {
    let scene = point_below_mirror(from_below(), mirror(MIRROR as f32, 0.0)).build();
    Case { name: "C3".into(), truth: mean_of_mirrored_point(|_| 1.0), scene, max_depth: Some(3) }
}

/// C3 by a mirror of which a part o is there, the rest lets light through into the void: o falls
/// evenly from 1 where u is ¼ to 0 where it is ¾ and rises again, u = ½ + x/(2·0.75), as a texture
/// of two pixels has it. A floor's point at x sees the image at x/3 on the mirror.
pub fn point_below_faded_mirror() -> Case {
    let pixels = Grid::from_values(2, 1, vec![Rgb::WHITE, Rgb::BLACK]);
    let texture = pixels.and_then(Texture::new).map(Arc::new);
    let maps = Maps { opacity: texture.map(Layer::new), ..Maps::default() };
    let faded = Material { maps: Some(Box::new(maps)), ..mirror(MIRROR as f32, 0.0).into() };
    let there = |x: DVec3| {
        let u = 0.5 + x.x / 3.0 / (2.0 * f64::from(POINT_MIRROR));
        2.0 * ((u - 0.25).rem_euclid(1.0) - 0.5).abs()
    };
    let scene = point_below_mirror(from_below(), faded).build();
    let truth = mean_of_mirrored_point(there);
    Case { name: "C3 by a faded mirror".into(), scene, max_depth: Some(3), truth }
}

/// Returns the mean radiance that C3's camera sees of a floor whose points see this part of the
/// image.
fn mean_of_mirrored_point(part: impl Fn(DVec3) -> f64) -> f64 {
    let shadow = 0.2 * 3.0 / (3.0 - f64::from(PLATE));
    crate::case::mean_over_floor(&from_below(), |x| {
        let x = DVec3::from(x);
        let square = x.dot(x);
        let seen = if square < shadow * shadow { 0.0 } else { part(x) };
        seen * FLOOR * MIRROR / PI * INTENSITY * 3.0 / (square + 9.0).powf(1.5)
    })
}

/// C3 with a ball of radius ½ in the mirror's place, at the height 2: what it should be is known
/// from one method to another alone.
pub fn point_below_ball() -> Scene {
    let stage =
        Stage::new(from_below()).surface(ball(2.0 * Vec3::Z, 0.5), mirror(MIRROR as f32, 0.0));
    point_over_floor(stage).build()
}

/// C2 and C3 together: light that can only be joined by way of the mirror.
pub fn mirrored_point_in_a_mirror() -> Case {
    let scene = second_mirror(point_below_mirror(in_mirror(), mirror(MIRROR as f32, 0.0))).build();
    let truth = FLOOR * MIRROR * MIRROR / PI * INTENSITY * 3.0 / 10.0_f64.powf(1.5);
    Case { name: "C2 + C3".into(), scene, max_depth: Some(4), truth }
}

/// C6: a lamp, seen from the floor through a periscope by way of two mirrors.
///
/// Both are planes at 45 degrees, 2 m apart, so that the lamp, a disk of radius r at (2, 0, 3),
/// has its image straight above the floor's point 0 at the height 5: L = ρ·km²·Le·r²/(r² + 25).
/// A black wall keeps the lamp's own light off, and the floor that it lights out of sight. Paths
/// have four edges.
pub fn periscope() -> Case {
    let scene = periscope_lamp(Stage::new(spot(Vec3::new(0.0, -1.0, 0.5), Vec3::ZERO)));
    Case { name: "C6".into(), scene, max_depth: Some(4), truth: of_periscope_lamp(2) }
}

/// C6 seen in a third mirror, the plane x = −0.6 near the floor: light that nothing connects.
pub fn periscope_in_a_mirror() -> Case {
    let scene = periscope_lamp(beside_periscope());
    Case { name: "C6 in a mirror".into(), scene, max_depth: Some(5), truth: of_periscope_lamp(3) }
}

/// C6 in a mirror with a point light in the lamp's place, L = ρ/π·km³·I/25: it can only be joined
/// by way of both mirrors.
pub fn point_in_periscope() -> Case {
    let scene = below_periscope(beside_periscope()).point(PERISCOPE_LAMP, INTENSITY as f32);
    let truth = FLOOR * MIRROR.powi(3) / PI * INTENSITY / 25.0;
    Case { name: "C6 by a point".into(), scene: scene.build(), max_depth: Some(5), truth }
}

/// Makes this scene where the camera sees the floor, L = ρ/π·km²·I/25: light walks find it too.
pub fn point_in_bare_periscope() -> Case {
    let stage = Stage::new(spot(Vec3::new(0.0, -1.0, 0.5), Vec3::ZERO));
    let scene = below_periscope(stage).point(PERISCOPE_LAMP, INTENSITY as f32);
    let truth = FLOOR * MIRROR.powi(2) / PI * INTENSITY / 25.0;
    Case { name: "C6 by a bare point".into(), scene: scene.build(), max_depth: Some(4), truth }
}

const PERISCOPE_LAMP: Vec3 = Vec3::new(2.0, 0.0, 3.0);
const PERISCOPE_RADIUS: f32 = 0.05;

/// After so many mirrors.
fn of_periscope_lamp(mirrors: i32) -> f64 {
    let square = f64::from(PERISCOPE_RADIUS).powi(2);
    FLOOR * MIRROR.powi(mirrors) * RADIANCE * square / (square + 25.0)
}

fn periscope_lamp(stage: Stage) -> Scene {
    let lamp = disk_facing_down(PERISCOPE_LAMP, PERISCOPE_RADIUS);
    below_periscope(stage).light(lamp, RADIANCE as f32, black()).build()
}

fn below_periscope(stage: Stage) -> Stage {
    // Half-side 0.4 and more.
    let slope = Vec3::new(0.8, 0.0, 0.8);
    let pane = |middle: Vec3| rectangle(middle - 0.5 * (slope + Vec3::Y), slope, Vec3::Y);
    let wall = rectangle(Vec3::new(1.0, -4.0, 0.0), 8.0 * Vec3::Y, 1.9 * Vec3::Z);
    stage
        .surface(floor(), lambert(FLOOR as f32))
        .surface(pane(Vec3::new(0.0, 0.0, 2.0)), mirror(MIRROR as f32, 0.0))
        .surface(pane(Vec3::new(2.0, 0.0, 2.0)), mirror(MIRROR as f32, 0.0))
        .surface(wall, black())
}

fn beside_periscope() -> Stage {
    let eye = spot(Vec3::new(-0.2, 0.0, 0.3), Vec3::new(-1.2, 0.0, 0.0));
    // Too low to throw the lamp's own light onto the point: that would be at 0.56.
    let third = rectangle(Vec3::new(-0.6, -0.5, 0.0), 0.4 * Vec3::Z, Vec3::Y);
    Stage::new(eye).surface(third, mirror(MIRROR as f32, 0.0))
}

/// C4: C1 with another surface in the mirror's place, and what sharp lobes on it
/// converge to: a lobe of Phong's model reflects ks times the cosine of the
/// angle of incidence (its albedo there), and lamp, mirror and floor share that
/// angle. The cosine is taken at the middle of the image, of half-angle 2°.
pub fn mirrored_in(model: SurfaceModel, specular: f64) -> Picture {
    let scene = below_mirror(overhead(), WIDE_MIRROR, model).build();
    let lit = |x: DVec3| {
        let cosine = 3.0 / (DVec3::new(0.0, 0.0, 3.0) - x).length();
        FLOOR * specular * cosine * RADIANCE * image_factor(x, WIDE_MIRROR)
    };
    let truth = over_pixels(scene.camera(), lit);
    Picture { name: "C4".into(), scene, max_depth: Some(3), truth }
}

/// F of what the floor's point sees of the lamp's image: through the mirror, but
/// for what is behind the lamp.
fn image_factor(point: DVec3, mirror_half_side: f64) -> f64 {
    image_factor_through(point, &square_at(2.0, mirror_half_side))
}

/// Computes this factor through a mirror with these corners.
fn image_factor_through(point: DVec3, mirror: &[DVec3]) -> f64 {
    let seen = through(point, &square_at(3.0, LAMP), mirror);
    let hidden = through(point, &seen, &square_at(1.0, LAMP));
    factor(point, DVec3::Z, &seen) - factor(point, DVec3::Z, &hidden)
}

/// Straight down on |x|, |y| ≤ 1.2 from right below the lamp.
fn overhead() -> Camera {
    camera(0.9 * Vec3::Z, Vec3::ZERO, 2.0 * (1.2_f32 / 0.9).atan().to_degrees(), 64)
}

/// At the image of the floor's point (1, 0) in the plane x = 1.6.
fn in_mirror() -> Camera {
    spot(Vec3::new(1.2, 0.0, 0.3), Vec3::new(2.2, 0.0, 0.0))
}

fn below_mirror(camera: Camera, half_side: f64, mirror: impl Into<Material>) -> Stage {
    let lamp = square_up(1.0, LAMP as f32);
    Stage::new(camera)
        .surface(floor(), lambert(FLOOR as f32))
        .surface(square_up(2.0, half_side as f32), mirror)
        .solid_light(lamp, RADIANCE as f32, black())
}

/// Height of the plate below the point light.
const PLATE: f32 = 0.98;

/// Half-side of the mirror above the point light.
const POINT_MIRROR: f32 = 0.75;

/// Straight down on |x|, |y| ≤ 1.8 from right below the point light.
fn from_below() -> Camera {
    camera(0.9 * Vec3::Z, Vec3::ZERO, 2.0 * 2.0_f32.atan().to_degrees(), 32)
}

fn point_below_mirror(camera: Camera, mirror: impl Into<Material>) -> Stage {
    point_over_floor(Stage::new(camera).surface(square_up(2.0, POINT_MIRROR), mirror))
}

fn point_over_floor(stage: Stage) -> Stage {
    stage
        .surface(floor(), lambert(FLOOR as f32))
        .surface(disk_facing_up(PLATE * Vec3::Z, 0.2), black())
        .point(Vec3::Z, INTENSITY as f32)
}

fn second_mirror(stage: Stage) -> Stage {
    let edges = [Vec3::Z, Vec3::Y];
    stage.surface(
        rectangle(Vec3::new(1.6, -0.5, 0.0), edges[0], edges[1]),
        mirror(MIRROR as f32, 0.0),
    )
}

fn square_up(height: f32, half_side: f32) -> Primitive {
    let a = half_side;
    rectangle(Vec3::new(-a, -a, height), 2.0 * a * Vec3::X, 2.0 * a * Vec3::Y)
}

/// The mean over each pixel of what is seen of the floor, by the midpoint rule on
/// 4 × 4 film points.
fn over_pixels(camera: &Camera, radiance: impl Fn(DVec3) -> f64) -> Grid<f64> {
    const STEPS: u32 = 4;
    let mut truth = Grid::filled(camera.width() as usize, camera.height() as usize, 0.0);
    let width = camera.width();
    for (pixel, mean) in (0..).zip(truth.values_mut()) {
        let corner = Vec2::new((pixel % width) as f32, (pixel / width) as f32);
        let sum: f64 = (0..STEPS * STEPS)
            .map(|i| Vec2::new((i % STEPS) as f32 + 0.5, (i / STEPS) as f32 + 0.5))
            .map(|within| camera.ray(corner + within / STEPS as f32))
            .map(|ray| radiance(DVec3::from(ray.at(-ray.origin.z / ray.direction.z))))
            .sum();
        *mean = sum / f64::from(STEPS * STEPS);
    }
    truth
}
