//! Images of points against lights behind the mirror.

use super::*;
use crate::{Camera, CameraSettings, Object, ObjectShape, SceneBuilder};
use traylib_geometry::{Disk, Facing, Primitive, Quad, Sides, Sphere, Triangle};
use traylib_materials::{Lambert, Mirror as IdealMirror, SurfaceModel};
use traylib_math::Sampler;

/// A point light over mirrors of each shape, all parts `scale` times as large.
fn scene(scale: f32, mirrors: &[Primitive]) -> Scene {
    let camera = Camera::new(CameraSettings {
        position: scale * Vec3::new(0.0, 1.0, 4.0),
        target: scale * Vec3::Y,
        up: Vec3::Y,
        fov_degrees: 45.0,
        width: 8,
        height: 8,
    });
    let mut builder = SceneBuilder::new(camera.unwrap());
    let mirror = IdealMirror::new(Rgb::splat(0.8), Rgb::BLACK).unwrap();
    let mirror = builder.add_material(SurfaceModel::Mirror(mirror));
    let white = builder.add_material(SurfaceModel::Lambert(Lambert::new(Rgb::WHITE).unwrap()));
    let floor =
        quad(scale * Vec3::new(-4.0, 0.0, -4.0), scale * 8.0 * Vec3::Z, scale * 8.0 * Vec3::X);
    let all = mirrors.iter().map(|shape| (*shape, mirror)).chain([(floor, white)]);
    for (shape, material) in all {
        let shape = ObjectShape::Primitive(shape);
        let emission = Rgb::BLACK;
        builder.add_object(Object { shape, sides: Sides::Both, material, emission }).unwrap();
    }
    builder.add_point_light(scale * Vec3::new(0.5, 1.0, 0.25), Rgb::splat(3.0)).unwrap();
    builder.build().unwrap()
}

fn quad(corner: Vec3, u: Vec3, v: Vec3) -> Primitive {
    Primitive::Quad(Quad::new(corner, u, v).unwrap())
}

/// The mirror x = −1, between y = 0 and 1 and z = −1 and 1.
fn wall(scale: f32) -> Primitive {
    quad(scale * Vec3::new(-1.0, 0.0, -1.0), scale * Vec3::Y, scale * 2.0 * Vec3::Z)
}

fn globe(scale: f32) -> Primitive {
    let centre = scale * Vec3::new(-1.5, 0.5, -0.5);
    Primitive::Sphere(Sphere::new(centre, scale * 0.5, Facing::Outward).unwrap())
}

fn floor_point(scene: &Scene, at: Vec3) -> SurfacePoint {
    scene.intersect(&Ray::new(at + 0.25 * at.length() * Vec3::Y, -Vec3::Y)).unwrap()
}

const ANYHOW: [f64; 2] = [0.5; 2];

type Inside = fn(Vec3) -> bool;

