//! Rendering until passes, time or memory are used up, or somebody interrupts.

use crate::end::End;
use crate::interrupt::Stop;
use crate::job::Job;
use crate::memory;
use crate::outcome::Failure;
use crate::progress::Line;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::Duration;
use traylib_integrators::{Integrator, Progress, Rendering, Settings, render};
use traylib_io::Loaded;

/// Renders: the film with at least one pass, the time it took, and what ended it.
///
/// # Errors
/// The system refuses threads, or there is no pass.
pub(crate) fn render_job(
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
        points: options.sampler,
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
