//! From a command line to a picture.

use crate::VERSION;
use crate::black::{self, Picture};
use crate::bug::report_bugs;
use crate::command_line::CommandLine;
use crate::interrupt::{self, Stop};
use crate::memory;
use crate::messages::{announce, describe, say, suggest, summarise, tell, tell_name};
use crate::options::RenderOptions;
use crate::outcome::Failure;
use crate::progress::Line;
use crate::recipe;
use crate::signals::Signal;
use crate::stats::stats;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::time::Duration;
use traylib_integrators::{
    Integrator, Limits, Method, Progress, Rendering, Settings, Statistics, render,
};
use traylib_io::{
    Headlight, LoadOptions, Loaded, PictureInfo, check_file, check_picture, load_scene_with,
    save_picture,
};
use traylib_math::{Grid, Rgb};
use traylib_scene::{Camera, Scene};

/// What a program was asked to do.
#[derive(Debug)]
pub struct Job<'a> {
    /// The program's name.
    pub program: &'static str,
    /// Options that all programs have.
    pub options: &'a RenderOptions,
    /// What it renders by; `None` for an integrator that is no method.
    pub method: Option<Method>,
    /// Samples a pixel where the command line names none; `None` for the
    /// scene's number.
    pub default_spp: Option<u32>,
    /// Whether a picture is wanted, or only what `finish` makes of it.
    pub wants_picture: bool,
    /// When a model is lit from the camera; of what is only checked, if nothing in it
    /// emits light.
    pub headlight: Headlight,
    /// A folder for what `finish` writes.
    pub folder: Option<&'a Path>,
    /// How many pictures beside the picture there may be, to find out beforehand whether
    /// there is memory for them.
    pub layers: u64,
}

impl<'a> Job<'a> {
    /// The usual: a picture.
    pub fn new(program: &'static str, options: &'a RenderOptions) -> Self {
        Self {
            program,
            options,
            method: None,
            default_spp: None,
            wants_picture: true,
            headlight: Headlight::Never,
            folder: None,
            layers: 0,
        }
    }

    /// A picture by the method of a command line.
    pub fn of<O>(line: &'a CommandLine<O>) -> Self {
        let CommandLine { render, method, .. } = line;
        Self { method: Some(*method), ..Self::new(method.name(), render) }
    }

    /// The limits on its paths.
    fn limits(&self) -> Limits {
        self.method.and_then(Method::limits).unwrap_or_default()
    }

    /// How many passes are asked for; `None` if it is the time that ends them.
    pub(crate) fn spp(&self, loaded: &Loaded) -> Option<u32> {
        let default = self.default_spp.unwrap_or(loaded.settings.spp);
        self.options.spp.or(self.options.time_limit.is_none().then_some(default))
    }
}

/// What came of a job.
#[derive(Debug)]
pub struct Done {
    /// The scene and its settings.
    pub loaded: Loaded,
    /// How many passes there are.
    pub passes: u32,
    /// The picture's own estimate of its relative error.
    pub error: Option<f64>,
    /// Further pictures, by number.
    pub layers: BTreeMap<u16, Grid<Rgb>>,
    /// Text that was asked for.
    pub notes: Vec<String>,
    /// Tally of the work.
    pub statistics: Statistics,
    /// Time that it took.
    pub elapsed: Duration,
}

/// Runs the program of a method that has no options beside those of all.
pub fn render_by(plain: Method) -> ExitCode {
    let line = CommandLine::<()>::parse(plain);
    run(&Job::of(&line), |_| Ok(line.method.build()), |_| Ok(()))
}

/// Loads, renders and saves with the integrator that `prepare` makes for the scene, then
/// hands everything to `finish`. Ends the program's `main`: prints what went wrong, a
/// panic included, and returns the exit status.
pub fn run(
    job: &Job<'_>,
    prepare: impl FnOnce(&Scene) -> Result<Box<dyn Integrator>, Failure>,
    finish: impl FnOnce(&Done) -> Result<(), Failure>,
) -> ExitCode {
    conclude(job.program, || try_run(job, prepare, finish))
}

/// Does the work of a program, prints what went wrong, a panic included, and
/// returns the exit status. Whoever asks for the end meanwhile is heard
/// ([`on_interrupt`](crate::on_interrupt)).
pub fn conclude(program: &'static str, work: impl FnOnce() -> Result<(), Failure>) -> ExitCode {
    interrupt::listen();
    match report_bugs(program, work) {
        Some(Ok(())) => ExitCode::SUCCESS,
        Some(Err(failure)) => {
            say(&failure);
            failure.code()
        }
        None => ExitCode::from(Failure::BUG),
    }
}

fn try_run(
    job: &Job<'_>,
    prepare: impl FnOnce(&Scene) -> Result<Box<dyn Integrator>, Failure>,
    finish: impl FnOnce(&Done) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let options = job.options;
    if let Some(file) = &options.stats {
        return stats(options, file);
    }
    let loaded = load(job)?;
    let integrator = prepare(&loaded.scene)?;
    let integrator = integrator.as_ref();
    if !options.quiet {
        announce(job.program, &loaded, integrator, job.limits());
    }
    memory::check(job, &loaded)?;
    let outfiles = outfiles(job);
    check_outputs(&outfiles, job.folder, loaded.scene.camera())?;
    if options.check {
        return tell(describe(&loaded.name, &loaded.scene));
    }
    make_folder(job.folder)?;
    let (rendering, elapsed, end) = render_job(job, &loaded, integrator)?;
    let Rendering { film, notes, statistics } = rendering;
    let (passes, error, layers) = (film.passes(), film.relative_error(), film.develop_layers());
    let done = Done { loaded, passes, error, layers, notes, statistics, elapsed };
    // A picture that just fits has no room for the film.
    let picture = film.into_picture();
    for file in &outfiles {
        save_picture(file, &picture, &done.info(job))?;
        tell_name(file)?;
    }
    finish(&done)?;
    if !options.quiet {
        warn_if_black(job, &done, integrator, &picture);
        summarise(job.program, &done, &end.words());
        suggest(options);
    }
    match end {
        End::Interrupt(signal) => Err(Failure::interrupted(
            signal,
            format_args!("interrupted; what is written has {} spp", done.passes),
        )),
        End::Spp | End::TimeLimit | End::Memory => Ok(()),
    }
}

