use super::*;
use crate::testing::{Random, cube, icosphere, triangles};
use crate::{
    Facing, Primitive, Quad, Shape, ShapeHit, SidedPrimitive, Sides, Sphere, Triangle, Vec3,
};

/// Returns the hit that the tree must find, by asking every shape: of ties, the first in the list.
fn brute_force<S: Shape>(shapes: &[S], ray: &Ray) -> Option<Hit> {
    let hits = shapes.iter().enumerate().filter_map(|(i, shape)| {
        let ShapeHit { t, u, v } = shape.intersect(ray)?;
        Some(Hit { t, primitive: i as u32, u, v })
    });
    hits.min_by(|a, b| a.t.total_cmp(&b.t))
}

fn check<S: Shape>(bvh: &Bvh<Shapes<Vec<S>>>, ray: &Ray) -> bool {
    let expected = brute_force(bvh.shapes(), ray);
    assert_eq!(bvh.nearest(ray), expected, "{ray:?}");
    assert_eq!(bvh.any_hit(ray), expected.is_some(), "{ray:?}");
    expected.is_some()
}

/// Many small shapes, some slivers, some far away, every third with its front alone.
fn crowd(count: usize, random: &mut Random) -> Vec<SidedPrimitive> {
    let size = 10.0;
    let one = |i: usize| {
        let place = size * random.point();
        let primitive =
            if i.is_multiple_of(4) { random.sliver(place) } else { random.primitive(place) };
        SidedPrimitive { primitive, sides: if i % 3 == 2 { Sides::Front } else { Sides::Both } }
    };
    (0..count).map(one).collect()
}

/// Every other ray is aimed near a shape, where there is one.
fn random_ray(shapes: &[SidedPrimitive], random: &mut Random) -> Ray {
    let origin = 12.0 * random.point();
    let pick = (2.0 * random.number() * shapes.len() as f32) as usize;
    let target = match shapes.get(pick) {
        Some(shape) => shape.primitive.sample_area(random.square()).position,
        None => 12.0 * random.point(),
    };
    let ray = Ray::new(origin, random.magnitude(100.0) * (target - origin));
    match (4.0 * random.number()) as u32 {
        0 => Ray::segment(origin, target + random.point()),
        1 => {
            let along = [Vec3::X, Vec3::NEG_Y, -Vec3::Z][(3.0 * random.number()) as usize];
            Ray::new(target - 5.0 * along, along)
        }
        _ => ray,
    }
}

#[test]
fn the_tree_agrees_with_asking_every_shape() {
    let mut random = Random::new(1);
    for count in (0..10).chain([14, 33, 100, 1000]) {
        let bvh = Bvh::of_shapes(crowd(count, &mut random)).unwrap();
        let rays = (0..5000).map(|_| random_ray(bvh.shapes(), &mut random));
        let hits = rays.filter(|ray| check(&bvh, ray)).count();
        assert!(hits > 1000 || count == 0, "{count} shapes: {hits}");
    }
}

#[test]
fn no_shapes_no_hits() {
    let bvh = Bvh::of_shapes(Vec::<Triangle>::new()).unwrap();
    let ray = Ray::new(Vec3::ZERO, Vec3::X);
    assert_eq!((bvh.nearest(&ray), bvh.any_hit(&ray)), (None, false));
    assert!(bvh.bounds().is_empty());
}

/// A thousand times the same triangle, flat in a plane.
#[test]
fn duplicates_and_flat_boxes_are_found() {
    let mut random = Random::new(2);
    let triangle = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Y).unwrap();
    let bvh = Bvh::of_shapes(vec![triangle; 1000]).unwrap();
    assert!(bvh.tree.depth <= 10, "{}", bvh.tree.depth);
    for _ in 0..1000 {
        let target = Vec3::new(random.number(), random.number(), 0.0);
        let origin = 3.0 * random.point();
        check(&bvh, &Ray::new(origin, target - origin));
    }
    assert!(check(&bvh, &Ray::new(Vec3::new(0.25, 0.25, 1.0), Vec3::new(-0.0, 0.0, -1.0))));
}

/// QuantisedExtents that grow like powers of two defeat any heuristic; halving bounds the
/// depth.
#[test]
fn the_depth_is_bounded() {
    let ball = |i: i32| {
        let size = 1.5_f32.powi(i);
        Sphere::new(Vec3::splat(size), 0.1 * size, Facing::Outward).unwrap()
    };
    let bvh = Bvh::of_shapes((-40..40).map(ball).collect()).unwrap();
    assert!(bvh.tree.depth <= crate::tree::build::MAX_DEPTH);
    assert!(check(&bvh, &Ray::new(Vec3::ZERO, Vec3::ONE)));
    let many = crowd(5000, &mut Random::new(3));
    assert!(Bvh::of_shapes(many).unwrap().tree.depth < 16);
}

