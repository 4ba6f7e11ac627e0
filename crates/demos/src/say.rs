//! Printing for people: results on standard output, all else on standard error. No reader is no
//! reason to stop.

use crate::outcome::Failure;
use serde_json::Value;
use std::fmt::Display;
use std::io::{ErrorKind, IsTerminal, Write};
use std::path::Path;
use traylib_io::{printable, printable_json, write_file};

/// The name of a file that stands for standard output.
pub(crate) const STANDARD_OUTPUT: &str = "-";

/// Prints something about the work, as text that does nothing to a terminal.
pub fn say(text: impl Display) {
    let _ = writeln!(std::io::stderr(), "{}", printable(&text.to_string()));
}

/// Prints a warning or a note, which is one line whatever a file has put into it.
pub(crate) fn say_line(kind: &str, text: impl Display) {
    say(format_args!("{kind}: {}", text.to_string().replace('\n', "\\n")));
}

/// Prints one line of the program's result, as text that does nothing to a terminal.
///
/// # Errors
/// Standard output takes no more.
pub fn tell(line: impl Display) -> Result<(), Failure> {
    print(&printable(&line.to_string()))
}

/// [`tell`] for JSON.
///
/// # Errors
/// As `tell`.
pub(crate) fn tell_json(json: &str) -> Result<(), Failure> {
    print(&printable_json(json))
}

/// Writes a value as JSON to a file, `-` for standard output.
///
/// # Errors
/// It cannot be written.
pub(crate) fn write_json(file: &Path, value: &Value) -> Result<(), Failure> {
    let json = serde_json::to_string_pretty(value).map_err(Failure::output)?;
    if file == Path::new(STANDARD_OUTPUT) {
        tell_json(&json)
    } else {
        Ok(write_file(file, format!("{json}\n").as_bytes())?)
    }
}

/// Prints the name of a file that was written: as it is for whoever reads it to find the
/// file, as [`tell`] for people.
///
/// # Errors
/// As `tell`.
pub fn tell_name(file: &Path) -> Result<(), Failure> {
    let name = file.display();
    if std::io::stdout().is_terminal() { tell(name) } else { print(&name.to_string()) }
}

fn print(text: &str) -> Result<(), Failure> {
    match writeln!(std::io::stdout(), "{text}") {
        // A reader that has seen enough closes the pipe.
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::output(format_args!("standard output: cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// A number short enough to read, with a unit to follow: `1.85 M`.
pub fn count(n: u64) -> String {
    match n as f64 {
        x if x >= 1e9 => format!("{:.2} G", x / 1e9),
        x if x >= 1e6 => format!("{:.2} M", x / 1e6),
        x if x >= 1e4 => format!("{:.1} k", x / 1e3),
        _ => n.to_string(),
    }
}