/// As a second light behind the wall, where the way to it leads through the wall.
#[test]
fn a_flat_mirror_shows_a_light_behind_it() {
    let [a, b, c] = [[0.0, -1.0], [1.0, -1.0], [0.0, 1.0]].map(|[y, z]| Vec3::new(-1.0, y, z));
    let triangle = Primitive::Triangle(Triangle::new(a, b, c).unwrap());
    let centre = Vec3::new(-1.0, 0.5, 0.0);
    let disk = Primitive::Disk(Disk::new(centre, Vec3::X, 0.5).unwrap());
    let image = Vec3::new(-2.5, 1.0, 0.25);
    let inside: [(Primitive, Inside); 3] = [
        (wall(1.0), |at| (0.0..1.0).contains(&at.y) && at.z.abs() < 1.0),
        (triangle, |at| at.y > 0.0 && at.z > -1.0 && at.y + 0.5 * (at.z + 1.0) < 1.0),
        (disk, |at| (at - Vec3::new(-1.0, 0.5, 0.0)).length() < 0.5),
    ];
    for (mirror, is_inside) in inside {
        let scene = scene(1.0, &[mirror]);
        let mut sampler = Sampler::numbered(12, 0);
        let (mut seen, mut missed) = (0, 0);
        for _ in 0..500 {
            let u = sampler.next_2d();
            let point = floor_point(&scene, Vec3::new(3.0 * u.x - 0.9, 0.0, 4.0 * u.y - 2.0));
            let from = point.site.position;
            let to_image = image - from;
            let at = from + to_image * ((-1.0 - from.x) / to_image.x);
            let found: Vec<PointImage> = scene.point_images(&point, ANYHOW).collect();
            assert_eq!(found.len(), usize::from(is_inside(at)), "{from} {at}");
            seen += found.len();
            missed += 1 - found.len();
            for PointImage { wi, seen_at, irradiance, .. } in found {
                assert!((seen_at.position - at).length() < 1e-6);
                assert!((wi - to_image.normalize()).length() < 1e-6);
                let expected = 0.8 * 3.0 / to_image.length_squared();
                assert!((irradiance.g / expected - 1.0).abs() < 1e-6);
            }
        }
        assert!(seen > 30 && missed > 30, "{seen} {missed}");
    }
}

/// No image of what is behind a mirror, or for who is.
#[test]
fn both_must_be_before_a_mirror() {
    let scene = scene(1.0, &[wall(1.0)]);
    let behind = floor_point(&scene, Vec3::new(-2.0, 0.0, 0.0));
    assert_eq!(scene.point_images(&behind, ANYHOW).count(), 0);
}

/// Sizes are no business of images: the same bits at any power of two.
#[test]
fn scale_does_not_matter_to_points() {
    let at = |scale: f32| {
        let scene = scene(scale, &[wall(scale), globe(scale)]);
        let mut found = Vec::new();
        for i in 0..50 {
            let x = 0.05 * i as f32 - 0.75;
            let point = floor_point(&scene, scale * Vec3::new(x, 0.0, 0.5));
            for PointImage { wi, seen_at, irradiance, .. } in scene.point_images(&point, ANYHOW) {
                found.push((wi, seen_at.position / scale, irradiance * (scale * scale)));
            }
        }
        found
    };
    let natural = at(1.0);
    assert!(natural.len() > 50, "{}", natural.len());
    for scale in [1.0 / 1024.0, 4096.0] {
        assert_eq!(at(scale), natural);
    }
}

const STEPS: u32 = 20_000;

/// Of very many mirrors one is looked at, as often as its chance says.
#[test]
fn one_of_many_stands_for_all() {
    // The wall in 50 strips of unequal width.
    let edges: Vec<f32> = (0..=50).map(|i| (i as f32 / 50.0).powi(2)).collect();
    let strips: Vec<Primitive> = edges
        .windows(2)
        .map(|pair| {
            let corner = Vec3::new(-1.0, pair[0], -1.0);
            quad(corner, (pair[1] - pair[0]) * Vec3::Y, 2.0 * Vec3::Z)
        })
        .collect();
    let (whole, cut) = (scene(1.0, &[wall(1.0)]), scene(1.0, &strips));
    let at = Vec3::new(0.5, 0.0, 0.25);
    let [whole, one_by_one] = [&whole, &cut].map(|scene| {
        let point = floor_point(scene, at);
        // Every number is tried alike: a mean without chance, but for the steps.
        let sum: f64 = (0..STEPS)
            .map(|i| (f64::from(i) + 0.5) / f64::from(STEPS))
            .flat_map(|u| scene.point_images(&point, [u, 0.5]).map(|image| image.irradiance.g))
            .map(f64::from)
            .sum();
        sum / f64::from(STEPS)
    });
    assert!((one_by_one / whole - 1.0).abs() < 0.01, "{whole} {one_by_one}");
}

#[test]
fn scenes_without_points_or_mirrors_have_no_images() {
    assert!(!scene(1.0, &[]).has_point_images());
    assert!(scene(1.0, &[globe(1.0)]).has_point_images());
}
