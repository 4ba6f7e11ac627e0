//! One place of an axis.

use super::scenes::scene;
use super::{Axis, Level, METHODS};
use crate::memory::{held_by, peak_during};
use crate::results::Estimate;
use std::time::Instant;
use traylib_integrators::{Integrator, Method, Settings, render_to_end};
use traylib_known::cost::interleaved;
use traylib_scene::Scene;

/// Passes are timed together for as long as this, in seconds.
const SPAN: f64 = 0.1;

/// Times they are.
const REPETITIONS: usize = 5;

/// Builds the scene and measures both methods on it.
pub(super) fn level(axis: Axis, size: u64) -> Result<Level, String> {
    let start = Instant::now();
    let (scene, scene_bytes) = held_by(|| scene(axis, size));
    let (scene, build_seconds) = (scene?, start.elapsed().as_secs_f64());
    let longest = (axis == Axis::PathLength).then_some(size as u32);
    let methods = METHODS.map(|method: Method| method.up_to(longest).build());
    let methods = methods.each_ref().map(AsRef::as_ref);
    let sample_seconds = match axis {
        Axis::Threads => by_the_clock(&scene, methods, size as usize)?,
        Axis::Triangles | Axis::Lamps | Axis::PathLength | Axis::Pixels => {
            interleaved(&scene, &methods, SPAN, REPETITIONS)
        }
    };
    let pixels = f64::from(scene.camera().width() * scene.camera().height());
    let threads = if axis == Axis::Threads { size as usize } else { 1 };
    Ok(Level {
        size,
        build_seconds,
        scene_bytes,
        render_bytes: render_bytes(&scene, methods, threads)?,
        sample_seconds: sample_seconds.into_iter().map(|times| middle(times, pixels)).collect(),
    })
}

/// Seconds of a pass by the clock, of whole renderings in turns.
fn by_the_clock<const N: usize>(
    scene: &Scene,
    methods: [&dyn Integrator; N],
    threads: usize,
) -> Result<Vec<Vec<f64>>, String> {
    const PASSES: u32 = 8;
    let mut times = vec![Vec::new(); N];
    for _ in 0..REPETITIONS {
        for (times, method) in times.iter_mut().zip(methods) {
            let settings = Settings { spp: PASSES, threads, ..Settings::default() };
            let start = Instant::now();
            render_to_end(scene, method, &settings).map_err(|error| error.to_string())?;
            times.push(start.elapsed().as_secs_f64() / f64::from(PASSES));
        }
    }
    Ok(times)
}

/// The most bytes that a picture of two passes takes beside the scene.
fn render_bytes<const N: usize>(
    scene: &Scene,
    methods: [&dyn Integrator; N],
    threads: usize,
) -> Result<Vec<u64>, String> {
    let settings = Settings { spp: 2, threads, ..Settings::default() };
    let bytes = methods.into_iter().map(|method| {
        let (rendering, bytes) = peak_during(|| render_to_end(scene, method, &settings));
        rendering.map(|_| bytes).map_err(|error| error.to_string())
    });
    bytes.collect()
}

/// Returns for a sample the middle of these times of a pass, the shortest and the longest.
fn middle(mut times: Vec<f64>, pixels: f64) -> Estimate {
    times.sort_by(f64::total_cmp);
    let at = |place: usize| times.get(place).map_or(f64::NAN, |time| time / pixels);
    Estimate { value: at(times.len() / 2), low: at(0), high: at(times.len().saturating_sub(1)) }
}
