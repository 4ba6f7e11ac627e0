//! All questions have one answer, and it is right: trees against lists, against one
//! another, and against plain formulas in double precision.
//!
//! Seeds are fixed. The domain is that of the crate's page: shapes from up to 10¹³ times
//! their size away, some of them 10⁵ times as long as thick, and placements that stretch
//! one direction up to 10⁶ times as much as another.

mod judge;

use super::brute_force;
use crate::bvh::*;
use crate::testing::Random;
use crate::testing::shape::{Line, scaled};
use crate::tree::Kernel;
use crate::{Cone, Facing, Primitive};
use judge::{Verdict, verdict};
use std::sync::Arc;
use traylib_math::glam::{Affine3A, DAffine3, DVec3, Mat3A};

const SHAPES: usize = 30;

/// The three questions, in ones and in many, and with ends that just leave out the first
/// hit or just do not.
fn consistent_hits<C: LeafKind>(bvh: &Bvh<C>, ray: &Ray) -> Vec<Hit> {
    let all = bvh.all_hits(ray);
    let first = all.first().copied();
    assert!(all.is_sorted_by(|a, b| (a.t, a.primitive) < (b.t, b.primitive)), "{ray:?} {all:?}");
    assert_eq!(bvh.nearest(ray), first, "{ray:?} {all:?}");
    assert_eq!(bvh.any_hit(ray), first.is_some(), "{ray:?}");
    // A packet of the ray with itself.
    let rays = [*ray; 9];
    let (mut hits, mut any) = ([None; 9], [false; 9]);
    bvh.nearest_each(&rays, &mut hits);
    bvh.any_hit_each(&rays, &mut any);
    assert_eq!((hits, any), ([first; 9], [first.is_some(); 9]), "{ray:?}");
    if let Some(hit) = first {
        assert!(!bvh.any_hit(&Ray { t_max: hit.t, ..*ray }), "{ray:?} {hit:?}");
        let with = Ray { t_max: hit.t.next_up(), ..*ray };
        assert_eq!(bvh.nearest(&with), first, "{ray:?}");
        assert!(bvh.any_hit(&with));
    }
    all
}

/// The numbers of decided cases, either way.
#[derive(Debug, Default)]
struct Decided {
    hits: u32,
    misses: u32,
}

impl Decided {
    /// Leaf whether a list has a hit, and where, against what is certain.
    fn check(&mut self, found: Option<&Hit>, verdict: Verdict, ray: &Ray) {
        match (verdict, found) {
            (Verdict::Unsure, _) => {}
            (Verdict::Miss, None) => self.misses += 1,
            (Verdict::Hit { t, within }, Some(hit)) => {
                assert!((f64::from(hit.t) - t).abs() <= within, "{ray:?} {hit:?} {t} {within}");
                self.hits += 1;
            }
            (Verdict::Miss, Some(hit)) => panic!("no such hit: {ray:?} {hit:?}"),
            (Verdict::Hit { t, .. }, None) => {
                // Behind its end it does not count.
                assert!(t >= f64::from(ray.t_max) * 0.999, "lost: {ray:?} {t}");
            }
        }
    }
}

/// A ray from afar at a shape, or along an axis through a point of it; some with ends.
fn ray_at(shape: &Primitive, distance: f32, random: &mut Random) -> Ray {
    let target = shape.sample_area(random.square()).position;
    let origin = distance * random.direction();
    let axis = [Vec3::X, Vec3::Y, Vec3::Z][(3.0 * random.number()) as usize];
    let straight = Ray::new(origin, target - origin);
    match (6.0 * random.number()) as u32 {
        0 => Ray::new(target - distance * axis, axis),
        1 => Ray::new(target + distance * axis, -2.0_f32.powi(-40) * axis),
        2 => Ray { t_max: 0.999 + 2e-3 * random.number(), ..straight },
        3 => Ray { direction: straight.direction.normalize(), ..straight },
        _ => straight,
    }
}

/// Every fourth a sliver.
fn mixed(size: f32, random: &mut Random) -> Vec<Primitive> {
    let one = |i: usize| {
        let place = 3.0 * random.point();
        let shape =
            if i.is_multiple_of(4) { random.sliver(place) } else { random.primitive(place) };
        scaled(&shape, size)
    };
    (0..SHAPES).map(one).collect()
}

/// Every instruction set in turn.
fn kernel(number: usize) -> Kernel {
    let all = Kernel::available();
    all[number % all.len()]
}

#[test]
fn mixed_trees_agree_with_lists_and_with_double_precision() {
    let mut random = Random::new(77);
    for distance in [1.0_f32, 1e2, 1e4, 1e7, 1e10, 1e13] {
        let mut decided = Decided::default();
        for number in 0..if cfg!(miri) { 1 } else { 12 } {
            let size = [1.0, 2.0_f32.powi(-20), 2.0_f32.powi(40)][number % 3];
            let mut bvh = Bvh::of_shapes(mixed(size, &mut random)).unwrap();
            bvh.tree.kernel = kernel(number);
            for _ in 0..if cfg!(miri) { 3 } else { 200 } {
                let shape = bvh.shapes()[(random.number() * SHAPES as f32) as usize];
                let ray = ray_at(&shape, size * distance, &mut random);
                let all = consistent_hits(&bvh, &ray);
                assert_eq!(brute_force(bvh.shapes(), &ray), all.first().copied(), "{ray:?}");
                let line = Line::of(&ray);
                for (i, shape) in bvh.shapes().iter().enumerate() {
                    let found = all.iter().find(|hit| hit.primitive == i as u32);
                    decided.check(found, verdict(shape, &line, 0.0), &ray);
                }
            }
        }
        assert!(cfg!(miri) || decided.hits > 200 && decided.misses > 10_000, "{decided:?}");
    }
}

