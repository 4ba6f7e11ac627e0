use super::*;
use traylib_geometry::{Facing, Sphere};

fn ball() -> ObjectShape {
    ObjectShape::Primitive(Primitive::Sphere(
        Sphere::new(Vec3::ZERO, 1.0, Facing::Outward).unwrap(),
    ))
}

/// Returns a mesh of so many triangles in one place.
fn mesh(count: usize) -> ObjectShape {
    let corners = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
    ObjectShape::Mesh(Mesh::new(corners, vec![[0, 1, 2]; count]).unwrap())
}

/// Parts of any size, one after the other, with their numbers on either side of where the list
/// of stretches grows coarser, once and twice.
#[test]
fn every_number_belongs_to_its_part() {
    let counts = [1, 1, 7, 1, 70_001, 1, 1, 1, 64_000, 3, 1, 1, 150_000, 1, 1];
    let (mut surfaces, mut expected) = (Surfaces::default(), Vec::new());
    for (material, count) in (0..).zip(counts) {
        let shape = if count == 1 { ball() } else { mesh(count) };
        surfaces.add(shape, Sides::Both, material, None);
        expected.extend((0..count).map(|index| (material as usize, index)));
        if expected.len() < 100 || material > 10 {
            let all = surfaces.all().map(|surface| (surface.material(), surface.index));
            assert!(all.eq(expected.iter().copied()), "after part {material}");
        }
    }
    assert_eq!(surfaces.count(), expected.len());
    assert!(surfaces.part_of.len() <= MOST_STRETCHES);
}
