//! The weights: recursive against direct sum, and their sum over all ways to
//! find one path.

mod replay;
mod room;

use super::*;
use crate::numbers::Purpose;
use crate::{Control, Dimensions, PathSampler, PointSet};
use replay::FullPath;
pub(crate) use room::room;
use traylib_math::Rgb;

const HEURISTICS: [Heuristic; 2] = [Heuristic::Balance, Heuristic::Power];

fn render(scene: &Scene, bdpt: &Bdpt) -> Vec<(u32, Rgb)> {
    let (mut out, control) = (ChunkOutput::default(), Control::default());
    for pass in 0..6 {
        let (pixels, light_paths, control) = (0..1024, 0..1024, &control);
        let (points, dimensions) = (PointSet::default(), Dimensions::of(scene));
        let (seed, light_path_count) = (3, 1024);
        let chunk = Chunk {
            seed,
            pass,
            pixels,
            light_paths,
            light_path_count,
            points,
            dimensions,
            control,
        };
        bdpt.render_chunk(scene, &chunk, &mut out);
    }
    out.light
}

/// Every single contribution of a rendering, by both forms. What differs by more
/// than rounding would show as a ratio of weights.
#[test]
fn recursive_weights_equal_the_direct_sum() {
    let scene = room();
    for heuristic in HEURISTICS {
        let plain = Bdpt { heuristic, weighting: Weighting::DirectSum, ..Bdpt::default() };
        let fast = Bdpt { weighting: Weighting::Recursive, ..plain.clone() };
        let (plain, fast) = (render(&scene, &plain), render(&scene, &fast));
        assert!(plain.len() > 50_000, "{} contributions", plain.len());
        let brightest = plain.iter().map(|(_, value)| value.max_band()).fold(0.0, f32::max);
        let large = |light: &[(u32, Rgb)]| -> Vec<(u32, Rgb)> {
            // Weights that underflow single precision in one form may not in
            // the other.
            light.iter().copied().filter(|(_, v)| v.max_band() > 1e-20 * brightest).collect()
        };
        let (plain, fast) = (large(&plain), large(&fast));
        assert_eq!(plain.len(), fast.len());
        for ((pixel, a), (other, b)) in plain.into_iter().zip(fast) {
            assert_eq!(pixel, other);
            let (a, b) = (a.max_band(), b.max_band());
            assert!((a - b).abs() <= 1e-4 * a, "{heuristic:?}: {a} {b}");
        }
    }
}

/// 10⁵ random paths through a room with mirrors, glass, glossy surfaces, a spherical
/// lamp (whose sampling and emission densities differ) and a point lamp: each as
/// every technique would have found it.
#[test]
fn weights_of_all_techniques_sum_to_one() {
    let scene = room();
    for heuristic in HEURISTICS {
        let bdpt = Bdpt { heuristic, ..Bdpt::default() };
        let light_paths = 777;
        let walker = Walker::new(&bdpt, light_paths);
        let (mut paths, mut with_mirrors, mut from_points, mut with_images) = (0, 0, 0, 0);
        for index in 0.. {
            if paths >= 50_000 {
                break;
            }
            for path in random_paths(&scene, &walker, index) {
                let sum: f64 = path.weights(&scene, &walker, &bdpt, light_paths).sum();
                assert!((sum - 1.0).abs() < 1e-4, "{heuristic:?}: {sum}, {path:?}");
                paths += 1;
                with_mirrors += usize::from(path.has_mirror());
                from_points += usize::from(path.starts_at_point());
                with_images += usize::from(path.has_images(&scene));
            }
        }
        assert!(with_mirrors > 5_000 && from_points > 5_000, "{with_mirrors} {from_points}");
        assert!(with_images > 5_000, "{with_images}");
    }
}

/// What walks carry along is what the densities of their path say, which are computed here for
/// the whole path again: which neighbour of a vertex decides what it aims at, from both ends.
#[test]
fn walks_carry_the_weights_of_their_paths() {
    let scene = room();
    let bdpt = Bdpt::default();
    let light_paths = 777;
    let walker = Walker::new(&bdpt, light_paths);
    let (mut compared, mut different, mut with_images) = (0, 0, 0);
    for index in 0..4000 {
        let Some((start, light, camera)) = random_walks(&scene, &walker, index) else { continue };
        let path = FullPath::connected(&scene, &start, &light, &camera);
        let Some(path) = path else { continue };
        let again = path.light_vertices(&scene, &walker, &bdpt);
        let back = path.camera_vertices(&scene, &bdpt, light_paths);
        for (walked, again) in light.iter().zip(&again).chain(camera.iter().zip(&back)) {
            // Directions are formed again from rounded positions: near corners they differ, and
            // may be on the other side of the edge of a cone.
            let close = |a: f64, b: f64| (a - b).abs() <= 1e-2 * a.max(b);
            let alike = close(walked.d_vcm, again.d_vcm) && close(walked.d_vc, again.d_vc);
            different += usize::from(!alike);
            compared += 1;
        }
        with_images += usize::from(path.has_images(&scene));
    }
    assert!(compared > 5_000 && with_images > 200, "{compared} {with_images}");
    assert!(1000 * different <= compared, "{different} of {compared}");
}

/// A light and a camera subpath, if both met anything.
fn random_walks(
    scene: &Scene,
    walker: &Walker,
    index: u64,
) -> Option<(LightStart, Vec<Vertex>, Vec<Vertex>)> {
    let control = Control::default();
    let mut tracer = Tracer::new(scene, &control);
    let (mut light, mut camera) = (Subpath::default(), Subpath::default());
    let mut sampler = PathSampler::independent(Purpose::Light.sampler(1, 0, index as u32));
    let start = walker.light_subpath(&mut tracer, &mut sampler, &mut light);
    let mut sampler = PathSampler::independent(Purpose::Camera.sampler(1, 0, index as u32));
    walker.camera_subpath(&mut tracer, index as u32 % 1024, &mut sampler, &mut camera);
    Some((start?, light.vertices, camera.vertices))
}

/// All paths that one light and one camera subpath make by connection or hit,
/// whether or not something stands between.
fn random_paths(scene: &Scene, walker: &Walker, index: u64) -> Vec<FullPath> {
    let Some((start, light, camera)) = random_walks(scene, walker, index) else {
        return Vec::new();
    };
    let mut paths = Vec::new();
    for t in 1..=camera.len() {
        paths.extend(FullPath::hit(scene, &camera[..t]));
        for s in 1..=light.len() {
            paths.extend(FullPath::connected(scene, &start, &light[..s], &camera[..t]));
        }
    }
    paths
}
