//! The picture in a viewer while it is rendered: one that is told by TCP what tev is told.
//!
//! A thread of its own sends, and what it sends is a copy: however slow the viewer is, the
//! rendering neither waits nor changes. Packets are made here, since the client library that
//! there is for them (`tev_client` 0.5.2 of 2022) has no vector graphics and panics where sizes
//! do not fit.

mod address;
mod mailbox;
mod packet;
mod tiles;

pub use address::DisplayAddress;

use mailbox::Mailbox;
use std::cell::Cell;
use std::io::{ErrorKind, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};
use tiles::Tile;
use traylib_math::{Grid, Rgb};
use traylib_scene::Film;

/// Pictures are sent no more often than this,
const BETWEEN_PICTURES: Duration = Duration::from_millis(500);

/// and so many times what it takes to make one lies between them: for a few per cent of one
/// processor.
const TIMES_COST: u32 = 20;

/// A viewer that takes nothing for so long is given up, and the end waits no longer.
const PATIENCE: Duration = Duration::from_secs(5);

/// A viewer to which pictures are sent.
#[derive(Debug)]
pub(crate) struct Display {
    link: Arc<Link>,
    /// The time at which the last picture was made, and how long that took.
    last: Cell<Option<(Instant, Duration)>>,
    /// Ends when the thread that sends does.
    thread: Receiver<()>,
}

/// What the rendering and the thread that sends have in common.
struct Link {
    address: DisplayAddress,
    mailbox: Mailbox<Frame>,
    warn: Box<dyn Fn(&str) + Send + Sync>,
}

/// A picture, and the boxes on it.
#[derive(Debug)]
struct Frame {
    picture: Grid<Rgb>,
    boxes: Vec<Tile>,
}

impl Display {
    /// Begins to send to a viewer pictures of this name and size, and hands a line to `warn` if
    /// that fails: from any thread, and once at most.
    pub(crate) fn open(
        address: &DisplayAddress,
        name: String,
        (width, height): (u32, u32),
        warn: impl Fn(&str) + Send + Sync + 'static,
    ) -> Self {
        let (address, warn) = (address.clone(), Box::new(warn));
        let link = Arc::new(Link { address, mailbox: Mailbox::new(), warn });
        let (running, thread) = channel::<()>();
        let sender = Arc::clone(&link);
        let send = move || {
            let _running = running;
            if let Err(error) = sender.send(&name, width as usize, height as usize) {
                sender.give_up(&describe(&error));
            }
        };
        if let Err(error) = thread::Builder::new().name("display".into()).spawn(send) {
            link.give_up(&format!("cannot start a thread: {error}"));
        }
        Self { link, last: Cell::new(None), thread }
    }

    /// Shows the picture of a film, unless there is none or one was shown shortly before.
    pub(crate) fn show(&self, film: &Film) {
        let recently = |(last, took): (Instant, Duration)| {
            last.elapsed() < BETWEEN_PICTURES.max(took * TIMES_COST)
        };
        if film.passes() > 0 && !self.last.get().is_some_and(recently) {
            self.show_now(film);
        }
    }

    /// Shows the picture of a film.
    pub(crate) fn show_now(&self, film: &Film) {
        if self.link.mailbox.is_attended() {
            let begin = Instant::now();
            let boxes = film.variance_of_mean().map_or(Vec::new(), |grid| tiles::worst(&grid));
            self.link.mailbox.put(Frame { picture: film.develop(), boxes });
            self.last.set(Some((Instant::now(), begin.elapsed())));
        }
    }

    /// Waits until the last picture is sent, for some seconds at most.
    pub(crate) fn finish(self) {
        self.link.mailbox.close();
        match self.thread.recv_timeout(PATIENCE) {
            Ok(()) | Err(RecvTimeoutError::Disconnected) => {}
            Err(RecvTimeoutError::Timeout) => {
                let seconds = PATIENCE.as_secs();
                self.link.give_up(&format!("it took less than all of the last one in {seconds} s"));
            }
        }
    }
}

impl Link {
    /// Sends what is put into the mailbox, to its end.
    fn send(&self, name: &str, width: usize, height: usize) -> std::io::Result<()> {
        let mut stream = self.connect()?;
        stream.set_write_timeout(Some(PATIENCE))?;
        stream.write_all(&packet::create(name, width, height))?;
        while let Some(Frame { picture, boxes }) = self.mailbox.take() {
            for update in packet::updates(name, &picture) {
                stream.write_all(&update)?;
            }
            stream.write_all(&packet::boxes(name, &boxes))?;
        }
        Ok(())
    }

    /// Connects with the first address of the host that answers.
    fn connect(&self) -> std::io::Result<TcpStream> {
        let mut last = ErrorKind::AddrNotAvailable.into();
        for address in (self.address.host.as_str(), self.address.port).to_socket_addrs()? {
            match TcpStream::connect_timeout(&address, PATIENCE) {
                Ok(stream) => return Ok(stream),
                Err(error) => last = error,
            }
        }
        Err(last)
    }

    /// Ends it, and says so if that was not said before.
    fn give_up(&self, why: &str) {
        if self.mailbox.leave() {
            (self.warn)(&format!(
                "--display-server {}: the picture is not shown there: {why}",
                self.address
            ));
        }
    }
}

impl std::fmt::Debug for Link {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Link").field("address", &self.address).finish_non_exhaustive()
    }
}

fn describe(error: &std::io::Error) -> String {
    // Systems call it either.
    let is_late = matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut);
    if is_late {
        format!("it takes nothing for {} s", PATIENCE.as_secs())
    } else {
        error.to_string()
    }
}
