//! `cargo xtask faults`: fault injection. Mistakes are put into a copy of the sources,
//! awakened one at a time, and the tests named that find each.
//!
//! A fault is a patch in `xtask/faults` against the clean sources. All of them are
//! applied together to `target/faults/tree`, which is built once; the environment
//! awakens one.

mod copy;
mod edit;
mod fault;
mod injection;
mod support;
#[cfg(test)]
mod tests;

pub(crate) use edit::{edit, save};

use crate::proofs::{Extent, Outcome, Proofs, Until};
use crate::workspace::root;
use anyhow::{Context, Result, ensure};
use fault::Fault;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The outcome of the tests for one fault.
struct Catch<'a> {
    fault: &'a str,
    extent: Extent,
    outcome: Outcome,
}

/// Runs the tests against each fault, or those named, and writes
/// `target/faults/table.md`; an error if one is not found. `until` is how many test programs
/// are asked about each.
pub(crate) fn run(names: &[&str], until: Until) -> Result<()> {
    let faults = Fault::all()?;
    let chosen = chosen(&faults, names)?;
    let folder = root().join(copy::FOLDER);
    let proofs = build(&faults, &folder)?;
    let findings = folder.join("findings.jsonl");
    let sound = proofs.run(Extent::Fast, Until::TheEnd, &findings, |_| {})?;
    ensure!(sound.failed.is_empty(), "without a fault {:?} fail", sound.failed);
    println!("{} tests pass without a fault", sound.passed.len());
    let mut catches = Vec::new();
    for fault in chosen {
        let found = catch(&proofs, &fault.name, until, &findings)?;
        print!("{}", row(&found));
        catches.push(found);
    }
    conclude(&catches, &folder)
}

fn chosen<'a>(faults: &'a [Fault], names: &[&str]) -> Result<Vec<&'a Fault>> {
    let all = || faults.iter().map(|fault| fault.name.as_str()).collect::<Vec<_>>().join(", ");
    let find = |name: &&str| {
        let named = faults.iter().find(|fault| fault.name == **name);
        named.with_context(|| format!("no fault `{name}`; there are {}", all()))
    };
    if names.is_empty() { Ok(faults.iter().collect()) } else { names.iter().map(find).collect() }
}

/// The tests of a copy of the sources with all faults in it, asleep.
fn build(faults: &[Fault], folder: &Path) -> Result<Proofs> {
    let mut changed = injection::inject_all(root(), faults)?;
    support::add(root(), &mut changed, faults.iter().map(|fault| fault.name.as_str()))?;
    let tree = folder.join("tree");
    copy::write(root(), &tree, &changed)?;
    // A folder of its own, so that the next build is what it was.
    let target = folder.join("build");
    Proofs::build(&tree, |command| {
        command.env("CARGO_TARGET_DIR", &target);
    })
}

/// The fast tests first; those at length only if they must.
fn catch<'a>(proofs: &Proofs, fault: &'a str, until: Until, findings: &Path) -> Result<Catch<'a>> {
    let awaken = |command: &mut Command| {
        command.env(support::VARIABLE, fault);
    };
    let outcome = proofs.run(Extent::Fast, until, findings, awaken)?;
    if !outcome.failed.is_empty() {
        return Ok(Catch { fault, extent: Extent::Fast, outcome });
    }
    let outcome = proofs.run(Extent::Whole, until, findings, awaken)?;
    Ok(Catch { fault, extent: Extent::Whole, outcome })
}

fn conclude(catches: &[Catch<'_>], folder: &Path) -> Result<()> {
    let head =
        "| fault | found by | tests | fewest samples | for example |\n|---|---|---|---|---|\n";
    let table: String = catches.iter().map(row).collect();
    let file = folder.join("table.md");
    fs::write(&file, format!("{head}{table}"))
        .with_context(|| format!("cannot write {}", file.display()))?;
    let found = catches.iter().filter(|catch| !catch.outcome.failed.is_empty()).count();
    let fast = catches.iter().filter(|catch| catch.extent == Extent::Fast).count();
    println!("{found} of {} faults found, {fast} by the fast tests alone", catches.len());
    println!("table: {}", file.display());
    ensure!(found == catches.len(), "a fault that nothing finds wants a test");
    Ok(())
}

/// One line of the table. The samples are those of the cheapest comparison that
/// failed; tests without chance need none.
fn row(catch: &Catch<'_>) -> String {
    let Catch { fault, extent, outcome } = catch;
    let by = match extent {
        _ if outcome.failed.is_empty() => "**nothing**",
        Extent::Fast => "fast tests",
        Extent::Whole => "tests at length",
    };
    let fewest = outcome.findings.iter().filter(|f| !f.holds).map(|f| f.samples).min();
    let is_silent = |test: &&String| outcome.findings_of(test).next().is_none();
    let without = outcome.failed.iter().find(is_silent);
    let samples = match (fewest, without) {
        (_, Some(_)) => "none".into(),
        (Some(samples), None) => samples.to_string(),
        (None, None) => "-".into(),
    };
    let others = outcome.failed.iter().filter(|&test| Some(test) != without);
    let examples: Vec<&str> =
        without.into_iter().chain(others).take(3).map(String::as_str).collect();
    let tests = outcome.failed.len();
    format!("| {fault} | {by} | {tests} | {samples} | {} |\n", examples.join(", "))
}
