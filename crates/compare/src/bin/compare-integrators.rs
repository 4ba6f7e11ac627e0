//! `cargo xtask compare-integrators`.

use std::path::Path;
use std::process::{Command, ExitCode};
use std::sync::{Arc, OnceLock};
use traylib_compare::compare::{compare, references, runs};
use traylib_compare::folder;
use traylib_compare::how::how;
use traylib_compare::options::Options;
use traylib_compare::results::How;
use traylib_compare::table::table;
use traylib_demos::{Failure, Signal, conclude, on_interrupt, parse, say, tell, tell_name};
use traylib_integrators::Control;

fn main() -> ExitCode {
    let options: Options = parse();
    conclude("compare-integrators", || run(&options))
}

fn run(options: &Options) -> Result<(), Failure> {
    if cfg!(debug_assertions) {
        say("warning: this is a debug build, whose times mean nothing; use cargo xtask");
    }
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let stop = Arc::new(Control::default());
    let signal = Arc::new(OnceLock::new());
    let (raised, by) = (Arc::clone(&stop), Arc::clone(&signal));
    on_interrupt(move |signal| {
        by.get_or_init(|| signal);
        raised.cancel();
        say(format_args!("{}: what is done will be shown; once more stops at once", word(signal)));
    });
    let how = how(options, &arguments);
    if let Some((folder, is_done)) = part(options, &how, &stop)? {
        if is_done {
            return tell_name(&options.folder().join(folder));
        }
        let what = "; what was done is kept, and the same command goes on from there";
        return Err(interrupted(signal.get().copied(), what));
    }
    let comparison = compare(options, how, &stop)?;
    if comparison.results.is_empty() {
        let what = " before any scene was done; finished runs are kept, nothing else is \
                    written, and the same command goes on from there";
        return Err(interrupted(signal.get().copied(), what));
    }
    let folder = options.folder();
    folder::write(&folder, &comparison).map_err(Failure::output)?;
    tell(table(&comparison.results).trim_end())?;
    let index = folder.join("index.html");
    tell_name(&index)?;
    if options.open {
        open(&index);
    }
    if comparison.results.complete {
        return Ok(());
    }
    let what = "; what was done is kept and shown, and the same command goes on from there";
    Err(interrupted(signal.get().copied(), what))
}

/// Makes what is wanted of a comparison in parts: the folder of what was made, and whether it
/// was not stopped; `None` if the whole is wanted.
fn part(
    options: &Options,
    how: &How,
    stop: &Control,
) -> Result<Option<(&'static str, bool)>, Failure> {
    if options.references_only {
        return Ok(Some(("references", references(options, how, stop)?)));
    }
    let Some(shard) = options.shard else { return Ok(None) };
    Ok(Some(("runs", runs(options, shard, how, stop)?)))
}

fn interrupted(signal: Option<Signal>, what: &str) -> Failure {
    let signal = signal.unwrap_or(Signal::Interrupt);
    Failure::interrupted(signal, format_args!("{}{what}", word(signal)))
}

/// Returns the words that name a signal in messages.
fn word(signal: Signal) -> &'static str {
    match signal {
        Signal::Hangup => "terminal closed",
        Signal::Interrupt => "interrupted",
        Signal::Terminate => "told to terminate",
    }
}

/// Shows a file with whatever the system shows such files with.
fn open(file: &Path) {
    let opener = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    if let Err(error) = Command::new(opener).arg(file).spawn() {
        say(format_args!("warning: {opener} does not start ({error}): open {}", file.display()));
    }
}