/// Nobody should have to guess why a picture is black.
fn warn_if_black(job: &Job<'_>, done: &Done, integrator: &dyn Integrator, radiance: &Grid<Rgb>) {
    if !job.wants_picture {
        return;
    }
    let (program, scene, limits) = (job.program, &done.loaded.scene, job.limits());
    let exposure = done.loaded.settings.exposure;
    let picture = Picture { program, scene, integrator, limits, exposure, radiance };
    if let Some(reason) = black::reason(&picture, job.options) {
        say(format_args!("warning: the picture is black: {reason}"));
    }
}

/// The scene as the command line wants it.
fn load(job: &Job<'_>) -> Result<Loaded, Failure> {
    let load = LoadOptions { headlight: job.headlight, ..job.options.load_options() };
    Ok(load_scene_with(&job.options.scene, load)?)
}

fn outfiles(job: &Job<'_>) -> Vec<PathBuf> {
    if !job.wants_picture {
        Vec::new()
    } else if job.options.outfile.is_empty() {
        vec![PathBuf::from(format!("{}.png", job.program))]
    } else {
        job.options.outfile.clone()
    }
}

/// Finds out before the work whether its result can be kept.
fn check_outputs(
    outfiles: &[PathBuf],
    folder: Option<&Path>,
    camera: &Camera,
) -> Result<(), Failure> {
    for file in outfiles {
        check_picture(file, camera.width(), camera.height())?;
    }
    let Some(folder) = folder else { return Ok(()) };
    // What is not there yet will be made, where the first folder above it is.
    let above = folder.ancestors().find(|above| above.exists()).unwrap_or(Path::new(""));
    check_file(&above.join(".any")).map_err(|_| {
        Failure::output(format_args!(
            "{}: cannot be written to: {} takes no files",
            folder.display(),
            if above == Path::new("") { Path::new(".") } else { above }.display(),
        ))
    })
}

fn make_folder(folder: Option<&Path>) -> Result<(), Failure> {
    let Some(folder) = folder else { return Ok(()) };
    std::fs::create_dir_all(folder).map_err(|error| {
        Failure::output(format_args!("{}: cannot be made: {error}", folder.display()))
    })
}

/// What ended a rendering.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Spp,
    TimeLimit,
    /// None is left for another pass.
    Memory,
    Interrupt(Signal),
}

impl End {
    fn words(self) -> String {
        match self {
            Self::Spp => "--spp".into(),
            Self::TimeLimit => "--time-limit".into(),
            Self::Memory => "lack of memory for more".into(),
            Self::Interrupt(signal) => signal.to_string(),
        }
    }

    /// Why nothing is written: it came when this part of the first pass was done.
    fn without_picture(self, part: f64) -> Failure {
        let percent = (100.0 * part) as u32;
        let nothing = format!("the first pass was done to {percent} %; nothing is written");
        match self {
            Self::Interrupt(signal) => {
                Failure::interrupted(signal, format_args!("interrupted while {nothing}"))
            }
            Self::Spp | Self::TimeLimit | Self::Memory => Failure::output(format_args!(
                "the time was up while {nothing}; a smaller --resolution or a longer --time-limit may help"
            )),
        }
    }
}

fn render_job(
    job: &Job<'_>,
    loaded: &Loaded,
    integrator: &dyn Integrator,
) -> Result<(Rendering, Duration, End), Failure> {
    let options = job.options;
    let title = format!("{} {}", job.program, loaded.name);
    let settings = Settings {
        spp: job.spp(loaded).unwrap_or(u32::MAX),
        seed: options.seed,
        threads: options.threads,
    };
    let stop = Arc::new(Stop::default());
    let line = Line::new(&title, &stop, options.time_limit, options.quiet);
    stop.on_interrupt(line.answer_to_interrupt());
    options.time_limit.map_or(Ok(()), |time| stop.after(time))?;
    let mut is_full = false;
    let observe = &mut |progress: &Progress<'_>| {
        line.update(progress);
        is_full = !memory::has_room(job, loaded.scene.camera(), progress.film.passes());
        if is_full { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let rendering = render(&loaded.scene, integrator, &settings, &stop.control, observe)
        .map_err(Failure::output)?;
    line.clear();
    let end = if rendering.film.passes() == settings.spp {
        End::Spp
    } else if is_full {
        End::Memory
    } else {
        stop.interrupted().map_or(End::TimeLimit, End::Interrupt)
    };
    if rendering.film.passes() == 0 {
        return Err(end.without_picture(stop.control.part_of_pass()));
    }
    Ok((rendering, line.elapsed(), end))
}

impl Done {
    /// What a picture of this job says of itself.
    pub fn info(&self, job: &Job<'_>) -> PictureInfo {
        PictureInfo {
            exposure: self.loaded.settings.exposure,
            program: format!("TrayLib {VERSION}"),
            integrator: job.program.into(),
            command: recipe::command(job, &self.loaded, self.passes),
            scene: self.loaded.name.clone(),
            seed: job.options.seed,
            spp: u64::from(self.passes),
            seconds: self.elapsed.as_secs_f64(),
            rejected_samples: self.statistics.rejected,
        }
    }
}
