//! From a command line to a picture.

use crate::aov::Aov;
use crate::aov_layers::aov_layers;
use crate::auto::planned;
use crate::black::{self, Picture};
use crate::command_line::CommandLine;
use crate::conclude::conclude;
use crate::done::Done;
use crate::drive::{Outcome, render_job};
use crate::end::End;
use crate::job::Job;
use crate::memory;
use crate::messages::{announce, describe, suggest, summarise};
use crate::options::RenderOptions;
use crate::outcome::Failure;
use crate::outputs::Outputs;
use crate::plan::Plan;
use crate::run_stats;
use crate::say::{say, tell, tell_name};
use crate::stats::stats;
use std::collections::BTreeMap;
use std::process::ExitCode;
use traylib_integrators::{Integrator, Method, Rendering, Report};
use traylib_io::{LoadOptions, Loaded, Look, builtin_names, load_scene_with};
use traylib_math::{Grid, Rgb};
use traylib_scene::Scene;

/// Runs the program of a method that has no options beside those of all.
pub fn render_by(plain: Method) -> ExitCode {
    let line = CommandLine::<()>::parse(plain);
    run(&Job::of(&line), |job, _| Ok(job.build(Report::None)), |_| Ok(()))
}

/// Loads, renders and saves with the integrator that `prepare` makes for the job, whose method
/// is settled by then, and the scene; then
/// hands everything to `finish`. Ends the program's `main`: prints what went wrong, a
/// panic included, and returns the exit status.
pub fn run(
    job: &Job<'_>,
    prepare: impl FnOnce(&Job<'_>, &Scene) -> Result<Box<dyn Integrator>, Failure>,
    finish: impl FnOnce(&Done) -> Result<(), Failure>,
) -> ExitCode {
    conclude(job.program, || try_run(job, prepare, finish))
}

fn try_run(
    job: &Job<'_>,
    prepare: impl FnOnce(&Job<'_>, &Scene) -> Result<Box<dyn Integrator>, Failure>,
    finish: impl FnOnce(&Done) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let options = job.options;
    if options.list {
        return builtin_names().iter().try_for_each(tell);
    }
    if !job.wants_picture && options.keep.checkpoint.is_some() {
        return Err(Failure::usage("--checkpoint keeps pictures; paths of a --pixel are not kept"));
    }
    if let Some(file) = options.stats.as_deref().filter(|_| options.check) {
        return stats(options, file);
    }
    let loaded = load(job)?;
    let (job, why) = planned(job, &loaded)?;
    let job = &job;
    let integrator = prepare(job, &loaded.scene)?;
    let integrator = integrator.as_ref();
    if !options.quiet {
        announce(job.program, &loaded, integrator, job.limits());
    }
    let plan = Plan::of(job, &loaded)?;
    memory::check(job, &loaded, &plan)?;
    let outputs = Outputs::of(job);
    outputs.check(loaded.scene.camera())?;
    if options.check {
        return tell(describe(&loaded.name, &loaded.scene));
    }
    outputs.make_folder()?;
    let Outcome { rendering, elapsed, end, before, display } =
        render_job(job, &loaded, integrator, &plan)?;
    let Rendering { film, notes, statistics } = rendering;
    let (passes, error) = (film.passes(), film.relative_error());
    let layers = if job.makes_pictures() { film.develop_layers() } else { BTreeMap::new() };
    let wants_variance = options.aov.contains(&Aov::Variance);
    let variance = wants_variance.then(|| film.variance_of_mean()).flatten();
    let variance = variance.map(|variance| variance.map(|&v| Rgb::from(v.map(|band| band as f32))));
    let mut done =
        Done { loaded, passes, error, variance, layers, notes, statistics, elapsed, before };
    if job.makes_pictures() {
        // A picture that just fits has no room for the film.
        let picture = film.into_picture();
        expose(&mut done, &picture, options);
        outputs.save(&picture, &done.info(job), &aov_layers(job, &done)?)?;
        finish(&done)?;
        if !options.quiet {
            warn_if_black(job, &done, integrator, &picture);
        }
    } else {
        options.keep.checkpoint.as_deref().map_or(Ok(()), tell_name)?;
    }
    options
        .stats
        .as_deref()
        .map_or(Ok(()), |file| run_stats::write(file, job, &done, end, why.as_ref()))?;
    if !options.quiet {
        summarise(job.program, &done, &end.words());
        suggest(options);
    }
    if let Some(display) = display {
        display.finish();
    }
    conclusion(end, options, &done)
}

/// Settles the exposure of a picture, if that was left to it.
fn expose(done: &mut Done, picture: &Grid<Rgb>, options: &RenderOptions) {
    let Some(exposure) = options.exposure else { return };
    let own = &mut done.loaded.settings.exposure;
    *own = exposure.of(picture, *own);
    if !options.quiet {
        exposure.tell(*own);
    }
}

/// Concludes a program that has written what it has.
fn conclusion(end: End, options: &RenderOptions, done: &Done) -> Result<(), Failure> {
    let passes = done.passes;
    match end {
        End::Interrupt(signal) => Err(Failure::interrupted(
            signal,
            format_args!("interrupted; what is written has {passes} spp"),
        )),
        End::Noise => Ok(()),
        End::Spp | End::TimeLimit | End::Memory => options.noise.map_or(Ok(()), |noise| {
            let error = done.error.map_or_else(|| "unknown".into(), |error| format!("{error:.3}"));
            Err(Failure::noisy(format_args!(
                "--noise {noise} is not reached: the error is {error} after {passes} spp; what is written has it"
            )))
        }),
    }
}

/// Nobody should have to guess why a picture is black.
fn warn_if_black(job: &Job<'_>, done: &Done, integrator: &dyn Integrator, radiance: &Grid<Rgb>) {
    if !job.wants_picture {
        return;
    }
    let (program, scene, limits) = (job.program, &done.loaded.scene, job.limits());
    let look = Look { exposure: done.loaded.settings.exposure, tone: job.options.tone };
    let picture = Picture { program, scene, integrator, limits, look, radiance };
    if let Some(reason) = black::reason(&picture, job.options) {
        say(format_args!("warning: the picture is black: {reason}"));
    }
}

/// The scene as the command line wants it.
fn load(job: &Job<'_>) -> Result<Loaded, Failure> {
    let load = LoadOptions { headlight: job.headlight, ..job.options.load_options() };
    let loaded = load_scene_with(&job.options.scene, load)?;
    let options = job.options;
    let scene = options.view.applied_to(loaded.scene, options.resolution)?;
    let scene = options.window.applied_to(scene)?;
    Ok(Loaded { scene, ..loaded })
}
