//! Instances are met as copies would be.

use crate::bvh::*;
use crate::testing::{Random, cube, icosphere};
use crate::{Error, Mesh};
use std::sync::Arc;
use traylib_math::glam::{Affine3A, Quat};

/// Turned and moved by numbers that do not round.
fn placements() -> Vec<Affine3A> {
    let turn = Quat::from_xyzw(0.5, 0.5, 0.5, 0.5);
    (0..5_u8)
        .map(|i| {
            let place = Vec3::new(4.0 * f32::from(i), 1.0, -2.0);
            Affine3A::from_scale_rotation_translation(Vec3::new(1.0, 2.0, 0.5), turn, place)
        })
        .collect()
}

/// All copies in one mesh.
fn copies(mesh: &Mesh, placements: &[Affine3A]) -> Mesh {
    let count = mesh.positions().len() as u32;
    let moved = |p: &Affine3A| {
        let p = *p;
        mesh.positions().iter().map(move |&x| p.transform_point3(x)).collect::<Vec<_>>()
    };
    let positions = placements.iter().flat_map(moved).collect();
    let numbered = |i: u32| mesh.triangles().iter().map(move |t| t.map(|c| c + i * count));
    Mesh::new(positions, (0..placements.len() as u32).flat_map(numbered).collect()).unwrap()
}

#[test]
fn instances_are_met_as_copies_are() {
    let mesh = icosphere(if cfg!(miri) { 0 } else { 2 });
    let tree = Arc::new(Bvh::build(&mesh).unwrap());
    let placements = placements();
    let instances = placements.iter().map(|&p| Instance::new(tree.clone(), p).unwrap()).collect();
    let instances = Bvh::of_instances(instances).unwrap();
    let all = Bvh::build(&copies(&mesh, &placements)).unwrap();
    let mut random = Random::new(31);
    let mut hits = 0;
    for _ in 0..if cfg!(miri) { 20 } else { 5000 } {
        let origin = Vec3::new(8.0, 0.0, 0.0) + 10.0 * random.point();
        let target = Vec3::new(16.0 * random.number(), 1.0, -2.0) + random.point();
        let ray = Ray::new(origin, target - origin);
        let (found, expected) = (instances.nearest(&ray), all.nearest(&ray));
        assert_eq!(found.is_some(), expected.is_some());
        assert_eq!(instances.any_hit(&ray), expected.is_some());
        assert_eq!(instances.all_hits(&ray).len(), all.all_hits(&ray).len());
        let Some((found, expected)) = found.zip(expected) else { continue };
        hits += 1;
        assert_eq!(found.primitive, expected.primitive);
        // Moving the ray rounds a few times in the size of its origin.
        assert!((found.t - expected.t).abs() < 1e-4, "{found:?} {expected:?}");
        let count = mesh.triangle_count() as u32;
        let place = ((found.primitive / count) as usize, found.primitive % count);
        assert_eq!(instances.locate(found.primitive), Some(place));
    }
    assert!(hits > 5 || !cfg!(miri) && hits > 1000, "{hits}");
    assert_eq!(instances.locate(5 * mesh.triangle_count() as u32), None);
}

#[test]
fn trees_of_nothing_are_left_out() {
    let nothing = Arc::new(Bvh::build(&Mesh::default()).unwrap());
    let cube = Arc::new(Bvh::build(&cube()).unwrap());
    let at = |tree: &Arc<Bvh>, place: Vec3| {
        Instance::new(tree.clone(), Affine3A::from_translation(place)).unwrap()
    };
    let bvh = Bvh::of_instances(vec![at(&nothing, Vec3::ZERO), at(&cube, Vec3::X)]).unwrap();
    let hit = bvh.nearest(&Ray::new(Vec3::new(-4.0, 0.25, 0.5), Vec3::X)).unwrap();
    assert_eq!((hit.t, bvh.locate(hit.primitive).unwrap().0), (4.0, 1));
    let none = Bvh::of_instances(vec![at(&nothing, Vec3::ZERO)]).unwrap();
    assert!(!none.any_hit(&Ray::new(Vec3::ZERO, Vec3::X)) && none.locate(0).is_none());
}

#[test]
fn placements_that_cannot_be_undone_are_refused() {
    let cube = Arc::new(Bvh::build(&cube()).unwrap());
    for bad in [Vec3::new(1.0, 0.0, 1.0), Vec3::splat(f32::NAN), Vec3::splat(f32::INFINITY)] {
        let refused = Instance::new(cube.clone(), Affine3A::from_scale(bad));
        assert_eq!(refused.err(), Some(Error::NotFinite), "{bad}");
    }
}
