//! The weights: recursive against direct sum, and their sum over all ways to
//! find one path.

mod replay;
mod room;

use super::*;
use crate::numbers::Purpose;
use crate::{Control, Dimensions, PathSampler, PointSet};
use replay::FullPath;
pub(crate) use room::{room, room_under_sky};
use traylib_math::Rgb;

const DEFAULT: BdptSettings = BdptSettings::DEFAULT;
const HEURISTICS: [Heuristic; 2] = [Heuristic::Balance, Heuristic::Power];

fn render(scene: &Scene, bdpt: &Bdpt) -> Vec<(u32, Rgb)> {
    let (mut out, control) = (ChunkOutput::default(), Control::default());
    for pass in 0..6 {
        let light_path_count = bdpt.light_paths(scene.camera().width() * scene.camera().height());
        let (pixels, light_paths, control) = (0..1024, 0..light_path_count, &control);
        let (points, dimensions) = (PointSet::default(), Dimensions::of(scene));
        let seed = 3;
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
    both_weights_are_equal(&room());
}

#[test]
fn recursive_weights_equal_the_direct_sum_under_a_sky() {
    both_weights_are_equal(&room_under_sky());
}

fn both_weights_are_equal(scene: &Scene) {
    let part = |no_connections, no_splats, thousandths, heuristic| {
        let light_paths = PathsPerPixel::of_thousandths(thousandths);
        let settings = BdptSettings { no_connections, no_splats, light_paths, ..DEFAULT };
        BdptSettings { heuristic, ..settings }
    };
    let whole = HEURISTICS.map(|heuristic| part(false, false, 1000, heuristic));
    let parts = [
        part(true, false, 250, Heuristic::Power),
        part(false, true, 1000, Heuristic::Balance),
        part(false, false, 500, Heuristic::Power),
    ];
    for settings in whole.into_iter().chain(parts) {
        let fast = settings.integrator(Report::None);
        let heuristic = settings.heuristic;
        let plain = Bdpt { weighting: Weighting::DirectSum, ..fast.clone() };
        let (plain, fast) = (render(scene, &plain), render(scene, &fast));
        assert!(plain.len() > 20_000, "{} contributions", plain.len());
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
        let splats = 777.0;
        let walker = Walker::new(&bdpt, splats);
        let (mut paths, mut with_mirrors, mut from_points, mut with_images) = (0, 0, 0, 0);
        for index in 0.. {
            if paths >= 50_000 {
                break;
            }
            for path in random_paths(&scene, &walker, index) {
                let weights = path.weights(&scene, &walker, &bdpt, splats);
                let sum: f64 = weights.iter().map(|(_, weight)| weight).sum();
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

/// The same where the sky looks in, whose points are directions.
#[test]
fn weights_of_all_techniques_sum_to_one_under_a_sky() {
    let scene = room_under_sky();
    for heuristic in HEURISTICS {
        let bdpt = Bdpt { heuristic, ..Bdpt::default() };
        let splats = 777.0;
        let walker = Walker::new(&bdpt, splats);
        let (mut from_sky, mut shared) = (0, 0);
        for path in (0..8000).flat_map(|index| random_paths(&scene, &walker, index)) {
            let weights = path.weights(&scene, &walker, &bdpt, splats);
            let sum: f64 = weights.iter().map(|(_, weight)| weight).sum();
            assert!((sum - 1.0).abs() < 1e-4, "{heuristic:?}: {sum}, {path:?}");
            let is_shared = weights.iter().all(|(_, weight)| *weight < 0.9);
            from_sky += usize::from(path.starts_in_the_sky());
            shared += usize::from(path.starts_in_the_sky() && is_shared);
        }
        assert!(from_sky > 3_000 && shared > 1_000, "{from_sky} {shared}");
    }
}

/// What walks carry along is what the densities of their path say, which are computed here for
/// the whole path again: which neighbour of a vertex decides what it aims at, from both ends.
#[test]
fn walks_carry_the_weights_of_their_paths() {
    let scene = room();
    let bdpt = Bdpt::default();
    let splats = 777.0;
    let walker = Walker::new(&bdpt, splats);
    let (mut compared, mut different, mut with_images) = (0, 0, 0);
    for index in 0..4000 {
        let Some((start, light, camera)) = random_walks(&scene, &walker, index) else { continue };
        let path = FullPath::connected(&scene, &start, &light, &camera);
        let Some(path) = path else { continue };
        let again = path.light_vertices(&scene, &walker, &bdpt);
        let back = path.camera_vertices(&scene, &bdpt, splats);
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

/// Point lights that are joined by way of a mirror share their paths with all other techniques
/// that find them, and have them alone where nothing else does.
#[test]
fn mirror_connections_share_their_paths() {
    let scene = room();
    for heuristic in HEURISTICS {
        let bdpt = Bdpt { heuristic, ..Bdpt::default() };
        let splats = 777.0;
        let walker = Walker::new(&bdpt, splats);
        // By way of one mirror and of two.
        let (mut alone, mut shared) = ([0, 0], [0, 0]);
        for index in 0..4000 {
            let Some((_, _, camera)) = random_walks(&scene, &walker, index) else { continue };
            for t in 1..=camera.len() {
                let (x2, camera) = (&camera[t - 1], &camera[..t]);
                for image in scene.point_images(&x2.point, [0.5; 2]) {
                    // What underflows carries no light and has no technique.
                    let f = x2.point.evaluate(x2.wo, image.wi).f;
                    // Directions are formed again from positions that are good to 10⁻⁷ m.
                    let edge = (image.seen_at.position - x2.point.site.position).length();
                    if f.max_band() < 1e-6 || edge < 1e-2 {
                        continue;
                    }
                    let path = FullPath::by_way_of_mirrors(&scene, &image, camera);
                    let Some(path) = path else { continue };
                    let weights = path.weights(&scene, &walker, &bdpt, splats);
                    let sum: f64 = weights.iter().map(|(_, weight)| weight).sum();
                    assert!((sum - 1.0).abs() < 1e-4, "{heuristic:?}: {sum} {weights:?}: {path:?}");
                    let mirrors = image.mirrors() as usize;
                    let own = weights.iter().find(|(s, _)| *s == 1 + mirrors);
                    let own = own.map_or(0.0, |(_, weight)| *weight);
                    alone[mirrors - 1] += usize::from(own == 1.0);
                    shared[mirrors - 1] += usize::from((0.01..0.99).contains(&own));
                }
            }
        }
        assert!(alone[0] > 50 && shared[0] > 250, "{alone:?} {shared:?}");
        assert!(alone[1] > 10 && shared[1] > 50, "{alone:?} {shared:?}");
    }
}

/// The weight of each connection as the joiner forms it from what the walks carry is the one that
/// the whole path says.
#[test]
fn joined_vertices_have_the_weights_of_their_paths() {
    let scene = room();
    // The pictures of techniques as they are and as they count, whose ratio is the weight.
    let bdpt = Bdpt { report: Report::Techniques, ..Bdpt::default() };
    let splats = 777.0;
    let (walker, joiner) = (Walker::new(&bdpt, splats), Joiner::new(&bdpt, 777, splats));
    let control = Control::default();
    let (mut compared, mut different, mut aimed) = (0, 0, 0);
    for index in 0..8000 {
        let Some((start, light, camera)) = random_subpaths(&scene, &walker, index) else {
            continue;
        };
        let mut out = ChunkOutput::default();
        let mut tracer = Tracer::new(&scene, &control);
        let mut sampler = Purpose::Camera.sampler(2, 0, index as u32);
        let partner = LightPath { start: &start, vertices: &light.vertices };
        joiner.join_all(&mut tracer, 0, &camera, Some(partner), &mut sampler, &mut out);
        for pair in out.layers.chunks_exact(2) {
            let [(raw, _, value), (_, _, counted)] = pair else { continue };
            let Technique { s, t, by_mirror, .. } = Technique::of_layer(*raw);
            let [s, t] = [s, t].map(usize::from);
            if s < 2 || by_mirror || value.max_band() < 1e-6 {
                continue;
            }
            let (light, camera) = (&light.vertices[..s - 1], &camera.vertices[..t - 1]);
            let path = FullPath::connected(&scene, &start, light, camera);
            let Some(path) = path else { continue };
            let weights = path.weights(&scene, &walker, &bdpt, splats);
            let Some((_, expected)) = weights.iter().find(|(own, _)| *own == s) else { continue };
            let found = f64::from(counted.max_band() / value.max_band());
            // As for what walks carry.
            different += usize::from((found - expected).abs() > 1e-2 * found.max(*expected));
            compared += 1;
            aimed += usize::from(path.aims_over_edge(&scene, s));
        }
    }
    assert!(compared > 5_000 && aimed > 300, "{compared} {aimed}");
    assert!(1000 * different <= compared, "{different} of {compared}, {aimed}");
}

/// A light and a camera subpath, if both met anything.
fn random_walks(
    scene: &Scene,
    walker: &Walker,
    index: u64,
) -> Option<(LightStart, Vec<Vertex>, Vec<Vertex>)> {
    let (start, light, camera) = random_subpaths(scene, walker, index)?;
    Some((start, light.vertices, camera.vertices))
}

/// The same, with what the camera subpath aims at.
fn random_subpaths(
    scene: &Scene,
    walker: &Walker,
    index: u64,
) -> Option<(LightStart, Subpath, Subpath)> {
    let control = Control::default();
    let mut tracer = Tracer::new(scene, &control);
    let (mut light, mut camera) = (Subpath::default(), Subpath::default());
    let mut sampler = PathSampler::independent(Purpose::Light.sampler(1, 0, index as u32));
    let start = walker.light_subpath(&mut tracer, &mut sampler, &mut light);
    let mut sampler = PathSampler::independent(Purpose::Camera.sampler(1, 0, index as u32));
    walker.camera_subpath(&mut tracer, index as u32 % 1024, &mut sampler, &mut camera);
    Some((start?, light, camera))
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
