//! Rendering until passes, time or memory are used up, or somebody interrupts.

use crate::checkpoint::Checkpoint;
use crate::done::Before;
use crate::end::End;
use crate::interrupt::Stop;
use crate::job::Job;
use crate::memory;
use crate::outcome::Failure;
use crate::plan::Plan;
use crate::progress::Line;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;
use traylib_integrators::{Integrator, Part, Progress, Rendering, Settings, render_part};
use traylib_io::Loaded;
use traylib_scene::Film;

/// What came of a job.
#[derive(Debug)]
pub(crate) struct Outcome {
    /// The film, and the counters of this run.
    pub(crate) rendering: Rendering,
    /// The time that it took.
    pub(crate) elapsed: Duration,
    /// What ended it.
    pub(crate) end: End,
    /// What was done before, if anything is kept.
    pub(crate) before: Option<Before>,
}

/// Renders: the film with at least one pass, if any is wanted.
///
/// # Errors
/// The system refuses threads, there is no pass, or the checkpoint does not fit or cannot be
/// written.
pub(crate) fn render_job(
    job: &Job<'_>,
    loaded: &Loaded,
    integrator: &dyn Integrator,
    plan: &Plan,
) -> Result<Outcome, Failure> {
    let options = job.options;
    let mut checkpoint = Checkpoint::of(job, loaded, plan);
    let film = match &mut checkpoint {
        Some(checkpoint) => checkpoint.begin(job, plan)?,
        None => None,
    };
    let before = checkpoint.as_ref().map(|checkpoint| Before {
        passes: film.as_ref().map_or(0, Film::passes),
        rejected: checkpoint.rejected_before(),
    });
    let title = format!("{} {}", job.program, loaded.name);
    let settings = Settings {
        spp: plan.passes.len() as u32,
        seed: options.seed,
        threads: options.threads,
        points: options.sampler,
    };
    let stop = Arc::new(Stop::default());
    let passes_before = before.unwrap_or_default().passes;
    let line = Line::new(&title, &stop, passes_before, options);
    stop.on_interrupt(line.answer_to_interrupt());
    options.time_limit.map_or(Ok(()), |time| stop.after(time))?;
    let (mut is_full, mut fault) = (false, None);
    let observe = &mut |progress: &Progress<'_>| {
        line.update(progress);
        if let Some(checkpoint) = &mut checkpoint {
            fault = checkpoint.after_pass(progress.film, progress.statistics).err();
        }
        is_full = !memory::has_room(job, loaded.scene.camera(), progress.film.passes());
        let is_over = is_full || fault.is_some();
        if is_over { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let part = Part { passes: plan.passes.clone(), film };
    let rendering = render_part(&loaded.scene, integrator, &settings, part, &stop.control, observe)
        .map_err(Failure::output)?;
    line.clear();
    if let Some(fault) = fault {
        return Err(fault);
    }
    let end = if rendering.film.passes() == settings.spp {
        End::Spp
    } else if is_full {
        End::Memory
    } else {
        stop.interrupted().map_or(End::TimeLimit, End::Interrupt)
    };
    if rendering.film.passes() == 0 && end != End::Spp {
        return Err(end.without_pass(stop.control.part_of_pass()));
    }
    if let Some(checkpoint) = &mut checkpoint {
        checkpoint.save(&rendering.film, rendering.statistics)?;
    }
    Ok(Outcome { rendering, elapsed: line.elapsed(), end, before })
}
