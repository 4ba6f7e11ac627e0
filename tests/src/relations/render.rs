//! A drawn scene as numbers: the mean of the picture and of its quarters, for
//! each pass.

use crate::relations::form::Files;
use crate::relations::outside::{Mitsuba, Passes};
use crate::relations::scene::DrawnScene;
use std::fs;
use std::io;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;
use traylib_integrators::{
    Bdpt, Control, Integrator, Limits, Method, Progress, Roulette, TechniqueSet, Weighting, render,
};
use traylib_known::settings_by_pass;
use traylib_math::Heuristic;
use traylib_scene::Scene;

/// The whole picture and its four quarters.
pub const CELLS: usize = 5;

/// The estimator of the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Estimator {
    /// A method.
    Method(Method),
    /// `bdpt` with some of its techniques.
    Among(TechniqueSet),
}

impl Estimator {
    /// The integrator, for paths of at most `max_depth` edges.
    pub fn integrator(self, max_depth: Option<u32>) -> Box<dyn Integrator> {
        match self {
            Self::Method(method) => method.up_to(max_depth).build(),
            Self::Among(set) => Box::new(Bdpt {
                limits: Limits { max_depth, roulette: Roulette::default() },
                heuristic: Heuristic::Balance,
                weighting: Weighting::Among(set),
                ..Bdpt::default()
            }),
        }
    }
}

/// The reason why a scene gave no numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Trouble {
    /// The library refused it.
    Refused(String),
    /// It took longer than it may.
    Slow(f64),
    /// So many samples were negative or not finite.
    Unsound(u64),
}

/// The outcome of a rendering.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// A value for each pass, of each cell.
    pub values: [Vec<f64>; CELLS],
    /// Every band of every pixel.
    pub bands: Vec<f64>,
    /// Pixels of the whole picture.
    pub pixels: u32,
}

/// A scene that is loaded, and how long its paths get.
#[derive(Debug)]
pub struct Built {
    /// The scene.
    pub scene: Scene,
    /// In edges.
    pub max_depth: Option<u32>,
    /// Renderings that several claims ask for.
    known: Mutex<Vec<(Request, Cells)>>,
}

/// Estimator, seed and passes.
type Request = (Estimator, u64, u32);

/// A folder for files under way, which is gone in the end.
#[derive(Debug)]
pub struct Workshop {
    folder: PathBuf,
    /// No rendering may take longer.
    pub patience: Duration,
    /// Mitsuba, once it was asked.
    outside: Mutex<Option<Mitsuba>>,
}

impl Workshop {
    /// A folder of its own among the temporary files of the system.
    ///
    /// # Errors
    /// If it cannot be made.
    pub fn new(patience: Duration) -> io::Result<Self> {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("traylib-relations-{}-{number}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(&folder)?;
        Ok(Self { folder, patience, outside: Mutex::default() })
    }

    /// The scene as the library loads it from our own format.
    ///
    /// # Errors
    /// [`Trouble::Refused`] with the library's words.
    pub fn build(&self, scene: &DrawnScene) -> Result<Built, Trouble> {
        self.load(&Files::of(scene, "scene"), scene.max_depth)
    }

    /// The scene that these files hold.
    ///
    /// # Errors
    /// As [`build`](Self::build).
    pub fn load(&self, files: &Files, max_depth: Option<u32>) -> Result<Built, Trouble> {
        files.save(&self.folder, "").map_err(|error| Trouble::Refused(error.to_string()))?;
        let path = self.folder.join(files.name());
        let loaded = traylib_io::load_scene(&path.to_string_lossy());
        files.remove(&self.folder);
        let loaded = loaded.map_err(|error| Trouble::Refused(error.to_string()))?;
        if let Some(warning) =
            loaded.warnings.iter().map(ToString::to_string).find(|w| !is_expected(w))
        {
            return Err(Trouble::Refused(format!("warning: {warning}")));
        }
        Ok(Built { scene: loaded.scene, max_depth, known: Mutex::default() })
    }

    /// Renders, or finds what was rendered before.
    ///
    /// # Errors
    /// [`Trouble::Slow`], [`Trouble::Unsound`].
    ///
    /// # Panics
    /// If another thread panicked with this scene.
    pub fn render(
        &self,
        built: &Built,
        estimator: Estimator,
        seed: u64,
        passes: u32,
    ) -> Result<Cells, Trouble> {
        let request = (estimator, seed, passes);
        let mut known = built.known.lock().expect("nobody panics with it");
        if let Some((_, cells)) = known.iter().find(|(old, _)| *old == request) {
            return Ok(cells.clone());
        }
        let cells = self.render_anew(built, estimator, seed, passes)?;
        known.push((request, cells.clone()));
        Ok(cells)
    }

    /// What Mitsuba finds in these files.
    ///
    /// # Errors
    /// [`Trouble::Refused`] if there is no Mitsuba, or with its words.
    ///
    /// # Panics
    /// If another thread panicked with it.
    pub fn render_outside(&self, files: &Files, seed: u64, passes: u32) -> Result<Cells, Trouble> {
        let refused = |why: String| Trouble::Refused(format!("mitsuba: {why}"));
        files.save(&self.folder, "").map_err(|error| refused(error.to_string()))?;
        let mut outside = self.outside.lock().expect("nobody panics with it");
        let mitsuba = match &mut *outside {
            Some(mitsuba) => mitsuba,
            none @ None => none.insert(Mitsuba::start().map_err(refused)?),
        };
        let found = mitsuba.render(&self.folder.join(files.name()), seed, passes);
        files.remove(&self.folder);
        let Passes { passes, pixels } = found.map_err(refused)?;
        let values = std::array::from_fn(|cell| passes.iter().map(|pass| pass[cell]).collect());
        Ok(Cells { values, bands: Vec::new(), pixels })
    }

    fn render_anew(
        &self,
        built: &Built,
        estimator: Estimator,
        seed: u64,
        passes: u32,
    ) -> Result<Cells, Trouble> {
        let integrator = estimator.integrator(built.max_depth);
        let settings = settings_by_pass(passes, seed);
        let width = built.scene.camera().width() as usize;
        let mut sums = Sums::default();
        let observe = &mut |progress: &Progress<'_>| {
            sums.add(progress, width);
            ControlFlow::Continue(())
        };
        let rendering = with_patience(self.patience, |control| {
            render(&built.scene, integrator.as_ref(), &settings, control, observe)
        });
        let rendering = rendering.map_err(|error| Trouble::Refused(error.to_string()))?;
        if rendering.film.passes() < passes {
            return Err(Trouble::Slow(self.patience.as_secs_f64()));
        }
        if rendering.statistics.rejected > 0 {
            return Err(Trouble::Unsound(rendering.statistics.rejected));
        }
        let mean = rendering.film.mean();
        Ok(Cells {
            values: sums.values,
            bands: mean.values().iter().flatten().copied().collect(),
            pixels: mean.values().len() as u32,
        })
    }
}

