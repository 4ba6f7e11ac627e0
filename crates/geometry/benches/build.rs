//! Triangles a second into a tree, of each quality and three sizes of room.

#[path = "support/support.rs"]
mod support;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::time::Duration;
use support::room::Room;
use traylib_geometry::{Bvh, Options, Quality};

const QUALITIES: [(&str, Quality); 3] =
    [("fast", Quality::Fast), ("balanced", Quality::Balanced), ("best", Quality::Best)];

fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("build");
    // A million triangles take seconds: ten times are what one has patience for.
    group.sample_size(10).measurement_time(Duration::from_secs(5));
    for room in [Room::small(), Room::medium(), Room::large()] {
        let Room { name, mesh } = room.expect("a sound mesh");
        group.throughput(Throughput::Elements(mesh.triangle_count() as u64));
        for (quality_name, quality) in QUALITIES {
            let options = Options { quality, ..Options::default() };
            group.bench_function(BenchmarkId::new(quality_name, name), |b| {
                b.iter(|| Bvh::build_with(&mesh, options).expect("a sound mesh"));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
