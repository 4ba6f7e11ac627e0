//! Lamps as the scene knows them: how likely their points are, which side emits.

use super::*;
use crate::{CameraSettings, Object, ObjectShape, SceneBuilder};
use traylib_geometry::{Facing, Mesh, Primitive, Quad, Sides, Sphere};
use traylib_materials::{Lambert, Layer, Maps, SurfaceModel, Texture};
use traylib_math::{Grid, Sampler, warp};

const LEANING: Vec3 = Vec3::new(-0.8, 0.0, 0.6);

/// A scene with nothing but a camera in it.
pub(super) fn builder() -> SceneBuilder {
    let camera = Camera::new(CameraSettings {
        position: Vec3::new(0.0, 0.0, 9.0),
        target: Vec3::ZERO,
        up: Vec3::Y,
        fov_degrees: 40.0,
        width: 8,
        height: 8,
    });
    SceneBuilder::new(camera.unwrap())
}

fn add(builder: &mut SceneBuilder, shape: ObjectShape, radiance: f32) {
    let grey = Lambert::new(Rgb::splat(0.5)).unwrap();
    let material = builder.add_material(SurfaceModel::Lambert(grey));
    let emission = Rgb::splat(radiance);
    builder.add_object(Object { shape, sides: Sides::Both, material, emission }).unwrap();
}

/// A ball, a square and a point of unequal power.
fn three_lamps() -> Scene {
    let mut builder = builder();
    let ball = Sphere::new(Vec3::new(3.0, 0.0, 0.0), 1.0, Facing::Outward).unwrap();
    let square = Quad::new(Vec3::new(-3.0, -1.0, 0.0), 2.0 * Vec3::X, 2.0 * Vec3::Y).unwrap();
    add(&mut builder, ObjectShape::Primitive(Primitive::Sphere(ball)), 2.0);
    add(&mut builder, ObjectShape::Primitive(Primitive::Quad(square)), 5.0);
    builder.add_point_light(Vec3::new(0.0, 4.0, 0.0), Rgb::splat(7.0)).unwrap();
    builder.build().unwrap()
}

/// The densities that weights are made of are those that points are drawn with.
#[test]
fn densities_are_those_of_the_draws() {
    let scene = three_lamps();
    let mut sampler = Sampler::numbered(0, 0);
    let power: f32 = scene.lights().iter().map(|light| light.power().g).sum();
    let mut drawn = [0; 3];
    for _ in 0..20_000 {
        let x1 = 2.5 * warp::uniform_sphere(sampler.next_2d()) + Vec3::new(0.0, 0.0, 4.0);
        let choice = scene.choose_light_for(x1, sampler.next_fine());
        let (x0, pdf) = choice.light.sample_toward(x1, sampler.next_2d());
        let direction = (x1 - x0.site.position).normalize();
        let densities = scene.light_densities(choice.id, &x0, x1, direction);
        let close = |found: f32, drawn: f32| (found - drawn).abs() <= 1e-3 * drawn;
        assert!(close(densities.toward, choice.probability * pdf.0), "{x0:?} {densities:?}");
        let area = match choice.light {
            Light::Area { primitive, .. } => primitive.area(),
            Light::Point(_) | Light::Sky(_) => 1.0,
        };
        let by_power = choice.light.power().g / power;
        assert!(close(densities.emission, by_power / area), "{x0:?} {densities:?}");
        assert_eq!(densities.direction, x0.direction_pdf(direction));
        drawn[choice.id.0 as usize] += 1;
    }
    assert!(drawn.iter().all(|&n| n > 1000), "{drawn:?}");
}

/// Black, and there as far as a picture says: less at the left than at the right.
fn leaf() -> Material {
    let pixels = Grid::from_values(2, 1, vec![Rgb::splat(0.25), Rgb::WHITE]).unwrap();
    let opacity = Layer::new(Arc::new(Texture::new(pixels).unwrap()));
    let maps = Maps { opacity: Some(opacity), ..Maps::default() };
    let black = SurfaceModel::Lambert(Lambert::new(Rgb::BLACK).unwrap());
    Material { maps: Some(Box::new(maps)), ..Material::from(black) }
}

/// A point of a lamp emits what is there of the lamp where a ray meets it, from near and from
/// far, of a rectangle and of a slanting parallelogram.
#[test]
fn points_of_a_lamp_emit_by_the_opacity_where_they_are() {
    let mut sampler = Sampler::numbered(2, 0);
    for slant in [0.0, 0.3] {
        let mut builder = builder();
        let edge = Vec3::new(slant, 1.0, 0.0);
        let quad = Quad::new(Vec3::ZERO, 2.0 * Vec3::X, edge).unwrap();
        let shape = ObjectShape::Primitive(Primitive::Quad(quad));
        let material = builder.add_material(leaf());
        let emission = Rgb::splat(3.0);
        builder.add_object(Object { shape, sides: Sides::Both, material, emission }).unwrap();
        let scene = builder.build().unwrap();
        for _ in 0..2000 {
            let u = sampler.next_2d();
            let from = Vec3::new(0.7, 0.2, 0.05 + 4.0 * sampler.next_1d());
            let (point, _) = scene.sample_light(LightId(0), from, u);
            let met = scene.intersect(&Ray::new(from, point.site.position - from)).unwrap();
            let off = (point.emitted.g - 3.0 * met.opacity).abs();
            assert!(off < 1e-4, "{from} {u}: {point:?}, {}", met.opacity);
        }
    }
}

/// No lamp has so little power that it starts no light path: each owns some of the
/// steps of `u`.
#[test]
fn every_lamp_starts_light_paths() {
    let mut builder = builder();
    for exponent in (-100..=100).step_by(20) {
        builder.add_point_light(Vec3::ZERO, Rgb::splat(2_f32.powi(exponent))).unwrap();
    }
    let ball = Sphere::new(Vec3::X, 1e-6, Facing::Outward).unwrap();
    // So little that its power is zero in single precision.
    add(&mut builder, ObjectShape::Primitive(Primitive::Sphere(ball)), 1e-40);
    let scene = builder.build().unwrap();
    let mut found = vec![0; scene.lights().len()];
    for step in 0..4096 {
        let choice = scene.choose_light((f64::from(step) + 0.5) / 4096.0);
        assert!(choice.probability > 1.0 / (18 * found.len()) as f32);
        found[choice.id.0 as usize] += 1;
    }
    assert!(found.iter().all(|&count| count > 0), "{found:?}");
}

/// A triangle in the plane z = 0, its front up and its shading normal leaning by
/// more than a ray's.
fn leaning_lamp() -> Scene {
    let mut builder = builder();
    let corners = vec![Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::Y];
    let mesh = Mesh::new(corners, vec![[0, 1, 2]]).unwrap().with_normals(vec![LEANING; 3]).unwrap();
    add(&mut builder, ObjectShape::Mesh(mesh), 3.0);
    builder.build().unwrap()
}

/// Which side emits is the geometry's to say, whatever the shading normal.
#[test]
fn the_geometric_normal_decides_which_side_emits() {
    let scene = leaning_lamp();
    // Before the lamp but behind its shading normal, and the other way round.
    for (from, radiance) in [(Vec3::new(1.0, 0.0, 0.3), 3.0), (Vec3::new(-1.0, 0.0, -0.3), 0.0)] {
        assert!(LEANING.dot(from) * from.z < 0.0, "the two normals must disagree");
        let point = scene.intersect(&Ray::new(from, -from.normalize())).unwrap();
        assert_eq!(scene.emitted(&point), Rgb::splat(radiance), "from {from}");
    }
}
