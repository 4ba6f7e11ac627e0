//! The line that moves while a picture is rendered.

use crate::messages::count;
use indicatif::{ProgressBar, ProgressStyle};
use std::time::{Duration, Instant};
use traylib_integrators::Progress;

/// A bar on a terminal; nothing elsewhere.
pub(crate) struct Line {
    bar: ProgressBar,
    start: Instant,
    time_limit: Option<Duration>,
    counts_time: bool,
}

/// The film's error is asked for no more often than this.
const BETWEEN_UPDATES: Duration = Duration::from_millis(200);

impl Line {
    /// A line for `spp` passes, or for a time where that alone ends the run.
    pub(crate) fn new(
        title: &str,
        spp: Option<u32>,
        time_limit: Option<Duration>,
        quiet: bool,
    ) -> Self {
        let counts_time = spp.is_none() && time_limit.is_some();
        let length = match (spp, time_limit) {
            (None, Some(limit)) => limit.as_millis() as u64,
            (spp, _) => u64::from(spp.unwrap_or(u32::MAX)),
        };
        let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(length) };
        let template = "{prefix}  [{bar:24}] {percent:>3} %  {elapsed} gone  {eta} left  {msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.set_prefix(title.to_owned());
        Self { bar, start: Instant::now(), time_limit, counts_time }
    }

    /// Shows how far it is.
    pub(crate) fn update(&self, progress: &Progress<'_>, last: &mut Option<Instant>) {
        if self.bar.is_hidden() || last.is_some_and(|last| last.elapsed() < BETWEEN_UPDATES) {
            return;
        }
        *last = Some(Instant::now());
        let elapsed = self.start.elapsed();
        let passes = u64::from(progress.film.passes());
        let done = if self.counts_time { elapsed.as_millis() as u64 } else { passes };
        self.bar.set_position(done);
        let rate = progress.statistics.rays() as f64 / elapsed.as_secs_f64();
        let error = progress.film.relative_error();
        let error = error.map_or(String::new(), |e| format!("  err {:.2} %", 100.0 * e));
        self.bar.set_message(format!("{passes} spp  {}ray/s{error}", count(rate as u64)));
    }

    /// Time since the start.
    pub(crate) fn elapsed(&self) -> Duration {
        self.start.elapsed()
    }

    /// Whether the time is up.
    pub(crate) fn is_late(&self) -> bool {
        self.time_limit.is_some_and(|limit| self.elapsed() >= limit)
    }

    /// Takes the line away.
    pub(crate) fn clear(&self) {
        self.bar.finish_and_clear();
    }
}
