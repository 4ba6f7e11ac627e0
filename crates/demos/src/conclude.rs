//! The end of every program's `main`.

use crate::bug::report_bugs;
use crate::interrupt;
use crate::outcome::Failure;
use crate::say::say;
use std::process::ExitCode;

/// Does the work of a program, prints what went wrong, a panic included, and
/// returns the exit status. Whoever asks for the end meanwhile is heard
/// ([`on_interrupt`](crate::on_interrupt)).
pub fn conclude(program: &'static str, work: impl FnOnce() -> Result<(), Failure>) -> ExitCode {
    interrupt::listen();
    match report_bugs(program, work) {
        Some(Ok(())) => ExitCode::SUCCESS,
        Some(Err(failure)) => {
            say(&failure);
            failure.code()
        }
        None => ExitCode::from(Failure::BUG),
    }
}
