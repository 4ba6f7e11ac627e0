//! Passes that are given up.

use super::*;
use crate::bdpt::room;
use crate::{Bdpt, BlindSpot, Limits, PureMc, Roulette, SceneFacts};
use crate::{Chunk, ChunkOutput};
use std::time::{Duration, Instant};
use traylib_geometry::{Facing, Primitive, Sides, Sphere};
use traylib_materials::{Lambert, SurfaceModel};
use traylib_math::{Grid, Rgb, Vec3};
use traylib_scene::{Camera, CameraSettings, Object, ObjectShape, SceneBuilder};

/// An integrator that ends the rendering when it has done a chunk.
struct Cancelling {
    inner: Bdpt,
    pass: u64,
    first_pixel: u32,
}

impl Integrator for Cancelling {
    fn light_paths(&self, pixels: u32) -> u32 {
        self.inner.light_paths(pixels)
    }

    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        self.inner.render_chunk(scene, chunk, out);
        if (chunk.pass, chunk.pixels.start) == (self.pass, self.first_pixel) {
            chunk.control.cancel();
        }
    }

    fn blind_spots(&self, facts: &SceneFacts) -> Vec<BlindSpot> {
        self.inner.blind_spots(facts)
    }
}

fn go_on(_: &Progress<'_>) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// Whichever chunk it happens in, and on however many threads.
#[test]
fn a_pass_that_is_given_up_leaves_no_trace() {
    let scene = room();
    let settings = |spp, threads| Settings { spp, seed: 5, threads, ..Settings::default() };
    for passes in [0, 1, 3] {
        let (bdpt, control) = (Bdpt::default(), Control::default());
        let whole = render(&scene, &bdpt, &settings(passes, 1), &control, &mut go_on).unwrap();
        for (threads, first_pixel) in [(1, 0), (2, 256), (3, 768)] {
            let (pass, control) = (passes.into(), Control::default());
            let cancelling = Cancelling { inner: Bdpt::default(), pass, first_pixel };
            let settings = settings(100, threads);
            let cut = render(&scene, &cancelling, &settings, &control, &mut go_on).unwrap();
            assert_eq!(cut.film.passes(), passes);
            assert_eq!(cut.film.mean(), whole.film.mean());
            assert_eq!(cut.statistics, whole.statistics);
            let part = control.part_of_pass();
            assert!((0.0..1.0).contains(&part), "{part}");
        }
    }
}

/// The film of some passes.
fn film_of(passes: impl IntoIterator<Item = u32>, scene: &Scene, threads: usize) -> Film {
    let bdpt = Bdpt::default();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    let mut renderer = Renderer::new(scene, &bdpt, 5, PointSet::Independent);
    for pass in passes {
        assert!(pool.install(|| renderer.render_pass(pass, &Control::default())));
    }
    renderer.finish().film
}

/// In 2, 3 and 7 parts on as many threads, the last part first.
#[test]
fn films_of_parts_make_that_of_the_whole() {
    const PASSES: u32 = 9;
    let scene = room();
    let whole = film_of(0..PASSES, &scene, 1);
    for parts in [2, 3, 7] {
        let mut film = Film::new(scene.camera().width(), scene.camera().height());
        for part in (0..parts).rev() {
            let passes = PASSES * part / parts..PASSES * (part + 1) / parts;
            film.merge(film_of(passes, &scene, parts as usize)).unwrap();
        }
        let bits = |grid: &Grid<[f64; 3]>| -> Vec<u64> {
            grid.values().as_flattened().iter().map(|value| value.to_bits()).collect()
        };
        assert_eq!(bits(&film.mean()), bits(&whole.mean()));
        let variances = [&film, &whole].map(|film| bits(&film.variance_of_mean().unwrap()));
        assert_eq!(variances[0], variances[1]);
    }
}

/// Work that is done meanwhile sees the passes before, and changes nothing.
#[test]
fn passes_beside_other_work_are_the_same() {
    let scene = room();
    let (bdpt, control) = (Bdpt::default(), Control::default());
    let pool = thread_pool(2).unwrap();
    let mut renderer = Renderer::new(&scene, &bdpt, 5, PointSet::Independent);
    let mut seen = Vec::new();
    for pass in 0..3 {
        let look = |rendering: &Rendering| seen.push(rendering.film.passes());
        assert!(renderer.render_pass_beside(pass, &control, &pool, look));
    }
    assert_eq!(seen, [0, 1, 2]);
    let film = film_of(0..3, &scene, 1);
    assert_eq!(renderer.rendering().film.mean(), film.mean());
    // Cancelled by the other work, a pass is given up before its end or is whole.
    let before = renderer.rendering().statistics;
    let is_whole = renderer.render_pass_beside(3, &control, &pool, |_| control.cancel());
    assert_eq!(renderer.rendering().film.has_pass(3), is_whole);
    assert_eq!(renderer.rendering().statistics == before, !is_whole);
}

/// Within a ball that keeps all light.
fn white() -> Scene {
    let settings = CameraSettings {
        position: Vec3::ZERO,
        target: Vec3::Z,
        up: Vec3::Y,
        fov_degrees: 60.0,
        width: 4,
        height: 4,
    };
    let mut builder = SceneBuilder::new(Camera::new(settings).unwrap());
    let white = SurfaceModel::Lambert(Lambert::new(Rgb::WHITE).unwrap());
    let ball = Sphere::new(Vec3::ZERO, 1.0, Facing::Inward).unwrap();
    let object = Object {
        shape: ObjectShape::Primitive(Primitive::Sphere(ball)),
        sides: Sides::Both,
        material: builder.add_material(white),
        emission: Rgb::WHITE,
    };
    builder.add_object(object).unwrap();
    builder.build().unwrap()
}

/// Nothing ends its walks but a ray that looks up.
#[test]
fn a_walk_without_end_hears() {
    let scene = white();
    let limits = Limits { max_depth: None, roulette: Roulette::OFF };
    let control = Control::default();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            std::thread::sleep(Duration::from_millis(100));
            control.cancel();
        });
        let start = Instant::now();
        let settings = Settings { spp: 1, seed: 0, threads: 2, ..Settings::default() };
        let cut = render(&scene, &PureMc { limits }, &settings, &control, &mut go_on).unwrap();
        assert_eq!((cut.film.passes(), control.part_of_pass()), (0, 0.0));
        // Microseconds; the rest is for a machine with other work.
        assert!(start.elapsed() < Duration::from_secs(10));
    });
}