/// Three axes of which one is nearly in the plane of the others.
fn squeezed(thin: f32, random: &mut Random) -> Affine3A {
    let (a, b) = (random.point(), random.point());
    let c = random.number() * a + random.number() * b + thin * random.point();
    let axes = Mat3A::from_cols(a.into(), b.into(), c.into());
    Affine3A { matrix3: axes, translation: (3.0 * random.point()).into() }
}

/// Copies are so squeezed that rounding moves rays by as much as shapes are large: hits may be
/// others than those of copies, and still all questions agree on them.
#[test]
fn squeezed_instances_have_one_answer() {
    let mut random = Random::new(78);
    let mut hits = 0;
    for number in 0..if cfg!(miri) { 1 } else { 60 } {
        let (mut bvh, _, _) = instances(1e-6, &mut random);
        bvh.tree.kernel = kernel(number);
        for _ in 0..if cfg!(miri) { 3 } else { 1000 } {
            let origin = 5.0 * random.point();
            let ray = Ray::new(origin, 3.0 * random.point() - origin);
            hits += consistent_hits(&bvh, &ray).len();
        }
    }
    assert!(cfg!(miri) || hits > 1000, "{hits}");
}

#[test]
fn instances_agree_with_copies_in_double_precision() {
    let mut random = Random::new(78);
    for (thin, least) in [(1.0_f32, 300), (1e-1, 300), (1e-2, 300), (1e-3, 20)] {
        let mut decided = Decided::default();
        for number in 0..if cfg!(miri) { 1 } else { 30 } {
            let (mut bvh, shapes, placements) = instances(thin, &mut random);
            bvh.tree.kernel = kernel(number);
            for i in 0..if cfg!(miri) { 3 } else { 200 } {
                let origin = if i % 4 == 0 { 1e3 } else { 5.0 } * random.point();
                let ray = Ray::new(origin, 3.0 * random.point() - origin);
                let all = consistent_hits(&bvh, &ray);
                let mut number = 0;
                for placement in &placements {
                    let (line, noise) = moved(&ray, placement);
                    for shape in &shapes {
                        let found = all.iter().find(|hit| hit.primitive == number);
                        decided.check(found, verdict(shape, &line, noise), &ray);
                        number += 1;
                    }
                }
            }
        }
        let enough = decided.hits > least && decided.misses > 1000;
        assert!(cfg!(miri) || enough, "{thin}: {decided:?}");
    }
}

type Copies = Instances<Shapes<Vec<Primitive>>>;

/// A few shapes, in many places.
fn instances(thin: f32, random: &mut Random) -> (Bvh<Copies>, Vec<Primitive>, Vec<Affine3A>) {
    let shape = |random: &mut Random| {
        let place = random.point();
        random.primitive(place)
    };
    let shapes: Vec<Primitive> = (0..6).map(|_| shape(random)).collect();
    let tree = Arc::new(Bvh::of_shapes(shapes.clone()).unwrap());
    let placements: Vec<Affine3A> = (0..10).map(|_| squeezed(thin, random)).collect();
    let place = |placement: &Affine3A| Instance::new(tree.clone(), *placement).unwrap();
    let bvh = Bvh::of_instances(placements.iter().map(place).collect()).unwrap();
    (bvh, shapes, placements)
}

/// The line of a ray within an instance, and how far rounding may move it there: five times
/// half a unit in the last place of what is added up, of which four for products and sums.
fn moved(ray: &Ray, placement: &Affine3A) -> (Line, f64) {
    let placement = DAffine3::from_cols_array(&placement.to_cols_array().map(f64::from));
    let inverse = placement.inverse();
    let Line { origin, direction } = Line::of(ray);
    let added = |v: DVec3| {
        let [x, y, z] = [inverse.x_axis, inverse.y_axis, inverse.z_axis].map(DVec3::abs);
        x * v.x.abs() + y * v.y.abs() + z * v.z.abs()
    };
    // Rays are aimed at where they are met: no t is far above one.
    let reach = added(origin) + added(placement.translation) + 2.0 * added(direction);
    let line = Line {
        origin: inverse.transform_point3(origin),
        direction: inverse.transform_vector3(direction),
    };
    (line, 2.5 * f64::from(f32::EPSILON) * reach.length())
}

/// A plate that looks at the camera from 10¹³ of its thicknesses away hides nothing
/// beside it.
#[test]
fn a_flat_cone_from_afar_is_met_where_it_is() {
    let ends = [Vec3::new(1.5, 2.0, 3.0), Vec3::new(1.5, 2.0001, 3.0001)];
    let cone = Cone::new(ends, [0.25, 0.0], Facing::Outward).unwrap();
    for distance in [1e3_f32, 1e6, 1e9, 1e13] {
        let met = |x: f32, z: f32| {
            let ray = Ray::new(Vec3::new(x, -distance, z), Vec3::Y);
            cone.intersect(&ray, crate::Sides::Both).is_some()
        };
        for i in 0..200_u8 {
            // Never on the rim.
            let x = 1.0025 + 0.005 * f32::from(i);
            assert_eq!(met(x, 3.0), (x - 1.5).abs() < 0.25, "{distance:e} {x}");
        }
    }
}
