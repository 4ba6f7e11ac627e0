//! Measures the figures that a planner's table of prices is made from: the work of every kind of
//! method on scenes of all sizes, counted, and the time that it takes.

mod fit;

pub use fit::fit;

use traylib_integrators::planner::{Work, work};
use traylib_integrators::{Integrator, Method, MethodError, PointSet, ThreadError};
use traylib_known::cost::interleaved;
use traylib_scene::Scene;

/// One of each way to spend work.
pub const METHODS: [&str; 10] = [
    "puremc",
    "directlight",
    "directlight --combine",
    "directlight --combine --max-depth 3",
    "particle",
    "bdpt",
    "bdpt --max-depth 4",
    "bdpt --no-connections",
    "bdpt --light-paths 0.25",
    "bdpt --no-splats --light-paths 0.5",
];

/// A method on a scene.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The scene's name.
    pub scene: String,
    /// Its primitives.
    pub primitives: usize,
    /// The method.
    pub method: Method,
    /// The work that it does for a sample.
    pub work: Work,
    /// Nanoseconds of a sample on one thread.
    pub nanoseconds: f64,
}

/// Passes are timed together for as long as this, in seconds, so many times.
const TIMING: (f64, usize) = (0.15, 5);

/// Counts and times all methods on a scene.
///
/// # Errors
/// The system refuses threads.
///
/// # Panics
/// If a method is not spelled as one.
pub fn measure(name: &str, scene: &Scene) -> Result<Vec<Sample>, ThreadError> {
    let methods: Result<Vec<Method>, MethodError> =
        METHODS.iter().map(|text| text.parse()).collect();
    let methods = methods.expect("methods are spelled right");
    let integrators: Vec<_> = methods.iter().map(|method| method.build()).collect();
    let integrators: Vec<&dyn Integrator> = integrators.iter().map(AsRef::as_ref).collect();
    let (span, repetitions) = TIMING;
    let times = interleaved(scene, &integrators, span, repetitions);
    let pixels = f64::from(scene.camera().width() * scene.camera().height());
    methods
        .into_iter()
        .zip(times)
        .map(|(method, times)| {
            // What else the machine does only adds: the shortest is the least disturbed.
            let shortest = times.into_iter().fold(f64::INFINITY, f64::min);
            Ok(Sample {
                scene: name.into(),
                primitives: scene.primitive_count(),
                method,
                work: work(scene, method, PointSet::Sobol)?,
                nanoseconds: 1e9 * shortest / pixels,
            })
        })
        .collect()
}
