//! Reading the command line.

use crate::messages::say;
use clap::Parser;

/// The options of a program. Ends it if they make no sense, or if only help or the
/// version is wanted.
pub fn parse<O: Parser>() -> O {
    O::try_parse().unwrap_or_else(|error| {
        // The shell may have put in names of files, which are text of others. Colour,
        // which is for a terminal to obey, is left out then.
        let is_odd = |word: std::ffi::OsString| {
            let word = word.to_string_lossy().into_owned();
            traylib_io::printable(&word) != word
        };
        if !error.use_stderr() || !std::env::args_os().any(is_odd) {
            error.exit();
        }
        say(error.render().to_string().trim_end());
        std::process::exit(error.exit_code())
    })
}
