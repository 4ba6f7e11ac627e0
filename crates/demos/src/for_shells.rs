//! The description of a command line for shells and manuals.

use clap::Command;
use clap_complete::Shell;
use std::ffi::OsString;
use std::io::Write;

/// The end of a program's long help about this.
pub(crate) const HELP: &str = "\
`--completions bash`, or another shell, prints what completes these options there, and `--man`
a page for man.";

/// Prints what these words ask for, if it is that, and nothing else: `--completions SHELL` or
/// `--man` alone.
pub(crate) fn answer(command: &mut Command, words: &[OsString]) -> bool {
    let words: Vec<_> = words.iter().skip(1).map(|word| word.to_string_lossy()).collect();
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    let mut text = Vec::new();
    match words[..] {
        ["--completions", shell] => {
            let Ok(shell) = shell.parse::<Shell>() else { return false };
            let name = command.get_name().to_owned();
            clap_complete::generate(shell, command, name, &mut text);
        }
        // A list takes whatever is written to it.
        ["--man"] => _ = clap_mangen::Man::new(command.clone()).render(&mut text),
        _ => return false,
    }
    // Who does not listen need not.
    let _ = std::io::stdout().write_all(&text);
    true
}
