//! Rendering until passes, time or memory are used up, or somebody interrupts.

use crate::checkpoint::Checkpoint;
use crate::display::Display;
use crate::done::Before;
use crate::end::End;
use crate::interrupt::Stop;
use crate::job::Job;
use crate::memory;
use crate::noise::Noise;
use crate::options::RenderOptions;
use crate::outcome::Failure;
use crate::plan::Plan;
use crate::progress::Line;
use std::ops::{ControlFlow, Range};
use std::sync::Arc;
use std::time::Duration;
use traylib_integrators::{
    Control, Integrator, Progress, Renderer, Rendering, ThreadPool, thread_pool,
};
use traylib_io::Loaded;
use traylib_scene::Film;

/// The result of rendering a job.
#[derive(Debug)]
pub(crate) struct Outcome {
    /// The film, and the counters of this run.
    pub(crate) rendering: Rendering,
    /// The time that it took.
    pub(crate) elapsed: Duration,
    /// The event that ended it.
    pub(crate) end: End,
    /// The work of the runs before, if anything is kept.
    pub(crate) before: Option<Before>,
    /// The viewer that was sent the last picture, which it may not have yet.
    pub(crate) display: Option<Display>,
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
    let stop = Arc::new(Stop::default());
    let passes_before = before.unwrap_or_default().passes;
    let line = Line::new(&title, &stop, passes_before, options);
    stop.on_interrupt(line.answer_to_interrupt());
    options.time_limit.map_or(Ok(()), |time| stop.after(time))?;
    let display = open_display(job, loaded, &title, &line);
    let pool = thread_pool(options.threads).map_err(Failure::output)?;
    let mut renderer = Renderer::new(&loaded.scene, integrator, options.seed, options.sampler);
    if let Some(film) = film {
        renderer = renderer.going_on_from(film);
    }
    let (mut is_full, mut is_good) = (false, is_good_enough(options, &renderer.rendering().film));
    let wanted = if is_good { 0..0 } else { plan.passes.clone() };
    let spp = plan.passes.len() as u32;
    let after_pass = |Rendering { film, statistics, .. }: &Rendering| {
        line.update(&Progress { film, statistics: *statistics, spp });
        is_full = !memory::has_room(job, loaded.scene.camera(), film.passes());
        is_good = is_good_enough(options, film);
        if is_full || is_good { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let passes = Passes { wanted, pool: &pool, control: &stop.control, display: display.as_ref() };
    let done = passes.render(&mut renderer, checkpoint.as_mut(), after_pass);
    line.clear();
    done?;
    let rendering = renderer.finish();
    let end = if is_good {
        End::Noise
    } else if rendering.film.passes() == spp {
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
    let elapsed = line.elapsed();
    if let Some(display) = &display {
        display.show_now(&rendering.film);
    }
    Ok(Outcome { rendering, elapsed, end, before, display })
}

/// The viewer that is to show the picture, if one is wanted and there is a picture.
fn open_display(job: &Job<'_>, loaded: &Loaded, title: &str, line: &Line) -> Option<Display> {
    let address = job.options.display_server.as_ref().filter(|_| job.wants_picture)?;
    let camera = loaded.scene.camera();
    let size = (camera.width(), camera.height());
    Some(Display::open(address, title.to_owned(), size, line.warner()))
}

/// Tells whether a film has as little noise as is wanted, if it is asked for that now.
fn is_good_enough(options: &RenderOptions, film: &Film) -> bool {
    let is_enough =
        |noise: Noise| Noise::is_asked(film.passes()) && noise.allows(film.relative_error());
    options.noise.is_some_and(is_enough)
}

/// Passes to render.
struct Passes<'a> {
    wanted: Range<u32>,
    pool: &'a ThreadPool,
    control: &'a Control,
    display: Option<&'a Display>,
}

impl Passes<'_> {
    /// Renders those that the film lacks, in the order of their numbers, until `after_pass` says
    /// stop; a checkpoint that is due is written, and the picture is shown, while the next pass is
    /// rendered.
    ///
    /// # Errors
    /// The checkpoint cannot be written.
    fn render(
        self,
        renderer: &mut Renderer<'_>,
        mut checkpoint: Option<&mut Checkpoint<'_>>,
        mut after_pass: impl FnMut(&Rendering) -> ControlFlow<()>,
    ) -> Result<(), Failure> {
        let Self { wanted, pool, control, display } = self;
        for pass in wanted {
            let film = &renderer.rendering().film;
            if film.has_pass(pass) {
                continue;
            }
            let due = checkpoint.as_deref_mut().filter(|checkpoint| checkpoint.is_due(film));
            let mut kept = Ok(());
            let is_whole = renderer.render_pass_beside(pass, control, pool, |rendering| {
                if let Some(display) = display {
                    display.show(&rendering.film);
                }
                let Some(checkpoint) = due else { return };
                kept = checkpoint.save(&rendering.film, rendering.statistics);
                if kept.is_err() {
                    // Nobody wants what cannot be kept.
                    control.cancel();
                }
            });
            kept?;
            if !is_whole || after_pass(renderer.rendering()).is_break() {
                break;
            }
        }
        Ok(())
    }
}
