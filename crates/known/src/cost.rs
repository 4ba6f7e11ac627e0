//! The time that a pass takes.

use std::time::Instant;
use traylib_integrators::{Chunk, ChunkOutput, Control, Dimensions, Integrator, PointSet};
use traylib_scene::Scene;
use traylib_statistics::median;

/// Passes are timed together for as long as this, in seconds.
const SPAN: f64 = 0.08;

/// Times they are; the one in the middle counts.
const REPETITIONS: usize = 5;

/// Pixels in a chunk, as in `render`.
const CHUNK: u32 = 256;

/// Seconds of one pass, without film and reports: of the processor, where the
/// system tells them, so that other programs do not count.
pub fn seconds_per_pass(scene: &Scene, integrator: &dyn Integrator) -> f64 {
    let times = interleaved(scene, &[integrator], SPAN, REPETITIONS);
    median(times.into_iter().flatten().collect())
}

/// Seconds of one pass of each of these, as often as `repetitions` says, in turns:
/// what makes the machine slower for a while does so for all. Each time is that of
/// as many passes as fill `span` seconds.
pub fn interleaved(
    scene: &Scene,
    integrators: &[&dyn Integrator],
    span: f64,
    repetitions: usize,
) -> Vec<Vec<f64>> {
    let mut times = vec![Vec::new(); integrators.len()];
    let mut number = 0;
    for _ in 0..repetitions {
        for (times, &integrator) in times.iter_mut().zip(integrators) {
            times.push(repetition(scene, integrator, span, &mut number));
        }
    }
    times
}

fn repetition(scene: &Scene, integrator: &dyn Integrator, span: f64, number: &mut u64) -> f64 {
    let (clock, first) = (Clock::start(), *number);
    while *number == first || clock.wall.elapsed().as_secs_f64() < span {
        pass(scene, integrator, *number);
        *number += 1;
    }
    clock.seconds() / (*number - first) as f64
}

fn pass(scene: &Scene, integrator: &dyn Integrator, pass: u64) {
    let pixels = scene.camera().width() * scene.camera().height();
    let paths = integrator.light_paths(pixels);
    let (control, points, dimensions) =
        (Control::default(), PointSet::default(), Dimensions::of(scene));
    for start in (0..pixels).step_by(CHUNK as usize) {
        let end = (start + CHUNK).min(pixels);
        let share = |pixel: u32| (u64::from(pixel) * u64::from(paths) / u64::from(pixels)) as u32;
        let light_paths = share(start)..share(end);
        let chunk = Chunk {
            seed: 0,
            pass,
            pixels: start..end,
            light_paths,
            light_path_count: paths,
            points,
            dimensions,
            control: &control,
        };
        let mut out = ChunkOutput::default();
        integrator.render_chunk(scene, &chunk, &mut out);
        std::hint::black_box(out);
    }
}

/// Time of this thread since the start.
struct Clock {
    processor: Option<u64>,
    wall: Instant,
}

impl Clock {
    fn start() -> Self {
        Self { processor: nanoseconds_of_thread(), wall: Instant::now() }
    }

    fn seconds(&self) -> f64 {
        match (self.processor, nanoseconds_of_thread()) {
            (Some(start), Some(end)) if end > start => (end - start) as f64 * 1e-9,
            _ => self.wall.elapsed().as_secs_f64(),
        }
    }
}

/// Returns the processor time that Linux has given this thread, in nanoseconds. The system adds up
/// when it looks for other work, hence the offer; between times it is behind by a tick.
fn nanoseconds_of_thread() -> Option<u64> {
    std::thread::yield_now();
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split_whitespace().next()?.parse().ok()
}
