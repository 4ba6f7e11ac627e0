use super::*;
use crate::import::imported_object::ObjectMaterial;
use crate::import::model_part::ModelSide;
use traylib_geometry::{Disk, Facing, Mesh, Primitive, Quad, Sides, Sphere};
use traylib_math::Rgb;
use traylib_scene::ObjectShape;

fn item(primitive: Primitive, emission: f32) -> ImportedObject {
    let (sides, material) = (Sides::Front, ObjectMaterial::Own(0));
    let shape = ObjectShape::Primitive(primitive);
    ImportedObject {
        shape,
        sides,
        material,
        emission: Rgb::splat(emission),
        side: ModelSide::Whole,
    }
}

fn sphere(facing: Facing) -> ImportedObject {
    item(Primitive::Sphere(Sphere::new(Vec3::new(10.0, 0.0, 0.0), 2.0, facing).unwrap()), 0.0)
}

fn disk(centre: Vec3, normal: Vec3) -> ImportedObject {
    item(Primitive::Disk(Disk::new(centre, normal, 0.1).unwrap()), 1.0)
}

fn framed(items: &[ImportedObject]) -> ModelCamera {
    camera(items, &[], &bounds(items), Vec3::Z, 4.0 / 3.0)
}

#[test]
fn what_is_all_around_is_seen_from_inside() {
    let lights = [point(Vec3::new(10.0, 1.0, 0.0))];
    let items = [sphere(Facing::Inward)];
    let camera = camera(&items, &lights, &bounds(&items), Vec3::Z, 4.0 / 3.0);
    let distance = camera.position.distance(Vec3::new(10.0, 0.0, 0.2));
    // Nine tenths of the way from a little above the middle to the wall.
    assert!((distance - 0.9 * (4.0_f32 - 0.04).sqrt()).abs() < 1e-3, "{distance}");
    assert_eq!((camera.fov.horizontal(1.0), camera.position.z), (FOV_INSIDE, camera.target.z));
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
    let sane = ImportedObject { shape: mesh, ..sphere(Facing::Outward) };
    assert_eq!(bounds(&[sane]), Aabb { min: Vec3::ZERO, max: Vec3::ONE });
    assert!(bounds(&[]).is_empty());
}

#[test]
fn up_is_where_lamps_are_and_shine_down_from() {
    let room = sphere(Facing::Inward);
    let centre = Vec3::new(10.0, 0.0, 0.0);
    let lamp_up = |side: Vec3| {
        let items = [disk(centre + side * 1.9, -side), sphere(Facing::Inward)];
        up(&items, &bounds(&items))
    };
    assert_eq!([lamp_up(Vec3::Y), lamp_up(Vec3::Z)], [Vec3::Y, Vec3::Z]);
    assert_eq!(up(&[room], &Aabb { min: -Vec3::ONE, max: Vec3::ONE }), Vec3::Z);
}

/// A box from -1 to 1, its faces outward or inward.
fn cube(inward: bool, sides: Sides) -> ImportedObject {
    let corner = |index: u32| {
        let at = |bit: u32| if index >> bit & 1 == 0 { -1.0 } else { 1.0 };
        Vec3::new(at(0), at(1), at(2))
    };
    let faces =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let halves = |[a, b, c, d]: [u32; 4]| [[a, b, c], [a, c, d]];
    let turned = |[a, b, c]: [u32; 3]| if inward { [a, c, b] } else { [a, b, c] };
    let triangles = faces.into_iter().flat_map(halves).map(turned).collect();
    let mesh = Mesh::new((0..8).map(corner).collect(), triangles).unwrap();
    ImportedObject { shape: ObjectShape::Mesh(mesh), sides, ..sphere(Facing::Outward) }
}

fn point(position: Vec3) -> PointLight {
    PointLight { position, intensity: Rgb::WHITE, cone: None }
}

/// Tells whether these are seen from inside, by a point light there.
fn is_room(items: &[ImportedObject], light: Option<Vec3>) -> bool {
    let lights: Vec<PointLight> = light.map(point).into_iter().collect();
    let bounds = bounds(items);
    let camera = camera(items, &lights, &bounds, Vec3::Z, 4.0 / 3.0);
    let is_inside = bounds.contains(camera.position);
    assert_eq!(camera.fov.horizontal(1.0), if is_inside { FOV_INSIDE } else { FOV_OUTSIDE });
    is_inside
}

#[test]
fn what_shows_its_backs_to_the_middle_is_an_object() {
    let (within, beside) = (Some(Vec3::new(0.1, 0.2, 0.3)), Some(Vec3::new(3.0, 2.0, 9.0)));
    for sides in [Sides::Front, Sides::Both] {
        assert!(is_room(&[cube(true, sides)], within));
        assert!(is_room(&[cube(true, sides)], beside));
        assert!(!is_room(&[cube(true, sides)], None));
        assert!(!is_room(&[cube(false, sides)], beside));
    }
    // Walls that reflect on their backs too, around a lamp, can have been meant for a room.
    assert!(is_room(&[cube(false, Sides::Both)], within));
    assert!(!is_room(&[cube(false, Sides::Front)], within));
}

/// Both sides of a lamp are one surface, whose front is outside.
#[test]
fn a_lamp_that_shines_to_both_sides_is_no_room() {
    let one_sided =
        |side, inward| ImportedObject { side, emission: Rgb::WHITE, ..cube(inward, Sides::Front) };
    assert!(!is_room(
        &[one_sided(ModelSide::Front, false), one_sided(ModelSide::Back, true)],
        None
    ));
    assert!(is_room(&[one_sided(ModelSide::Whole, true)], None));
}

#[test]
fn a_corridor_with_open_ends_is_seen_from_inside() {
    let wall = |corner: [f32; 3], edge: [f32; 3]| {
        let [corner, edge] = [corner, edge].map(Vec3::from);
        let quad = Quad::new(corner, edge, Vec3::new(3.0, 0.0, 0.0)).unwrap();
        item(Primitive::Quad(quad), 0.0)
    };
    // Of inward fronts along x, 2 m wide and high.
    let corridor = [
        wall([0.0, 0.0, 0.0], [0.0, -2.0, 0.0]),
        wall([0.0, -2.0, 0.0], [0.0, 0.0, 2.0]),
        wall([0.0, -2.0, 2.0], [0.0, 2.0, 0.0]),
        wall([0.0, 0.0, 2.0], [0.0, 0.0, -2.0]),
    ];
    assert!(is_room(&corridor, Some(Vec3::new(0.5, -1.0, 1.9))));
    // The camera stands in an end.
    let lights = [point(Vec3::new(0.5, -1.0, 1.9))];
    let camera = camera(&corridor, &lights, &bounds(&corridor), Vec3::Z, 1.0);
    let off = (camera.position - Vec3::new(1.5, -1.0, 1.1)).abs();
    assert!((off.x - 1.35).abs() < 1e-4 && off.y < 1e-4 && off.z < 1e-4, "{camera:?}");
}