#[test]
fn rays_that_are_none_miss_at_once() {
    let bvh = Bvh::of_shapes(triangles(&cube())).unwrap();
    let sound = Ray::new(Vec3::ZERO, Vec3::X);
    assert!(bvh.any_hit(&sound));
    for bad in [0.0, -0.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let ray = Ray { direction: Vec3::splat(bad), ..sound };
        assert_eq!((bvh.nearest(&ray), bvh.any_hit(&ray)), (None, false), "{bad}");
        let ray = Ray { t_max: bad.min(0.0), ..sound };
        assert_eq!((bvh.nearest(&ray), bvh.any_hit(&ray)), (None, false), "{bad}");
    }
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let ray = Ray { origin: Vec3::new(0.0, bad, 0.0), ..sound };
        assert_eq!((bvh.nearest(&ray), bvh.any_hit(&ray)), (None, false), "{bad}");
    }
}

/// Rays along the axes with zeros of either sign, in the faces of boxes and off
/// them: what is not in the plane of a triangle is hit.
#[test]
fn axis_aligned_rays_see_the_cube() {
    let bvh = Bvh::of_shapes(triangles(&cube())).unwrap();
    let steps = [-1.0, -0.5, 0.0, 0.5, 1.0];
    for zero in [0.0, -0.0] {
        for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0), (2, 1.0), (2, -1.0)] {
            for (u, v) in steps.into_iter().flat_map(|u| steps.map(|v| (u, v))) {
                let mut direction = Vec3::splat(zero);
                direction[axis] = sign;
                let mut origin = Vec3::ZERO;
                origin[axis] = -2.0 * sign;
                origin[(axis + 1) % 3] = u;
                origin[(axis + 2) % 3] = v;
                let hit = bvh.nearest(&Ray::new(origin, direction));
                assert_eq!(hit.map(|h| h.t), Some(1.0), "{origin} {direction}");
            }
        }
    }
}

#[test]
fn a_front_that_is_seen_through_hides_nothing() {
    let wall = Quad::new(Vec3::ZERO, Vec3::X, Vec3::Y).unwrap();
    let behind = Quad::new(Vec3::NEG_Z, Vec3::X, Vec3::Y).unwrap();
    let sided = |quad, sides| SidedPrimitive { primitive: Primitive::Quad(quad), sides };
    let bvh = Bvh::of_shapes(vec![sided(wall, Sides::Both), sided(behind, Sides::Front)]).unwrap();
    let ray = Ray::new(Vec3::new(0.5, 0.5, -3.0), Vec3::Z);
    assert_eq!(bvh.nearest(&ray).map(|h| (h.t, h.primitive)), Some((3.0, 0)));
}

#[test]
fn shapes_without_sound_bounds_are_refused() {
    struct Bounded(Aabb);
    impl Shape for Bounded {
        fn bounds(&self) -> Aabb {
            self.0
        }
        fn intersect(&self, _: &Ray) -> Option<ShapeHit> {
            None
        }
    }
    let sound = Aabb::around([Vec3::ZERO]);
    for bad in [Vec3::NAN, Vec3::INFINITY] {
        for bounds in [Aabb { min: bad, ..sound }, Aabb { max: bad, ..sound }, Aabb::EMPTY] {
            let refused = Bvh::of_shapes(vec![Bounded(sound), Bounded(bounds)]);
            assert_eq!(refused.err(), Some(Error::UnboundedShape { index: 1 }));
        }
    }
}

#[test]
fn guests_may_bring_their_own_shapes() {
    let shapes: Vec<Box<dyn Shape>> = vec![
        Box::new(Sphere::new(Vec3::ZERO, 1.0, Facing::Outward).unwrap()),
        Box::new(Triangle::new(Vec3::Z * 3.0, Vec3::new(1.0, 0.0, 3.0), Vec3::ONE).unwrap()),
    ];
    let bvh = Bvh::of_shapes(shapes).unwrap();
    assert_eq!(bvh.nearest(&Ray::new(-5.0 * Vec3::Z, Vec3::Z)).map(|h| h.t), Some(4.0));
}

/// Boxes, order and all: scaled scenes give the same hits.
#[test]
fn scaling_by_powers_of_two_is_exact() {
    let ball = icosphere(2);
    let scaled = |scale: f32| {
        let grow = |t: &Triangle| {
            let [a, b, c] = t.corners().map(|p| p * scale);
            Triangle::new(a, b, c).unwrap()
        };
        Bvh::of_shapes(triangles(&ball).iter().map(grow).collect::<Vec<_>>()).unwrap()
    };
    let (one, large, small) = (scaled(1.0), scaled(1024.0), scaled(2.0_f32.powi(-14)));
    let mut random = Random::new(6);
    for _ in 0..2000 {
        let ray = Ray::new(1.2 * random.point(), random.direction());
        let hit = one.nearest(&ray);
        for (bvh, scale) in [(&large, 1024.0), (&small, 2.0_f32.powi(-14))] {
            let far = bvh.nearest(&Ray { origin: ray.origin * scale, ..ray });
            assert_eq!(far, hit.map(|h| Hit { t: h.t * scale, ..h }));
        }
    }
}

mod agreement;
mod instances;
mod kernels;
mod meshes;
