//! The line that moves while a picture is rendered.

use crate::interrupt::Stop;
use crate::options::RenderOptions;
use crate::progress_form::ProgressForm;
use crate::say::{count, say, say_line, tell, tell_json};
use crate::signals::Signal;
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use serde_json::json;
use std::cell::Cell;
use std::fmt::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};
use std::time::{Duration, Instant};
use traylib_integrators::Progress;
use traylib_io::printable;

/// A line on a terminal, cut to its width; nothing elsewhere.
pub(crate) struct Line {
    bar: ProgressBar,
    start: Instant,
    time_limit: Option<Duration>,
    /// Passes of runs before.
    before: u32,
    quiet: bool,
    last_update: Cell<Option<Instant>>,
    last_pass: Arc<LastPass>,
    form: ProgressForm,
    /// The time at which a program that listens was last told.
    last_told: Cell<Option<Instant>>,
}

/// The pass that was done last, as the line's own thread sees it.
#[derive(Default)]
struct LastPass {
    number: AtomicU32,
    /// The time at which it was done, in milliseconds since the start.
    end: AtomicU64,
}

/// The film's error is asked for no more often than this.
const BETWEEN_UPDATES: Duration = Duration::from_millis(200);

/// A program that listens is told no more often than this.
const BETWEEN_LINES: Duration = Duration::from_secs(1);

/// The progress of a single pass is shown if the pass takes longer than this.
const LONG_PASS: Duration = Duration::from_secs(1);

impl Line {
    /// A line that starts with `title`, about a rendering that `stop` can end, and
    /// that ends as the options say; so many passes were done `before`.
    pub(crate) fn new(title: &str, stop: &Arc<Stop>, before: u32, options: &RenderOptions) -> Self {
        let RenderOptions { quiet, time_limit, progress: form, .. } = *options;
        let bar = if quiet || form != ProgressForm::Line {
            ProgressBar::hidden()
        } else {
            ProgressBar::no_length()
        };
        let last_pass = Arc::new(LastPass { number: before.into(), ..LastPass::default() });
        if let Ok(style) = ProgressStyle::with_template("{prefix}  {gone} gone{pass}  {wide_msg}") {
            // The worst is a line without its clock.
            let gone = |state: &ProgressState, out: &mut dyn Write| {
                let _ = out.write_str(&clock(state.elapsed()));
            };
            let (stop, last) = (Arc::clone(stop), Arc::clone(&last_pass));
            let pass = move |state: &ProgressState, out: &mut dyn Write| {
                let part = stop.control.part_of_pass();
                let _ = out.write_str(&last.describe_next(state.elapsed(), part));
            };
            bar.set_style(style.with_key("gone", gone).with_key("pass", pass));
        }
        bar.set_prefix(printable(title).into_owned());
        if !bar.is_hidden() {
            // The clock runs on while a pass takes long.
            bar.enable_steady_tick(BETWEEN_UPDATES);
        }
        let last_update = Cell::new(None);
        Self {
            bar,
            start: Instant::now(),
            time_limit,
            before,
            quiet,
            last_update,
            last_pass,
            form,
            last_told: Cell::default(),
        }
    }

    /// Shows how far it is after a pass.
    pub(crate) fn update(&self, progress: &Progress<'_>) {
        if self.form != ProgressForm::Line {
            self.tell_program(progress);
        }
        let recently = |last: Instant| last.elapsed() < BETWEEN_UPDATES;
        self.last_pass.number.store(progress.film.passes(), Ordering::Relaxed);
        self.last_pass.end.store(self.elapsed().as_millis() as u64, Ordering::Relaxed);
        if self.bar.is_hidden() || self.last_update.get().is_some_and(recently) {
            return;
        }
        self.bar.set_message(self.describe(progress));
        // What it takes to tell is not counted.
        self.last_update.set(Some(Instant::now()));
    }

    fn tell_program(&self, progress: &Progress<'_>) {
        let passes = progress.film.passes();
        let recently = |last: Instant| last.elapsed() < BETWEEN_LINES;
        if passes < progress.spp && self.last_told.get().is_some_and(recently) {
            return;
        }
        self.last_told.set(Some(Instant::now()));
        let elapsed = self.elapsed();
        let done = fraction_done(f64::from(passes), progress.spp, elapsed, self.time_limit);
        let (percent, left) = (100.0 * done, self.time_left(progress, elapsed));
        // Who does not listen need not.
        let _ = match self.form {
            ProgressForm::Line => Ok(()),
            // With names as Hydra's render delegates have them.
            ProgressForm::Json => tell_json(
                &json!({
                    "percentDone": percent,
                    "totalClockTime": elapsed.as_secs_f64(),
                    "secondsLeft": left.as_secs_f64(),
                    "spp": passes,
                    "relativeError": progress.film.relative_error(),
                })
                .to_string(),
            ),
            // As `https://github.com/OpenJobDescription` wants it, in "How Jobs Are Run".
            ProgressForm::Openjd => {
                tell(format_args!("openjd_progress: {percent:.1}")).and_then(|()| {
                    let left = clock(left);
                    tell(format_args!("openjd_status: {passes} spp are done, {left} left"))
                })
            }
        };
    }

