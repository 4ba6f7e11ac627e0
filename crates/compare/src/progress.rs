//! The line that tells how long the whole comparison still takes.

use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use traylib_demos::{clock, say};
use traylib_io::printable;

/// Time planned and time gone, over everything.
#[derive(Debug)]
pub struct Plan {
    bar: ProgressBar,
    total: f64,
    /// The time at which the work going on began, and the seconds left then.
    now: Arc<Mutex<(Instant, f64)>>,
}

impl Plan {
    /// A plan of so many seconds.
    pub fn new(total: f64) -> Self {
        let now = Arc::new(Mutex::new((Instant::now(), total)));
        let bar = ProgressBar::new((1000.0 * total) as u64);
        let template = "{prefix}  {bar:20} {left} left  {wide_msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            let shared = Arc::clone(&now);
            let left = move |_: &ProgressState, out: &mut dyn Write| {
                let (since, left) = *shared.lock().unwrap_or_else(PoisonError::into_inner);
                // The worst is a line without its clock.
                let _ = out.write_str(&clock(whole_seconds(left - since.elapsed().as_secs_f64())));
            };
            bar.set_style(style.with_key("left", left));
        }
        bar.enable_steady_tick(Duration::from_millis(200));
        Self { bar, total, now }
    }

    /// Says what begins; a line of its own where nobody watches a moving one.
    pub fn begin(&self, title: &str) {
        self.bar.set_prefix(printable(title).into_owned());
        if self.bar.is_hidden() {
            say(format_args!("{title}  {} left", clock(whole_seconds(self.left()))));
        }
    }

    /// Says what it is about.
    pub fn detail(&self, text: &str) {
        self.bar.set_message(printable(text).into_owned());
    }

    /// Counts so many of the planned seconds as done, by work or because they were found done.
    pub fn done(&self, seconds: f64) {
        let left = (self.left() - seconds).max(0.0);
        *self.now.lock().unwrap_or_else(PoisonError::into_inner) = (Instant::now(), left);
        self.bar.set_position((1000.0 * (self.total - left)) as u64);
    }

    /// Seconds left when the work that is going on began.
    fn left(&self) -> f64 {
        self.now.lock().unwrap_or_else(PoisonError::into_inner).1
    }

    /// Takes the line away.
    pub fn clear(&self) {
        self.bar.finish_and_clear();
    }
}

fn whole_seconds(seconds: f64) -> Duration {
    Duration::try_from_secs_f64(seconds.ceil()).unwrap_or_default()
}
