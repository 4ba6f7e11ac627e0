//! Rays a second: rooms of three sizes, each ray by itself and in batches; a box
//! with balls (14 shapes, beside asking all of them), a hundred columns, a hundred
//! balls.

#[path = "support/support.rs"]
mod support;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use support::mixed;
use support::rays::RaySets;
use support::room::Room;
use traylib_geometry::{Bvh, Hit, Ray, Shape, SidedPrimitive};

const RAYS: usize = 4096;

/// One number of rays for all: a picture of this many pixels squared.
const SIDE: u32 = 64;

/// Both kinds of question, each ray by itself.
fn measure(
    criterion: &mut Criterion,
    name: &str,
    [bounces, shadows]: [&[Ray]; 2],
    nearest: impl Fn(&Ray) -> Option<Hit>,
    any_hit: impl Fn(&Ray) -> bool,
) {
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(bounces.len() as u64));
    group.bench_function("nearest", |b| {
        b.iter(|| bounces.iter().filter_map(&nearest).map(|h| h.t).sum::<f32>());
    });
    group.throughput(Throughput::Elements(shadows.len() as u64));
    group.bench_function("any_hit", |b| {
        b.iter(|| shadows.iter().filter(|ray| any_hit(ray)).count());
    });
    group.finish();
}

fn measure_shapes<S: Shape + 'static>(criterion: &mut Criterion, name: &str, shapes: Vec<S>) {
    let bvh = black_box(Bvh::of_shapes(shapes).expect("sound shapes"));
    let (bounces, shadows) = (mixed::bounces(RAYS), mixed::segments(RAYS));
    measure(criterion, name, [&bounces, &shadows], |r| bvh.nearest(r), |r| bvh.any_hit(r));
}

/// The loop that a tree has to beat.
fn ask_all(criterion: &mut Criterion, shapes: &[SidedPrimitive]) {
    let (bounces, shadows) = (mixed::bounces(RAYS), mixed::segments(RAYS));
    let nearest = |ray: &Ray| {
        let mut nearest = None;
        let mut ray = *ray;
        for (primitive, shape) in (0..).zip(shapes) {
            if let Some(hit) = shape.intersect(&ray) {
                ray.t_max = hit.t;
                nearest = Some(Hit { t: hit.t, primitive, u: hit.u, v: hit.v });
            }
        }
        nearest
    };
    let any_hit = |ray: &Ray| shapes.iter().any(|s| s.intersect(ray).is_some());
    let name = "box with balls, all asked";
    measure(criterion, name, [&bounces, &shadows], nearest, any_hit);
}

fn measure_room(criterion: &mut Criterion, room: &Room) {
    let bvh = black_box(Bvh::build(&room.mesh).expect("a sound mesh"));
    let found = |ray: &Ray| bvh.nearest(ray).map(|hit| (hit.t, hit.primitive));
    let rays = RaySets::new(room, SIDE, found);
    let name = format!("{} room", room.name);
    let sets: [&[Ray]; 2] = [&rays.bounces, &rays.shadow];
    measure(criterion, &name, sets, |r| bvh.nearest(r), |r| bvh.any_hit(r));
    measure_batches(criterion, &name, sets, &bvh);
}

fn measure_batches(criterion: &mut Criterion, name: &str, sets: [&[Ray]; 2], bvh: &Bvh) {
    let [bounces, shadows] = sets;
    let mut hits = vec![None; bounces.len()];
    let mut found = vec![false; shadows.len()];
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(bounces.len() as u64));
    group.bench_function("nearest_each", |b| b.iter(|| bvh.nearest_each(bounces, &mut hits)));
    group.throughput(Throughput::Elements(shadows.len() as u64));
    group.bench_function("any_hit_each", |b| b.iter(|| bvh.any_hit_each(shadows, &mut found)));
    group.finish();
}

fn bench(criterion: &mut Criterion) {
    let shapes = mixed::box_with_balls();
    ask_all(criterion, &shapes);
    measure_shapes(criterion, "box with balls", shapes);
    measure_shapes(criterion, "hundred columns", mixed::hundred_columns());
    measure_shapes(criterion, "hundred balls", mixed::hundred_balls());
    for room in [Room::small(), Room::medium(), Room::large()] {
        measure_room(criterion, &room.expect("a sound mesh"));
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .measurement_time(std::time::Duration::from_secs(3))
        .warm_up_time(std::time::Duration::from_secs(1));
    targets = bench
}
criterion_main!(benches);
