//! Blocks meet what the shapes meet, to the bit, with every instruction set.

use super::{DiskBlock, Line, QuadBlock, ShapeBlock, SphereBlock};
use crate::ShapeHit;
use crate::shape::ShapeKind;
use crate::testing::Random;
use crate::tree::node::LEAF;
#[cfg(all(target_arch = "x86_64", not(miri)))]
use crate::tree::simd::{Avx2Simd, Sse41Simd};
use crate::tree::simd::{Portable, Simd};
use crate::{Disk, Facing, Primitive, Quad, Ray, Shape, SidedPrimitive, Sides, Sphere, Vec3};
use std::array::from_fn;
use std::ops::ControlFlow;

/// A shape of any size, some far from the origin; every other met from its front alone.
fn shape(kind: u32, random: &mut Random) -> SidedPrimitive {
    let sides = if random.number() < 0.5 { Sides::Both } else { Sides::Front };
    let size = random.magnitude(1e12) * 1e-6;
    let place = size * random.magnitude(1e6) * random.point();
    let (along, thin) = (size * random.point(), random.magnitude(1e-5));
    let radius = size * thin;
    let facing = if random.number() < 0.5 { Facing::Outward } else { Facing::Inward };
    let flat = random.number() < 0.5;
    let primitive = match kind {
        // Some in a coordinate plane, as walls are.
        0 if flat => {
            Quad::new(place, along.x * Vec3::X, along.z * thin * Vec3::Z).map(Primitive::Quad)
        }
        0 => Quad::new(place, along, radius * random.point()).map(Primitive::Quad),
        1 => Sphere::new(place, radius, facing).map(Primitive::Sphere),
        _ if flat => Disk::new(place, Vec3::Y, radius).map(Primitive::Disk),
        _ => Disk::ring(place, along, random.number() * radius, radius).map(Primitive::Disk),
    };
    primitive.map_or_else(|_| shape(kind, random), |primitive| SidedPrimitive { primitive, sides })
}

/// Toward a point of the shape or of its edge; along it; from it; from within; and what no
/// tree asks: numbers that are none, zero and infinite directions.
fn ray(shape: &Primitive, random: &mut Random) -> Ray {
    let corners = [0.0, 1.0, random.number()];
    let mut coordinate = || corners[(3.0 * random.number()) as usize];
    let square = [coordinate(), coordinate()].into();
    let site = shape.sample_area(square);
    let extent = shape.bounds().extent();
    let distance = extent.max_element() * random.magnitude(1e8) * 1e-2;
    let origin = site.position + distance * random.direction();
    let other = shape.sample_area(random.square()).position;
    let speed = random.magnitude(1e12) * 1e-6;
    let t_max = if random.number() < 0.5 { f32::INFINITY } else { 2.0 * random.number() / speed };
    let axis = [Vec3::X, Vec3::NEG_Y, Vec3::Z][(3.0 * random.number()) as usize];
    let straight = Ray { origin, direction: speed * (site.position - origin), t_max };
    let special = [0.0, -0.0, f32::NAN, f32::INFINITY, f32::MAX, -1e-45];
    match (12.0 * random.number()) as u32 {
        0 => Ray { direction: other - site.position, ..straight },
        1 => Ray { origin: site.position, direction: other - site.position, t_max },
        2 => Ray { origin: site.position, direction: random.direction(), t_max },
        3 => Ray { origin: site.position - distance * axis, direction: speed * axis, t_max },
        4 => Ray { origin: shape.bounds().centre(), direction: random.direction(), t_max },
        5 => {
            let place = (3.0 * random.number()) as usize;
            let mut direction = straight.direction;
            direction[place] = special[(6.0 * random.number()) as usize];
            Ray { direction, ..straight }
        }
        6 => {
            let place = (3.0 * random.number()) as usize;
            let mut origin = straight.origin;
            origin[place] = special[(6.0 * random.number()) as usize];
            Ray { origin, ..straight }
        }
        // Across a radius at the rim, or up to rounding.
        7 => {
            let aside = site.normal.cross(random.direction());
            Ray { origin: site.position - aside, direction: speed * aside, t_max }
        }
        _ => straight,
    }
}

type Found = [Option<[u32; 3]>; LEAF];

fn bits(hit: ShapeHit) -> [u32; 3] {
    [hit.t, hit.u, hit.v].map(f32::to_bits)
}

