use super::*;
use crate::import::model::Half;
use crate::import::thing::ThingMaterial;
use traylib_geometry::{Disk, Facing, Mesh, Sides, Sphere};
use traylib_math::Rgb;
use traylib_scene::ObjectShape;

fn thing(primitive: Primitive, emission: f32) -> Thing {
    let (sides, material) = (Sides::Front, ThingMaterial::Own(0));
    let shape = ObjectShape::Primitive(primitive);
    Thing { shape, sides, material, emission: Rgb::splat(emission), half: Half::Whole }
}

fn sphere(facing: Facing) -> Thing {
    thing(Primitive::Sphere(Sphere::new(Vec3::new(10.0, 0.0, 0.0), 2.0, facing).unwrap()), 0.0)
}

fn disk(centre: Vec3, normal: Vec3) -> Thing {
    thing(Primitive::Disk(Disk::new(centre, normal, 0.1).unwrap()), 1.0)
}

fn framed(things: &[Thing]) -> ModelCamera {
    camera(things, &bounds(things), Vec3::Z, 4.0 / 3.0)
}

#[test]
fn what_is_all_around_is_seen_from_inside() {
    let camera = framed(&[sphere(Facing::Inward)]);
    let distance = camera.position.distance(Vec3::new(10.0, 0.0, 0.2));
    // Nine tenths of the way from a little above the middle to the wall.
    assert!((distance - 0.9 * (4.0_f32 - 0.04).sqrt()).abs() < 1e-3, "{distance}");
    assert_eq!((camera.fov_degrees, camera.position.z), (FOV_INSIDE, camera.target.z));
}

#[test]
fn what_is_not_is_seen_as_a_whole_from_outside() {
    let camera = framed(&[sphere(Facing::Outward)]);
    let off = camera.position - Vec3::new(10.0, 0.0, 0.0);
    assert!((off.z / off.length() - 0.5).abs() < 1e-3, "30° above: {off}");
    // The sphere is inside of its box, which fits the narrower way of the view.
    let narrow = ((0.5 * FOV_OUTSIDE).to_radians().tan() * 0.75).atan();
    assert!(2.0 / off.length() < narrow.sin() && off.length() < 20.0, "{off}");
}

#[test]
fn a_few_points_far_away_do_not_count() {
    let mut positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
    positions.extend((0..2000).map(|i| Vec3::splat(i as f32 / 2000.0)));
    positions.push(Vec3::splat(1e11));
    let mesh = ObjectShape::Mesh(Mesh::new(positions, vec![[0, 1, 2]]).unwrap());
    let sane = Thing { shape: mesh, ..sphere(Facing::Outward) };
    assert_eq!(bounds(&[sane]), Aabb { min: Vec3::ZERO, max: Vec3::ONE });
    assert!(bounds(&[]).is_empty());
}

#[test]
fn up_is_where_lamps_are_and_shine_down_from() {
    let room = sphere(Facing::Inward);
    let centre = Vec3::new(10.0, 0.0, 0.0);
    let lamp_up = |side: Vec3| {
        let things = [disk(centre + side * 1.9, -side), sphere(Facing::Inward)];
        up(&things, &bounds(&things))
    };
    assert_eq!([lamp_up(Vec3::Y), lamp_up(Vec3::Z)], [Vec3::Y, Vec3::Z]);
    assert_eq!(up(&[room], &Aabb { min: -Vec3::ONE, max: Vec3::ONE }), Vec3::Z);
}
