//! Details are where they are, and what is left is the rest.

use super::*;
use crate::scene::tests::builder;
use crate::{Object, ObjectShape};
use traylib_geometry::{Facing, Mesh, Primitive, Quad, Ray, Sides, Sphere};
use traylib_materials::{Bump, Lambert, Layer, Maps, SurfaceModel, Texture};
use traylib_math::{Grid, Rgb, Vec3};

/// Two halves, dark and bright.
fn picture() -> Layer {
    let pixels = Grid::from_values(2, 1, vec![Rgb::splat(0.2), Rgb::splat(0.6)]).unwrap();
    Layer::new(Arc::new(Texture::new(pixels).unwrap()))
}

fn coloured() -> Maps {
    Maps { diffuse: Some(picture()), ..Maps::default() }
}

fn bumped() -> Maps {
    Maps { bump: Some(Bump { layer: picture(), height: 0.1 }), ..Maps::default() }
}

fn square() -> ObjectShape {
    let corner = Vec3::new(-0.5, -0.5, 0.0);
    ObjectShape::Primitive(Primitive::Quad(Quad::new(corner, Vec3::X, Vec3::Y).unwrap()))
}

fn ball() -> ObjectShape {
    ObjectShape::Primitive(Primitive::Sphere(
        Sphere::new(3.0 * Vec3::X, 1.0, Facing::Outward).unwrap(),
    ))
}

/// A triangle around the origin with this normal at each corner.
fn triangle(normal: Vec3) -> ObjectShape {
    let corners = vec![Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::Y];
    let mesh = Mesh::new(corners, vec![[0, 1, 2]]).unwrap();
    ObjectShape::Mesh(mesh.with_normals(vec![normal; 3]).unwrap())
}

/// The shapes, all of one grey material with these maps, under a point light.
fn scene(shapes: impl IntoIterator<Item = ObjectShape>, maps: Maps) -> Scene {
    let mut builder = builder();
    let grey = SurfaceModel::Lambert(Lambert::new(Rgb::splat(0.5)).unwrap());
    let material = builder.add_material(Material { maps: Some(Box::new(maps)), ..grey.into() });
    for shape in shapes {
        let object = Object { shape, sides: Sides::Both, material, emission: Rgb::BLACK };
        builder.add_object(object).unwrap();
    }
    builder.add_point_light(4.0 * Vec3::Z, Rgb::WHITE).unwrap();
    builder.build().unwrap()
}

fn details(scene: &Scene) -> Vec<Detail> {
    Detail::ALL.into_iter().filter(|detail| scene.has(*detail)).collect()
}

/// Reflectance and shading normal at x from the middle.
fn shown(scene: &Scene, x: f32) -> (f32, Vec3) {
    let point = scene.intersect(&Ray::new(Vec3::new(x, 0.1, 1.0), -Vec3::Z)).unwrap();
    let SurfaceModel::Lambert(model) = point.model else { panic!() };
    (model.reflectance().g, point.shading_normal)
}

#[test]
fn a_scene_has_the_details_that_its_surfaces_show() {
    assert_eq!(details(&scene([square()], Maps::default())), []);
    assert_eq!(details(&scene([square()], coloured())), [Detail::Pictures]);
    assert_eq!(details(&scene([square()], bumped())), [Detail::Bumps]);
    // Pictures do not lie on balls.
    assert_eq!(details(&scene([ball()], coloured())), []);
    assert_eq!(details(&scene([ball()], bumped())), []);
    // A normal of any length that is the triangle's bends nothing.
    assert_eq!(details(&scene([triangle(2.0 * Vec3::Z)], Maps::default())), []);
    let bent = triangle(Vec3::new(0.3, 0.0, 1.0));
    assert_eq!(details(&scene([bent], Maps::default())), [Detail::SmoothNormals]);
}

#[test]
fn without_a_detail_the_rest_is_there() {
    let pictured = scene([square()], Maps { ..coloured() });
    let plain = pictured.without(Detail::Pictures).unwrap();
    assert!(shown(&pictured, -0.25).0 < 0.25 && shown(&pictured, 0.25).0 > 0.55);
    assert!([-0.25, 0.25].iter().all(|&x| (shown(&plain, x).0 - 0.4).abs() < 1e-6));

    let relief = scene([square()], Maps { bump: bumped().bump, ..coloured() });
    let flat = relief.without(Detail::Bumps).unwrap();
    assert!(shown(&relief, 0.05).1.z < 0.999 && shown(&flat, 0.05).1 == Vec3::Z);
    assert_eq!(shown(&relief, 0.05).0, shown(&flat, 0.05).0);

    let bent = scene([triangle(Vec3::new(0.3, 0.0, 1.0))], Maps::default());
    let straight = bent.without(Detail::SmoothNormals).unwrap();
    assert!(shown(&bent, 0.0).1.x > 0.2 && shown(&straight, 0.0).1 == Vec3::Z);
    for (scene, detail) in
        [(plain, Detail::Pictures), (flat, Detail::Bumps), (straight, Detail::SmoothNormals)]
    {
        assert!(!scene.has(detail), "{detail:?}");
        assert_eq!((scene.lights().len(), scene.primitive_count()), (1, 1));
    }
}

/// Nothing shows there but the base, which is not the mean.
#[test]
fn a_shape_without_coordinates_keeps_the_material_that_it_shares() {
    let shared = scene([square(), ball()], coloured()).without(Detail::Pictures).unwrap();
    assert_eq!(shown(&shared, 3.0).0, 0.5);
    assert!(shared.has(Detail::Pictures));
}
