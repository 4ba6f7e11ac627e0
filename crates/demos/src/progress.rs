//! The line that moves while a picture is rendered.

use crate::messages::count;
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::time::{Duration, Instant};
use traylib_integrators::Progress;

/// A line on a terminal, cut to its width; nothing elsewhere.
pub(crate) struct Line {
    bar: ProgressBar,
    start: Instant,
    time_limit: Option<Duration>,
}

/// The film's error is asked for no more often than this.
const BETWEEN_UPDATES: Duration = Duration::from_millis(200);

impl Line {
    /// A line that starts with `title`; at the `time_limit` it will be late.
    pub(crate) fn new(title: &str, time_limit: Option<Duration>, quiet: bool) -> Self {
        let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::no_length() };
        if let Ok(style) = ProgressStyle::with_template("{prefix}  {gone} gone  {wide_msg}") {
            let gone = |state: &ProgressState, out: &mut dyn Write| {
                // The worst is a line without its clock.
                let _ = out.write_str(&clock(state.elapsed()));
            };
            bar.set_style(style.with_key("gone", gone));
        }
        bar.set_prefix(title.to_owned());
        if !bar.is_hidden() {
            // The clock runs on while a pass takes long.
            bar.enable_steady_tick(BETWEEN_UPDATES);
        }
        Self { bar, start: Instant::now(), time_limit }
    }

    /// Shows how far it is.
    pub(crate) fn update(&self, progress: &Progress<'_>, last: &mut Option<Instant>) {
        if self.bar.is_hidden() || last.is_some_and(|last| last.elapsed() < BETWEEN_UPDATES) {
            return;
        }
        *last = Some(Instant::now());
        self.bar.set_message(self.describe(progress));
    }

    /// What follows the clock.
    fn describe(&self, progress: &Progress<'_>) -> String {
        let elapsed = self.start.elapsed();
        let passes = progress.film.passes();
        let done = fraction_done(f64::from(passes), progress.spp, elapsed, self.time_limit);
        let left = clock(elapsed.mul_f64((1.0 / done - 1.0).clamp(0.0, LONGEST)));
        let percent = (100.0 * done) as u32;
        let of =
            if progress.spp == u32::MAX { String::new() } else { format!("/{}", progress.spp) };
        let rate = count((progress.statistics.rays() as f64 / elapsed.as_secs_f64()) as u64);
        let error = progress.film.relative_error();
        let error = error.map_or(String::new(), |e| format!("  err {:.2} %", 100.0 * e));
        format!("{left} left  {percent} %  {passes}{of} spp  {rate}ray/s{error}")
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

/// Factors on the time gone that say no more than "very long".
const LONGEST: f64 = 1e6;

/// How much of the work is done: of the passes or of the time, whichever ends
/// it first.
fn fraction_done(passes: f64, spp: u32, elapsed: Duration, limit: Option<Duration>) -> f64 {
    let of_time = limit.map_or(0.0, |limit| elapsed.as_secs_f64() / limit.as_secs_f64());
    (passes / f64::from(spp)).max(of_time).min(1.0)
}

/// Minutes and seconds, with hours where there are any.
pub fn clock(time: Duration) -> String {
    let seconds = time.as_secs();
    let (hours, minutes, seconds) = (seconds / 3600, seconds / 60 % 60, seconds % 60);
    if hours == 0 {
        format!("{minutes:02}:{seconds:02}")
    } else {
        format!("{hours}:{minutes:02}:{seconds:02}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_end_counts() {
        let (second, limit) = (Duration::from_secs(1), Some(Duration::from_secs(4)));
        assert_eq!(fraction_done(8.0, 16, second, None), 0.5);
        assert_eq!(fraction_done(8.0, 16, second, limit), 0.5);
        assert_eq!(fraction_done(1.0, 16, second, limit), 0.25);
        assert_eq!(fraction_done(1.0, u32::MAX, 5 * second, limit), 1.0);
    }

    #[test]
    fn clocks_show_hours_where_there_are_any() {
        assert_eq!(clock(Duration::from_millis(61_900)), "01:01");
        assert_eq!(clock(Duration::from_secs(36_001)), "10:00:01");
    }
}
