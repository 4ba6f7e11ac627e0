//! All instruction sets give the same bits, one by one and many at a time.

use super::crowd;
use crate::Mesh;
use crate::bvh::*;
use crate::testing::{Random, icosphere};
use crate::tree::Kernel;

/// Builds the tree for each instruction set of this machine, the scalar one first.
fn versions<C: Clone>(bvh: &Bvh<C>) -> Vec<Bvh<C>> {
    let version = |kernel| {
        let mut bvh = bvh.clone();
        bvh.tree.kernel = kernel;
        bvh
    };
    Kernel::available().into_iter().map(version).collect()
}

/// Balls, slivers, triangles without area, some twice, and a soup across it all.
fn degenerate(random: &mut Random) -> Mesh {
    let ball = icosphere(if cfg!(miri) { 0 } else { 2 });
    let (mut positions, mut triangles) = (ball.positions().to_vec(), ball.triangles().to_vec());
    triangles.extend(ball.triangles().iter().take(100));
    for _ in 0..if cfg!(miri) { 10 } else { 300 } {
        let first = positions.len() as u32;
        let (a, along) = (random.point(), random.point());
        let thin = random.magnitude(1e-6) * random.point();
        positions.extend([a, a + along, a + 0.5 * along + thin]);
        triangles.push([first, first + 1, first + 2]);
        triangles.push([first, first, first + 1]);
    }
    Mesh::new(positions, triangles).unwrap()
}

/// From inside, at corners, along axes, and segments.
fn ray(mesh: &Mesh, random: &mut Random) -> Ray {
    let origin = 1.5 * random.point();
    let corner = mesh.positions()[(random.number() * mesh.positions().len() as f32) as usize];
    match (5.0 * random.number()) as u32 {
        0 => Ray::new(origin, corner - origin),
        1 => Ray::new(corner - 3.0 * Vec3::Z, Vec3::new(0.0, -0.0, 1.0)),
        2 => Ray::segment(origin, 1.5 * random.point()),
        3 => Ray::new(corner, random.direction()),
        _ => Ray::new(origin, random.magnitude(1e6) * random.direction()),
    }
}

fn agree<C: LeafKind + Clone>(bvh: &Bvh<C>, rays: &[Ray]) -> usize {
    let versions = versions(bvh);
    let hits: Vec<Option<Hit>> = rays.iter().map(|ray| versions[0].nearest(ray)).collect();
    for version in &versions {
        let mut each = vec![None; rays.len()];
        version.nearest_each(rays, &mut each);
        let mut any = vec![false; rays.len()];
        version.any_hit_each(rays, &mut any);
        for ((ray, hit), (each, any)) in rays.iter().zip(&hits).zip(each.iter().zip(&any)) {
            let kernel = version.tree.kernel;
            assert_eq!(version.nearest(ray), *hit, "{kernel:?} {ray:?}");
            assert_eq!(each, hit, "{kernel:?} {ray:?}");
            let found = hit.is_some();
            assert_eq!((version.any_hit(ray), *any), (found, found), "{kernel:?} {ray:?}");
            let all = version.all_hits(ray);
            assert_eq!(all.first(), hit.as_ref(), "{kernel:?} {ray:?}");
            assert_eq!(all, versions[0].all_hits(ray), "{kernel:?} {ray:?}");
        }
    }
    hits.iter().flatten().count()
}

/// Rays as a camera casts them: eight at a time side by side, now and then too far apart, of
/// different lengths, one that is none, or along an axis.
fn camera(count: usize, random: &mut Random, first: impl Fn(&mut Random) -> Ray) -> Vec<Ray> {
    let mut rays = Vec::new();
    while rays.len() < count {
        let first = first(random);
        let apart = random.magnitude(1e-4) * first.direction.length() * random.point();
        let reach = if random.number() < 0.5 { f32::INFINITY } else { 1.5 };
        rays.extend((0..8_u8).map(|i| {
            let direction = first.direction + f32::from(i) / 8.0 * apart;
            Ray { direction, t_max: reach + f32::from(i), ..first }
        }));
        let last = rays.last_mut().unwrap();
        if random.number() < 0.1 {
            last.t_max = 0.0;
        }
    }
    rays
}

fn kernels_agree(count: usize) {
    let mut random = Random::new(11);
    let mesh = degenerate(&mut random);
    let shapes = crowd(if cfg!(miri) { 20 } else { 400 }, &mut random);
    for precision in [Precision::Watertight, Precision::Fast] {
        let options = Options { precision, ..Options::default() };
        let bvh = Bvh::build_with(&mesh, options).unwrap();
        let rays: Vec<Ray> = (0..count).map(|_| ray(&mesh, &mut random)).collect();
        assert!(agree(&bvh, &rays) > count / 4);
        let rays = camera(count, &mut random, |random| ray(&mesh, random));
        assert!(agree(&bvh, &rays) > count / 4);
    }
    let bvh = Bvh::of_shapes(shapes).unwrap();
    let rays = camera(count, &mut random, |random| super::random_ray(bvh.shapes(), random));
    assert!(agree(&bvh, &rays) > count / 4);
    let rays: Vec<Ray> = (0..count).map(|_| super::random_ray(bvh.shapes(), &mut random)).collect();
    assert!(agree(&bvh, &rays) > count / 4);
}

#[test]
fn all_instruction_sets_give_the_same_bits() {
    kernels_agree(if cfg!(miri) { 30 } else { 20_000 });
}

#[test]
#[ignore = "takes a minute in a release build"]
fn all_instruction_sets_give_the_same_bits_a_million_times() {
    kernels_agree(350_000);
}