    fn time_left(&self, progress: &Progress<'_>, elapsed: Duration) -> Duration {
        let now = f64::from(progress.film.passes() - self.before);
        let wanted = f64::from(progress.spp - self.before.min(progress.spp));
        time_left(now, wanted, elapsed, self.time_limit)
    }

    /// Returns the answer to a request to end, given at once and from any thread.
    pub(crate) fn answer_to_interrupt(&self) -> impl Fn(Signal) + Send + use<> {
        let (bar, quiet) = (self.bar.clone(), self.quiet);
        move |signal| {
            if !quiet {
                bar.suspend(|| {
                    say(format_args!(
                        "{signal}: ending with the passes that are done; once more stops at once"
                    ));
                });
            }
        }
    }

    /// Returns what prints a warning above the line, from any thread; nothing if that is unwanted.
    pub(crate) fn warner(&self) -> impl Fn(&str) + Send + Sync + use<> {
        let (bar, quiet) = (self.bar.clone(), self.quiet);
        move |text| {
            if !quiet {
                bar.suspend(|| say_line("warning", text));
            }
        }
    }

    /// Writes the text that follows the clock.
    fn describe(&self, progress: &Progress<'_>) -> String {
        let elapsed = self.start.elapsed();
        let passes = progress.film.passes();
        let done = fraction_done(f64::from(passes), progress.spp, elapsed, self.time_limit);
        let left = clock(self.time_left(progress, elapsed));
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

    /// Takes the line away.
    pub(crate) fn clear(&self) {
        self.bar.finish_and_clear();
    }
}

impl LastPass {
    /// Describes the progress of the pass after it, at this time, if it takes long.
    fn describe_next(&self, now: Duration, part: f64) -> String {
        let since = now.saturating_sub(Duration::from_millis(self.end.load(Ordering::Relaxed)));
        if since < LONG_PASS {
            return String::new();
        }
        let number = self.number.load(Ordering::Relaxed) + 1;
        format!("  pass {number} {:.0} %", 100.0 * part)
    }
}

/// Factors on the time gone that say no more than "very long".
const LONGEST: f64 = 1e6;

/// Returns the part of the work that is done: of the passes or of the time, whichever ends it
/// first.
fn fraction_done(passes: f64, spp: u32, elapsed: Duration, limit: Option<Duration>) -> f64 {
    let of_time = limit.map_or(0.0, |limit| elapsed.as_secs_f64() / limit.as_secs_f64());
    (passes / f64::from(spp)).max(of_time).min(1.0)
}

/// Returns the time that it will take, as long as nothing changes: after `now` of the passes that
/// were wanted when the clock began.
fn time_left(now: f64, wanted: f64, elapsed: Duration, limit: Option<Duration>) -> Duration {
    let of_passes = elapsed.mul_f64((wanted / now - 1.0).clamp(0.0, LONGEST));
    limit.map_or(of_passes, |limit| of_passes.min(limit.saturating_sub(elapsed)))
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

    /// The clock tells nothing of what was done before.
    #[test]
    fn time_left_is_that_of_this_run() {
        let (second, limit) = (Duration::from_secs(1), Some(Duration::from_secs(4)));
        assert_eq!(time_left(1.0, 8.0, second, None), 7 * second);
        assert_eq!(time_left(1.0, 8.0, second, limit), 3 * second);
        assert_eq!(time_left(4.0, 8.0, second, limit), second);
        assert_eq!(time_left(4.0, 8.0, 5 * second, limit), Duration::ZERO);
    }

    #[test]
    fn passes_that_take_long_are_shown() {
        let last = LastPass { number: AtomicU32::new(2), end: AtomicU64::new(4000) };
        assert_eq!(last.describe_next(Duration::from_millis(4900), 0.5), "");
        assert_eq!(last.describe_next(Duration::from_millis(5100), 0.5), "  pass 3 50 %");
    }

    #[test]
    fn clocks_show_hours_where_there_are_any() {
        assert_eq!(clock(Duration::from_millis(61_900)), "01:01");
        assert_eq!(clock(Duration::from_secs(36_001)), "10:00:01");
    }
}
