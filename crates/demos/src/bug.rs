//! The end of a program that fails by its own fault.

use crate::say::say;
use std::backtrace::{Backtrace, BacktraceStatus};
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook};
use std::sync::Once;

/// Does the work of a program; `None` if it panicked, which one line has told
/// by then, however many threads took part.
///
/// Work that has panicked is not looked at again, so it may leave its data as
/// it was.
pub(crate) fn report_bugs<R>(program: &'static str, work: impl FnOnce() -> R) -> Option<R> {
    let told = Once::new();
    set_hook(Box::new(move |panic| told.call_once(|| tell_of(program, panic))));
    catch_unwind(AssertUnwindSafe(work)).ok()
}

fn tell_of(program: &str, panic: &PanicHookInfo<'_>) {
    let reason = panic.payload_as_str().unwrap_or("no reason given").replace('\n', " ");
    let place = panic.location().map_or_else(String::new, |place| format!(" at {place}"));
    let version = crate::VERSION;
    say(format_args!(
        "error: this is a bug in {program} {version}{place}: {reason}; please report this line, the command and the scene to the authors of TrayLib"
    ));
    // Only where RUST_BACKTRACE asks for it.
    let backtrace = Backtrace::capture();
    if backtrace.status() == BacktraceStatus::Captured {
        say(backtrace);
    }
}