fn found(block: &impl ShapeBlock, simd: impl Simd, ray: &Ray) -> Found {
    let mut found = [None; LEAF];
    let told = block.each_hit(&Line::of(simd, ray), ray.t_max, |number, hit| {
        let before = found[number as usize].replace(bits(hit));
        assert_eq!(before, None);
        ControlFlow::Continue(())
    });
    assert!(told.is_continue());
    found
}

/// With every instruction set of this machine.
fn check(block: &impl ShapeBlock, shapes: &[SidedPrimitive], ray: &Ray) -> Found {
    let expected: Found = from_fn(|lane| {
        let SidedPrimitive { primitive, sides } = shapes.get(lane)?;
        primitive.intersect(ray, *sides).map(bits)
    });
    assert_eq!(found(block, Portable, ray), expected, "{ray:?} {shapes:?}");
    #[cfg(all(target_arch = "x86_64", not(miri)))]
    {
        assert_eq!(found(block, Sse41Simd, ray), expected, "{ray:?} {shapes:?}");
        if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
            // SAFETY: the machine has them.
            #[allow(unsafe_code)]
            let avx2 = unsafe { Avx2Simd::new() };
            assert_eq!(found(block, avx2, ray), expected, "{ray:?} {shapes:?}");
        }
    }
    expected
}

/// At the t of a hit a ray ends before it, and just beyond it does not.
fn check_limits(block: &impl ShapeBlock, shapes: &[SidedPrimitive], ray: &Ray) -> usize {
    let hits = check(block, shapes, ray);
    for [t, ..] in hits.iter().flatten() {
        for t_max in [f32::from_bits(*t), f32::from_bits(t + 1)] {
            check(block, shapes, &Ray { t_max, ..*ray });
        }
    }
    for t_max in [0.0, -1.0, f32::NAN] {
        check(block, shapes, &Ray { t_max, ..*ray });
    }
    hits.iter().flatten().count()
}

fn blocks_agree<B: ShapeBlock>(kind: u32, new: impl Fn([u32; LEAF], &[ShapeKind]) -> B) {
    let mut random = Random::new(u64::from(31 + kind));
    let (mut hits, rounds) = (0, if cfg!(miri) { 5 } else { 4000 });
    for round in 0..rounds {
        let count = 1 + round % LEAF;
        let shapes: Vec<SidedPrimitive> = (0..count).map(|_| shape(kind, &mut random)).collect();
        let items: Vec<ShapeKind> = shapes.iter().map(Shape::kind).collect();
        let numbers = from_fn(|lane| if lane < count { lane as u32 } else { u32::MAX });
        let block = new(numbers, &items);
        for _ in 0..20 {
            let shape = &shapes[(random.number() * count as f32) as usize];
            hits += check_limits(&block, &shapes, &ray(&shape.primitive, &mut random));
        }
    }
    assert!(cfg!(miri) || hits > 2 * rounds, "{hits}");
}

#[test]
fn four_quads_are_met_as_one_is() {
    blocks_agree(0, |numbers, items| QuadBlock::new(numbers, |i| items[i as usize]));
}

#[test]
fn four_spheres_are_met_as_one_is() {
    blocks_agree(1, |numbers, items| SphereBlock::new(numbers, |i| items[i as usize]));
}

#[test]
fn four_disks_are_met_as_one_is() {
    blocks_agree(2, |numbers, items| DiskBlock::new(numbers, |i| items[i as usize]));
}

/// After a query has its answer, no hit is told any more.
#[test]
fn no_hit_is_told_after_the_last() {
    let wall = Quad::new(Vec3::ZERO, Vec3::X, Vec3::Y).unwrap();
    let block = QuadBlock::new([0, 1, 2, u32::MAX], |_| ShapeKind::Quad(wall, Sides::Both));
    let ray = Ray::new(Vec3::new(0.5, 0.5, 1.0), Vec3::NEG_Z);
    let mut told = Vec::new();
    let end = block.each_hit(&Line::of(Portable, &ray), ray.t_max, |number, hit| {
        told.push((number, hit));
        if number == 1 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let hit = ShapeHit { t: 1.0, u: 0.5, v: 0.5 };
    assert_eq!((end, told), (ControlFlow::Break(()), vec![(0, hit), (1, hit)]));
}
