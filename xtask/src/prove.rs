//! `cargo xtask prove`: every proof at length, and a report of all claims.

use crate::proofs::{Extent, Finding, Outcome, Proofs, Until};
use crate::workspace::root;
use anyhow::{Context, Result, ensure};
use std::fmt::Write;
use std::fs;
use std::time::{Duration, Instant};

/// Runs all tests, long ones too, and writes `target/prove/report.md`; an error
/// if one fails.
pub(crate) fn run() -> Result<()> {
    let folder = root().join("target/prove");
    fs::create_dir_all(&folder).with_context(|| format!("cannot create {}", folder.display()))?;
    let start = Instant::now();
    let proofs = Proofs::build(root(), |_| {})?;
    println!("built in {:.0} s; proving, which takes a while", start.elapsed().as_secs_f64());
    let start = Instant::now();
    let findings = folder.join("findings.jsonl");
    let outcome = proofs.run(Extent::Whole, Until::TheEnd, &findings, |_| {})?;
    let file = folder.join("report.md");
    fs::write(&file, report(&outcome, start.elapsed()))
        .with_context(|| format!("cannot write {}", file.display()))?;
    println!("{}", summary(&outcome, start.elapsed()));
    println!("report: {}", file.display());
    print!("{}", outcome.complaints);
    ensure!(outcome.failed.is_empty(), "{} tests failed", outcome.failed.len());
    Ok(())
}

fn summary(outcome: &Outcome, time: Duration) -> String {
    let holding = outcome.findings.iter().filter(|finding| finding.holds).count();
    let samples: u64 = outcome.findings.iter().map(|finding| finding.samples).sum();
    format!(
        "{} tests passed, {} failed; {holding} of {} claims hold, on {:.2e} samples; {:.0} s",
        outcome.passed.len(),
        outcome.failed.len(),
        outcome.findings.len(),
        samples as f64,
        time.as_secs_f64(),
    )
}

/// Markdown: the claims of each test with statistic, level and samples, then the
/// tests that claim in code alone.
fn report(outcome: &Outcome, time: Duration) -> String {
    let mut text = format!("# Proofs\n\n{}.\n", summary(outcome, time));
    let mut silent = Vec::new();
    let mut tests: Vec<(&String, &str)> = outcome.failed.iter().map(|t| (t, "FAILED")).collect();
    tests.extend(outcome.passed.iter().map(|t| (t, "passed")));
    tests.sort();
    for (test, verdict) in tests {
        let findings: Vec<&Finding> = outcome.findings_of(test).collect();
        if findings.is_empty() {
            silent.push((test, verdict));
            continue;
        }
        let _ = write!(text, "\n## {test}: {verdict}\n\n");
        text += "| claim | statistic | level | samples | holds |\n|---|---|---|---|---|\n";
        text.extend(findings.into_iter().map(row));
    }
    text += "\n## Tests without chance\n\nWhat they claim stands in their code.\n\n";
    text.extend(silent.iter().map(|(test, verdict)| format!("- {test}: {verdict}\n")));
    text
}

fn row(finding: &Finding) -> String {
    let Finding { claim, statistic, level, samples, holds, .. } = finding;
    let level = level.map_or_else(|| "exact".into(), |level| format!("{level:.1e}"));
    let holds = if *holds { "yes" } else { "**NO**" };
    let cell = |text: &str| text.replace('|', "\\|");
    format!("| {} | {} | {level} | {samples} | {holds} |\n", cell(claim), cell(statistic))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_lists_claims_and_tests_without_any() {
        let finding = Finding {
            test: "a::b".into(),
            claim: "|x| = 1".into(),
            statistic: "1.01 ± 0.02".into(),
            level: Some(1e-3),
            samples: 4096,
            holds: true,
        };
        let outcome = Outcome {
            passed: vec!["a::b".into(), "c::d".into()],
            failed: vec!["e::f".into()],
            complaints: String::new(),
            findings: vec![finding],
        };
        let text = report(&outcome, Duration::from_secs(3));
        assert!(text.contains("2 tests passed, 1 failed; 1 of 1 claims hold, on 4.10e3 samples"));
        assert!(text.contains("| \\|x\\| = 1 | 1.01 ± 0.02 | 1.0e-3 | 4096 | yes |"));
        assert!(text.contains("- c::d: passed") && text.contains("- e::f: FAILED"));
    }
}
