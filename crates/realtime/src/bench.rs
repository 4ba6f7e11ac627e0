//! Measures the speed without a window.

use crate::draw::Artist;
use crate::motion::Motion;
use crate::options::Options;
use crate::stage::Stage;
use crate::view::View;
use std::f32::consts::TAU;
use std::sync::Arc;
use std::time::Instant;
use traylib_demos::{Failure, count, on_interrupt, tell};
use traylib_integrators::Control;
use traylib_math::Vec2;

/// Draws so many frames of a turn around what is in the middle of the picture, and tells how
/// long that took. Every frame is whole, of one sample a pixel, and made ready for a window.
///
/// # Errors
/// The method is left to a plan, the system refuses threads, or standard output takes no more.
pub(crate) fn turn(stage: Stage, options: &Options, frames: u32) -> Result<(), Failure> {
    if options.method.auto().is_some() {
        let advice = "`--frames` measures one method: name one with `--method` in place of a plan";
        return Err(Failure::usage(advice));
    }
    let control = Arc::new(Control::default());
    let answer = Arc::clone(&control);
    let (sender, signals) = std::sync::mpsc::channel();
    on_interrupt(move |signal| {
        // Nobody is left to hear it only after the end.
        let _ = sender.send(signal);
        answer.cancel();
    });
    if !options.quiet {
        stage.announce(options.method)?;
    }
    let home = stage.loaded().scene.camera().settings();
    let mut view = View::new(home, options.method, stage.focus());
    let name = stage.loaded().name.clone();
    let mut artist = Artist::new(Arc::new(stage))?;
    let (mut rays, start) = (0, Instant::now());
    for _ in 0..frames {
        view.step(Motion::Orbit(Vec2::new(TAU / frames as f32, 0.0)));
        match artist.first_frame(&view.wanted(), 1, &control)? {
            Some(frame) => rays += frame.statistics.rays(),
            None => break,
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    if let Ok(signal) = signals.try_recv() {
        return Err(Failure::interrupted(signal, "interrupted"));
    }
    let (width, height) = (home.width, home.height);
    tell(format_args!(
        "{name} {width}x{height} {}: {frames} frames in {seconds:.3} s, {:.1} frames/s, {}ray/s",
        options.method,
        f64::from(frames) / seconds,
        count((rays as f64 / seconds) as u64),
    ))
}