/// Tells whether it tells of a limit that is documented, and that relations know of.
fn is_expected(warning: &str) -> bool {
    let known = [
        "lets light through and has one side",
        "lamp in one place with another surface",
        "surface in which the camera lies",
        "point light that lies in a surface",
        "taken for clear glass",
    ];
    known.iter().any(|words| warning.contains(words))
}

impl Drop for Workshop {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// Cancels a task that takes longer than this.
fn with_patience<T>(patience: Duration, task: impl FnOnce(&Control) -> T) -> T {
    let control = Control::default();
    let (done, waits) = channel::<()>();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            // Moved here, so that nobody is left to wait for if this ends first.
            let waits = waits;
            if waits.recv_timeout(patience) == Err(RecvTimeoutError::Timeout) {
                control.cancel();
            }
        });
        let result = task(&control);
        drop(done);
        result
    })
}

/// Values under way.
#[derive(Default)]
struct Sums {
    before: [f64; CELLS],
    values: [Vec<f64>; CELLS],
}

impl Sums {
    /// The film is the mean of all passes: what the last one added is the rest.
    fn add(&mut self, progress: &Progress<'_>, width: usize) {
        let passes = f64::from(progress.film.passes());
        let mean = progress.film.mean();
        let mut cells = [0.0; CELLS];
        for (index, [r, g, b]) in mean.values().iter().enumerate() {
            let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
            let (x, y) = (index % width, index / width);
            cells[0] += luminance;
            cells[1 + 2 * usize::from(2 * y >= width) + usize::from(2 * x >= width)] +=
                4.0 * luminance;
        }
        for (cell, before) in self.before.iter_mut().enumerate() {
            let total = cells[cell] * passes / mean.values().len() as f64;
            self.values[cell].push(total - *before);
            *before = total;
        }
    }
}

impl Cells {
    /// Returns the picture with left for right.
    #[must_use]
    pub fn flipped(mut self) -> Self {
        self.values.swap(1, 2);
        self.values.swap(3, 4);
        self
    }

    /// Returns it so many times as bright.
    #[must_use]
    pub fn times(mut self, factor: f64) -> Self {
        self.values.iter_mut().flatten().for_each(|value| *value *= factor);
        self
    }

    /// Sums of independent renderings, pass by pass.
    #[must_use]
    pub fn plus(mut self, other: &Self) -> Self {
        for (values, others) in self.values.iter_mut().zip(&other.values) {
            values.iter_mut().zip(others).for_each(|(value, other)| *value += other);
        }
        self
    }
}
