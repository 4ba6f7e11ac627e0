//! Rays a second: a box with balls (14 primitives, beside asking all of them), a
//! hundred columns beside a hundred balls, and a mesh of 20 000 triangles.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::f32::consts::TAU;
use std::hint::black_box;
use traylib_geometry::{
    Bvh, Cone, Facing, Mesh, Primitive, Quad, Ray, Shape, SidedPrimitive, Sides, Sphere, Vec3,
};
use traylib_math::{Purpose, Sampler, warp};

const RAYS: usize = 4096;

/// Five walls, a lamp, two blocks' tops and six balls.
fn box_with_balls() -> Vec<SidedPrimitive> {
    let quad = |corner: [f32; 3], u: [f32; 3], v: [f32; 3]| {
        Quad::new(corner.into(), u.into(), v.into()).map(Primitive::Quad).ok()
    };
    let walls = [
        quad([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]),
        quad([0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        quad([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        quad([0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
        quad([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]),
        quad([0.4, 0.99, 0.4], [0.2, 0.0, 0.0], [0.0, 0.0, 0.2]),
        quad([0.1, 0.3, 0.1], [0.1, 0.0, 0.3], [0.3, 0.0, -0.1]),
        quad([0.6, 0.5, 0.2], [-0.1, 0.0, 0.2], [0.3, 0.0, 0.1]),
    ];
    let ball = |i: u8| {
        let x = 0.15 + 0.14 * f32::from(i);
        let centre = Vec3::new(x, 0.1 + 0.3 * (x * 7.0).sin().abs(), 0.6 + 0.3 * (x * 5.0).sin());
        Sphere::new(centre, 0.08, Facing::Outward).map(Primitive::Sphere).ok()
    };
    let primitives = walls.into_iter().chain((0..6).map(ball)).flatten();
    primitives.map(|primitive| SidedPrimitive { primitive, sides: Sides::Both }).collect()
}

/// A shape at each of ten by ten places.
fn hundred(shape: impl Fn(Vec3) -> Option<Primitive>) -> Bvh<Primitive> {
    let place = |i: u8| 0.05 + 0.1 * Vec3::new(f32::from(i % 10), 0.0, f32::from(i / 10));
    Bvh::build((0..100).map(place).filter_map(shape).collect()).expect("sound shapes")
}

/// A column that grows thinner toward its top.
fn column(place: Vec3) -> Option<Primitive> {
    let ends = [place, place + 0.9 * Vec3::Y];
    Cone::new(ends, [0.02, 0.015], Facing::Outward).map(Primitive::Cone).ok()
}

fn ball(place: Vec3) -> Option<Primitive> {
    Sphere::new(place, 0.04, Facing::Outward).map(Primitive::Sphere).ok()
}

/// A ball of 100 × 100 cells in waves.
fn wavy_ball() -> Bvh<impl Shape> {
    let n = 100_u32;
    let point = |i: u32| {
        let (theta, phi) = ((i / n) as f32 / 99.0 * 3.1, (i % n) as f32 / 100.0 * TAU);
        let radius = 0.5 + 0.05 * (9.0 * phi).sin() * (7.0 * theta).sin();
        let flat = radius * (theta + 0.02).sin();
        0.5 + Vec3::new(flat * phi.cos(), flat * phi.sin(), radius * (theta + 0.02).cos())
    };
    let cell = |i: u32| {
        let (below, beside) = (i + n, i - i % n + (i + 1) % n);
        [[i, below, beside], [beside, below, beside + n]]
    };
    let triangles = (0..n * (n - 1)).flat_map(cell).collect();
    let mesh = Mesh::new((0..n * n).map(point).collect(), triangles).expect("a sound mesh");
    let triangles = (0..mesh.triangle_count()).filter_map(|i| mesh.triangle(i)).collect();
    Bvh::build(triangles).expect("sound triangles")
}

/// Rays from inside the unit cube in all directions, as bounces are, and
/// segments between points in it, as shadow rays are.
fn rays(segments: bool) -> Vec<Ray> {
    let mut sampler = Sampler::new(1, Purpose::Test, 0, 0);
    let mut point = || Vec3::new(sampler.next_1d(), sampler.next_1d(), sampler.next_1d());
    let mut other = Sampler::new(2, Purpose::Test, 0, 0);
    (0..RAYS)
        .map(|_| {
            let origin = point();
            if segments {
                Ray::segment(origin, point())
            } else {
                Ray::new(origin, warp::uniform_sphere(other.next_2d()))
            }
        })
        .collect()
}

fn measure<S: Shape>(criterion: &mut Criterion, name: &str, bvh: &Bvh<S>) {
    let (bounces, shadows) = (rays(false), rays(true));
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(RAYS as u64));
    group.bench_function("nearest", |b| {
        b.iter(|| bounces.iter().filter_map(|r| bvh.nearest(r)).map(|h| h.t).sum::<f32>());
    });
    group.bench_function("any_hit", |b| {
        b.iter(|| shadows.iter().filter(|r| bvh.any_hit(r)).count());
    });
    group.finish();
}

/// The loop that a tree has to beat.
fn ask_all(criterion: &mut Criterion, shapes: &[SidedPrimitive]) {
    let (bounces, shadows) = (rays(false), rays(true));
    let nearest = |ray: &Ray| {
        let mut ray = *ray;
        for shape in shapes {
            if let Some(hit) = shape.intersect(&ray) {
                ray.t_max = hit.t;
            }
        }
        ray.t_max
    };
    let mut group = criterion.benchmark_group("box with balls, all asked");
    group.throughput(Throughput::Elements(RAYS as u64));
    group.bench_function("nearest", |b| {
        b.iter(|| bounces.iter().map(nearest).filter(|t| t.is_finite()).sum::<f32>());
    });
    let any = |ray: &&Ray| shapes.iter().any(|s| s.intersect(ray).is_some());
    group.bench_function("any_hit", |b| b.iter(|| shadows.iter().filter(any).count()));
    group.finish();
}

fn bench(criterion: &mut Criterion) {
    let shapes = box_with_balls();
    ask_all(criterion, &shapes);
    let bvh = Bvh::build(shapes).expect("sound shapes");
    measure(criterion, "box with balls", black_box(&bvh));
    measure(criterion, "hundred columns", black_box(&hundred(column)));
    measure(criterion, "hundred balls", black_box(&hundred(ball)));
    measure(criterion, "20k triangles", black_box(&wavy_ball()));
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .measurement_time(std::time::Duration::from_secs(3))
        .warm_up_time(std::time::Duration::from_secs(1));
    targets = bench
}
criterion_main!(benches);
