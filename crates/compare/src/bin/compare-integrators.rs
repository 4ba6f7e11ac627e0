//! `cargo xtask compare-integrators`.

use std::path::Path;
use std::process::{Command, ExitCode};
use std::sync::{Arc, OnceLock};
use traylib_compare::compare::{Comparison, compare};
use traylib_compare::how::how;
use traylib_compare::options::Options;
use traylib_compare::page::page;
use traylib_compare::store::{write_json, write_text};
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
        say("interrupt: what is done will be shown; once more stops at once");
    });
    let comparison = compare(options, how(options, &arguments), &stop)?;
    let folder = options.folder();
    write(&folder, &comparison).map_err(Failure::output)?;
    tell(table(&comparison.results).trim_end())?;
    let index = folder.join("index.html");
    tell_name(&index)?;
    if options.open {
        open(&index);
    }
    if comparison.results.complete {
        return Ok(());
    }
    Err(Failure::interrupted(
        signal.get().copied().unwrap_or(Signal::Interrupt),
        "interrupted; what was done is kept and shown, and the same command goes on from there",
    ))
}

fn write(folder: &Path, comparison: &Comparison) -> Result<(), traylib_compare::store::StoreError> {
    let Comparison { results, pictures, csv } = comparison;
    write_json(&folder.join("results.json"), results)?;
    write_text(&folder.join("results.csv"), csv)?;
    write_text(&folder.join("index.html"), &page(results, pictures))
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
