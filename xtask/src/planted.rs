//! `cargo xtask planted`: defects planted one at a time, and the tests that find
//! them.

use crate::proofs::{Extent, Outcome, Proofs};
use crate::workspace::root;
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::Path;
use std::process::Command;
use traylib_math::Defect;
use traylib_math::planted::VARIABLE;

/// What found one defect.
struct Catch {
    defect: Defect,
    extent: Extent,
    outcome: Outcome,
}

/// Runs the tests against each defect, or those named, and writes
/// `target/planted/table.md`; an error if one is not found.
pub(crate) fn run(names: &[&str]) -> Result<()> {
    let defects = chosen(names)?;
    let folder = root().join("target/planted");
    let proofs = Proofs::build(|command| {
        // A folder of its own, so that the next build is what it was.
        command.env("RUSTFLAGS", "--cfg planted").env("CARGO_TARGET_DIR", &folder);
    })?;
    let ledger = folder.join("ledger.jsonl");
    let sound = proofs.run(Extent::Fast, &ledger, |_| {})?;
    ensure!(sound.failed.is_empty(), "without a defect {:?} fail", sound.failed);
    println!("{} tests pass without a defect", sound.passed.len());
    let mut catches = Vec::new();
    for defect in defects {
        let found = catch(&proofs, defect, &ledger)?;
        print!("{}", row(&found));
        catches.push(found);
    }
    conclude(&catches, &folder)
}

fn chosen(names: &[&str]) -> Result<Vec<Defect>> {
    let find = |name: &&str| {
        let named = Defect::ALL.into_iter().find(|defect| format!("{defect:?}") == **name);
        named.with_context(|| format!("no defect `{name}`; there are {:?}", Defect::ALL))
    };
    if names.is_empty() { Ok(Defect::ALL.to_vec()) } else { names.iter().map(find).collect() }
}

/// The fast tests first; those at length only if they must.
fn catch(proofs: &Proofs, defect: Defect, ledger: &Path) -> Result<Catch> {
    let wake = |command: &mut Command| {
        command.env(VARIABLE, format!("{defect:?}"));
    };
    let outcome = proofs.run(Extent::Fast, ledger, wake)?;
    if !outcome.failed.is_empty() {
        return Ok(Catch { defect, extent: Extent::Fast, outcome });
    }
    let outcome = proofs.run(Extent::Whole, ledger, wake)?;
    Ok(Catch { defect, extent: Extent::Whole, outcome })
}

fn conclude(catches: &[Catch], folder: &Path) -> Result<()> {
    let head =
        "| defect | found by | tests | fewest samples | for example |\n|---|---|---|---|---|\n";
    let table: String = catches.iter().map(row).collect();
    let file = folder.join("table.md");
    fs::write(&file, format!("{head}{table}"))
        .with_context(|| format!("cannot write {}", file.display()))?;
    let found = catches.iter().filter(|catch| !catch.outcome.failed.is_empty()).count();
    let fast = catches.iter().filter(|catch| catch.extent == Extent::Fast).count();
    println!("{found} of {} defects found, {fast} by the fast tests alone", catches.len());
    println!("table: {}", file.display());
    ensure!(found == catches.len(), "a defect that nothing finds wants a test");
    Ok(())
}

/// One line of the table. The samples are those of the cheapest comparison that
/// failed; tests without chance need none.
fn row(catch: &Catch) -> String {
    let Catch { defect, extent, outcome } = catch;
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
    format!("| {defect:?} | {by} | {tests} | {samples} | {} |\n", examples.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn defects_are_chosen_by_name() {
        assert_eq!(chosen(&[]).unwrap().len(), 28);
        assert_eq!(chosen(&["RasterShifted"]).unwrap(), [Defect::RasterShifted]);
        assert!(chosen(&["NoSuch"]).unwrap_err().to_string().contains("RasterShifted"));
    }

    #[test]
    fn a_defect_that_nothing_finds_stands_out() {
        let outcome = Outcome::default();
        let missed = Catch { defect: Defect::PowerByPowf, extent: Extent::Whole, outcome };
        assert_eq!(row(&missed), "| PowerByPowf | **nothing** | 0 | - |  |\n");
    }
}
