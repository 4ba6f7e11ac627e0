//! Draws what is wanted: first a preview if the picture takes long, then the picture, pass by
//! pass.

mod pace;

use crate::frame::Frame;
use crate::plan::planned;
use crate::screen::develop;
use crate::stage::Stage;
use crate::view::Wanted;
use pace::Pace;
use std::sync::Arc;
use std::time::{Duration, Instant};
use traylib_demos::Failure;
use traylib_integrators::{Control, Method, Renderer, Rendering, ThreadPool, thread_pool};
use traylib_scene::{Camera, CameraSettings};

/// Draws one view after the other.
#[derive(Debug)]
pub(crate) struct Artist {
    stage: Arc<Stage>,
    pool: ThreadPool,
    /// The method that was used last, and how fast it was.
    pace: (Method, Pace),
}

/// The time between showings of pictures that are being refined.
const BETWEEN_FRAMES: Duration = Duration::from_millis(30);

/// No more of the time than one part of this goes into showing them.
const SHARE: u32 = 4;

impl Artist {
    /// # Errors
    /// The system refuses the threads.
    pub(crate) fn new(stage: Arc<Stage>) -> Result<Self, Failure> {
        let threads = stage.options().threads;
        let pool = thread_pool(threads).map_err(Failure::output)?;
        let pace = (stage.options().method, Pace::default());
        Ok(Self { stage, pool, pace })
    }

    /// Draws until the picture is done or `is_stale` is cancelled, and hands over every frame.
    /// A quick picture is drawn whatever `is_stale` says, so that there is always something to see
    /// while the camera moves; `end` ends that, too.
    ///
    /// # Errors
    /// A scene that must be loaded for the method cannot be.
    pub(crate) fn draw(
        &mut self,
        wanted: &Wanted,
        is_stale: &Control,
        end: &Control,
        show: &mut dyn FnMut(Frame),
    ) -> Result<(), Failure> {
        if self.pace.0 != wanted.method {
            self.pace = (wanted.method, Pace::default());
        }
        let CameraSettings { width, height, .. } = wanted.camera;
        let mut coarseness = self.pace.1.coarseness(width, height);
        if wanted.method.auto().is_some() {
            // Something is to be seen while it is planned.
            coarseness = coarseness.max(2);
        }
        let first = if coarseness == 1 { end } else { is_stale };
        if coarseness > 1
            && let Some(preview) = self.first_frame(wanted, coarseness, end)?
        {
            show(preview);
        }
        match planned(&self.stage, wanted, is_stale)? {
            Some(method) => self.refine(wanted, method, [first, is_stale], show),
            None => Ok(()),
        }
    }

    /// The first pass, with so many pixels of the window drawn as one in each direction; `None`
    /// if `control` was cancelled.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub(crate) fn first_frame(
        &mut self,
        wanted: &Wanted,
        coarseness: u32,
        control: &Control,
    ) -> Result<Option<Frame>, Failure> {
        let mut frame = None;
        let mut show = |drawn| frame = Some(drawn);
        self.passes((wanted, wanted.method), coarseness, 1, [control; 2], &mut show)?;
        Ok(frame)
    }

    fn refine(
        &mut self,
        wanted: &Wanted,
        method: Method,
        controls: [&Control; 2],
        show: &mut dyn FnMut(Frame),
    ) -> Result<(), Failure> {
        let passes = self.stage.options().passes(method);
        self.passes((wanted, method), 1, passes, controls, show)
    }

    /// Draws so many passes by this method; the first of them as the first control says, the
    /// others as the second.
    fn passes(
        &mut self,
        (wanted, method): (&Wanted, Method),
        coarseness: u32,
        passes: u32,
        [first, others]: [&Control; 2],
        show: &mut dyn FnMut(Frame),
    ) -> Result<(), Failure> {
        let start = Instant::now();
        let loaded = self.stage.of(method)?;
        // Whoever wants it has made sure that there is a view.
        let camera = camera(wanted, coarseness).map_err(Failure::scene)?;
        let (scene, integrator) = (loaded.scene.seen_by(camera), method.build());
        let options = self.stage.options();
        let mut picture = Picture {
            wanted,
            method,
            coarseness,
            size: (camera.width(), camera.height()),
            exposure: loaded.settings.exposure,
            renderer: Renderer::new(&scene, &*integrator, options.seed, options.sampler),
            start,
        };
        let (mut shown, mut showing) = (start, Duration::ZERO);
        for pass in 0..passes {
            let begin = Instant::now();
            let control = if pass == 0 { first } else { others };
            if !self.pool.install(|| picture.renderer.render_pass(pass, control)) {
                return Ok(());
            }
            let done = Instant::now();
            let between = BETWEEN_FRAMES.max(showing * SHARE);
            if pass == 0 || pass + 1 == passes || done - shown >= between {
                show(self.pool.install(|| picture.develop()));
                shown = Instant::now();
                showing = shown - done;
            }
            if pass == 0 {
                self.pace.1.measure(scene.camera(), begin.elapsed());
            }
        }
        Ok(())
    }
}

/// The picture that is being drawn.
struct Picture<'a> {
    wanted: &'a Wanted,
    method: Method,
    coarseness: u32,
    size: (u32, u32),
    exposure: f32,
    renderer: Renderer<'a>,
    start: Instant,
}

impl Picture<'_> {
    fn develop(&self) -> Frame {
        let Rendering { film, statistics, .. } = self.renderer.rendering();
        let (radiance, pixels) = develop(film, self.size, self.exposure);
        Frame {
            wanted: *self.wanted,
            method: self.method,
            coarseness: self.coarseness,
            pixels,
            radiance,
            exposure: self.exposure,
            passes: film.passes(),
            error: film.relative_error(),
            statistics: *statistics,
            seconds: self.start.elapsed().as_secs_f64(),
        }
    }
}

/// The camera, with so many pixels as one in each direction.
fn camera(wanted: &Wanted, coarseness: u32) -> Result<Camera, traylib_scene::Error> {
    let CameraSettings { width, height, .. } = wanted.camera;
    let (width, height) = (width.div_ceil(coarseness), height.div_ceil(coarseness));
    Camera::new(CameraSettings { width, height, ..wanted.camera })
}

#[cfg(test)]
mod tests;
