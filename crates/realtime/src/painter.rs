//! A thread that draws, so that nobody waits for it.

use crate::draw::Artist;
use crate::frame::Frame;
use crate::view::Wanted;
use std::panic::resume_unwind;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use traylib_demos::Failure;
use traylib_integrators::Control;

/// A thread that draws what was wanted last.
#[derive(Debug)]
pub(crate) struct Painter {
    desk: Arc<Desk>,
    thread: JoinHandle<Result<(), Failure>>,
}

/// The exchange of orders and frames.
#[derive(Debug, Default)]
struct Desk {
    papers: Mutex<Papers>,
    /// There is an order.
    ordered: Condvar,
    /// The sign that nothing more is wanted at all.
    end: Control,
}

#[derive(Debug, Default)]
struct Papers {
    /// An order that was not begun, and how it is called off.
    order: Option<(Wanted, Arc<Control>)>,
    /// The control that calls off the order that was begun.
    begun: Arc<Control>,
    /// The newest frame that nobody has fetched.
    frame: Option<Frame>,
}

impl Painter {
    /// Starts the thread.
    ///
    /// # Errors
    /// The system refuses it.
    pub(crate) fn start(mut artist: Artist) -> Result<Self, Failure> {
        let desk = Arc::<Desk>::default();
        let own = Arc::clone(&desk);
        let paint = move || {
            while let Some((wanted, is_stale)) = own.next_order() {
                let mut show = |frame| own.papers().frame = Some(frame);
                artist.draw(&wanted, &is_stale, &own.end, &mut show)?;
            }
            Ok(())
        };
        let thread = thread::Builder::new().name("painter".into()).spawn(paint);
        let thread = thread
            .map_err(|error| Failure::output(format_args!("cannot start a thread: {error}")))?;
        Ok(Self { desk, thread })
    }

    /// Wants this from now on, and nothing else.
    pub(crate) fn order(&self, wanted: Wanted) {
        let mut papers = self.desk.papers();
        papers.begun.cancel();
        papers.order = Some((wanted, Arc::default()));
        self.desk.ordered.notify_one();
    }

    /// The newest frame, if there is one that was not fetched.
    pub(crate) fn fetch(&self) -> Option<Frame> {
        self.desk.papers().frame.take()
    }

    /// Tells whether there will be no more frames, as [`end`](Self::end) tells why.
    pub(crate) fn has_failed(&self) -> bool {
        self.thread.is_finished()
    }

    /// Ends the thread, at once.
    ///
    /// # Errors
    /// Returns the failure of the thread.
    pub(crate) fn end(self) -> Result<(), Failure> {
        self.desk.end.cancel();
        let papers = self.desk.papers();
        papers.begun.cancel();
        self.desk.ordered.notify_one();
        drop(papers);
        self.thread.join().unwrap_or_else(|panic| resume_unwind(panic))
    }
}

impl Desk {
    /// Waits for an order; `None` at the end.
    fn next_order(&self) -> Option<(Wanted, Arc<Control>)> {
        let is_idle = |papers: &mut Papers| papers.order.is_none() && !self.end.is_cancelled();
        let papers = self.ordered.wait_while(self.papers(), is_idle);
        let mut papers = papers.unwrap_or_else(PoisonError::into_inner);
        if self.end.is_cancelled() {
            return None;
        }
        let (wanted, control) = papers.order.take()?;
        papers.begun = Arc::clone(&control);
        Some((wanted, control))
    }

    fn papers(&self) -> MutexGuard<'_, Papers> {
        self.papers.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::options::Options;
    use crate::stage::Stage;
    use clap::Parser;
    use std::time::{Duration, Instant};
    use traylib_integrators::Method;

    /// With a limit that only a thread that hangs would reach.
    fn wait<T>(mut found: impl FnMut() -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            if let Some(found) = found() {
                return found;
            }
            assert!(start.elapsed() < Duration::from_mins(1));
            thread::sleep(Duration::from_millis(1));
        }
    }

    /// A picture that takes for ever, and then one that does not.
    #[test]
    fn a_new_order_calls_off_the_last_one_and_the_end_does_at_once() {
        let options = Options::parse_from(["realtime", "cornell", "--resolution", "2000x1500"]);
        let stage = Stage::load(&options).unwrap();
        let camera = stage.loaded().scene.camera().settings();
        let painter = Painter::start(Artist::new(Arc::new(stage)).unwrap()).unwrap();
        let slow = Wanted { camera, method: Method::BDPT };
        painter.order(slow);
        let preview = wait(|| painter.fetch());
        assert!(preview.coarseness > 1 && preview.wanted == slow);
        let mut quick = Wanted { method: Method::TRACE, ..slow };
        (quick.camera.width, quick.camera.height) = (8, 6);
        painter.order(quick);
        let frame = wait(|| painter.fetch().filter(|frame| frame.is_of(&quick)));
        assert_eq!((frame.radiance.width(), frame.passes), (8, 1));
        painter.order(slow);
        assert!(!painter.has_failed());
        painter.end().unwrap();
    }
}
