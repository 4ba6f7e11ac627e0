//! The window and the painter, brought together.

use crate::draw::Artist;
use crate::frame::Frame;
use crate::input::{Input, Press};
use crate::options::Options;
use crate::painter::Painter;
use crate::snapshot;
use crate::stage::Stage;
use crate::title::{Rates, TITLE_TIME, title};
use crate::view::View;
use crate::window::Window;
use std::sync::Arc;
use std::sync::mpsc::channel;
use std::time::Instant;
use traylib_demos::{Failure, Signal, on_interrupt, say, tell};
use traylib_io::check_writable;

/// Opens the window and shows the scene until somebody ends that.
///
/// # Errors
/// There is no display, threads are refused, or pictures could not be written.
pub(crate) fn show(stage: Stage, options: &Options) -> Result<(), Failure> {
    check_writable(&options.outfile)?;
    let (sender, signals) = channel();
    on_interrupt(move |signal| {
        // Nobody is left to hear it only after the end.
        let _ = sender.send(signal);
    });
    let name = stage.loaded().name.clone();
    let home = stage.loaded().scene.camera().settings();
    let view = View::new(home, options.method, stage.focus());
    let stage = Arc::new(stage);
    let painter = Painter::start(Artist::new(Arc::clone(&stage))?)?;
    // The first frame is drawn while the window opens.
    painter.order(view.wanted());
    let opened = Window::open(&format!("TrayLib {name}"), (home.width, home.height));
    let shown = opened.and_then(|window| {
        // Without a display there is one thing to say.
        if !options.quiet {
            stage.announce(options.method)?;
            say("keys: 1 to 6 methods, P prints the camera, F12 writes the picture, Escape ends; --help tells the others");
        }
        let mut live = Live {
            window,
            painter: &painter,
            view,
            name,
            options,
            frame: None,
            rates: Rates::default(),
            titled: None,
            wants_file: false,
        };
        live.run(|| signals.try_recv().ok())
    });
    // What went wrong there comes first: it is why there was nothing to show.
    painter.end().and(shown)
}

struct Live<'a> {
    window: Window,
    painter: &'a Painter,
    view: View,
    /// The scene's.
    name: String,
    options: &'a Options,
    /// The last.
    frame: Option<Frame>,
    rates: Rates,
    /// The time at which the title was last set.
    titled: Option<Instant>,
    /// True if the picture is to be written as soon as there is one.
    wants_file: bool,
}

/// The decision whether it goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Next {
    Look,
    End,
}

impl Live<'_> {
    /// Until the window is closed, or a signal asks for the end.
    fn run(&mut self, signal: impl Fn() -> Option<Signal>) -> Result<(), Failure> {
        while let Some(input) = self.window.input() {
            if let Some(signal) = signal() {
                return Err(Failure::interrupted(signal, "interrupted"));
            }
            if self.obey(&input)? == Next::End || self.painter.has_failed() {
                break;
            }
            let is_new = self.fetch();
            match &self.frame {
                Some(Frame { pixels, radiance, .. }) => {
                    let size = (radiance.width() as u32, radiance.height() as u32);
                    self.window.show(pixels, size, is_new)?;
                }
                None => self.window.show(&[0], (1, 1), false)?,
            }
        }
        Ok(())
    }

    /// Does what mouse and keyboard say.
    fn obey(&mut self, input: &Input) -> Result<Next, Failure> {
        let before = self.view.wanted();
        self.view.resize(input.size);
        for motion in input.motions() {
            self.view.step(motion);
        }
        for &press in &input.pressed {
            match press {
                Press::End => return Ok(Next::End),
                Press::Home => self.view.go_home(),
                Press::Print => tell(snapshot::camera_line(&self.view.wanted().camera))?,
                Press::Write => self.wants_file = true,
                Press::Method(_) | Press::Auto => {
                    press.method().into_iter().for_each(|method| self.view.render_by(method));
                }
            }
        }
        if self.view.wanted() != before {
            self.painter.order(self.view.wanted());
        }
        Ok(Next::Look)
    }

    /// Takes the newest frame, if there is one.
    fn fetch(&mut self) -> bool {
        let newest = self.painter.fetch();
        let is_new = newest.is_some();
        self.frame = newest.or_else(|| self.frame.take());
        let Some(frame) = &self.frame else { return false };
        if is_new {
            self.rates.add(frame);
        }
        if self.titled.is_none_or(|last| last.elapsed() >= TITLE_TIME)
            && let Some(rates) = self.rates.take()
        {
            self.window.set_title(&title(&self.name, frame, rates));
            self.titled = Some(Instant::now());
        }
        if self.wants_file && frame.is_of(&self.view.wanted()) {
            self.wants_file = false;
            let written = snapshot::write(frame, &self.name, self.view.is_moved(), self.options);
            // Whoever walks through a scene goes on without a picture of it.
            written.unwrap_or_else(say);
        }
        is_new
    }
}
