//! Findings: what tests found, in a list that outlives them.
//!
//! A test that compares numbers states what it claims, by which statistic, how
//! sure it is and on how many samples. `cargo xtask prove` and
//! `cargo xtask faults` name a file in the environment and make their reports
//! of what was written there; without it nothing is written.

use serde::{Deserialize, Serialize};
use std::fs::OpenOptions;
use std::io::Write;

/// The variable of the environment that names the file.
pub const FILE: &str = "TRAYLIB_FINDINGS";

/// One comparison and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// The claim that is tested: scene, method, quantity.
    pub claim: String,
    /// The statistic: what was measured, and what it was held against.
    pub statistic: String,
    /// The chance with which a correct program fails this comparison; `None` where chance has no
    /// part.
    pub level: Option<f64>,
    /// Random samples behind it; zero where nothing is random.
    pub samples: u64,
    /// True if the claim holds.
    pub holds: bool,
}

/// A line of the file: a finding and the test that made it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Entry {
    /// The test's path, as the test harness names it.
    pub test: String,
    /// The finding itself.
    #[serde(flatten)]
    pub finding: Finding,
}

/// Writes down all findings, then fails the test if one does not hold.
///
/// # Panics
/// With everything that does not hold; if there are no findings, for then
/// nothing was tested; if the file cannot be written.
pub fn settle(findings: &[Finding]) {
    if let Some(file) = std::env::var_os(FILE) {
        let mut file = OpenOptions::new().create(true).append(true).open(file).expect(FILE);
        let lines: String = findings.iter().map(line).collect();
        // One write: tests run side by side.
        file.write_all(lines.as_bytes()).expect(FILE);
    }
    conclude(findings);
}

fn conclude(findings: &[Finding]) {
    assert!(!findings.is_empty(), "nothing was tested");
    let wrong: Vec<String> = findings
        .iter()
        .filter(|finding| !finding.holds)
        .map(|Finding { claim, statistic, .. }| format!("{claim}: {statistic}"))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn line(finding: &Finding) -> String {
    let thread = std::thread::current();
    let test = thread.name().unwrap_or("?").to_owned();
    let entry = Entry { test, finding: finding.clone() };
    serde_json::to_string(&entry).expect("plain data") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    fn finding(holds: bool) -> Finding {
        let [claim, statistic] = ["the sky is blue", "470 nm"].map(String::from);
        Finding { claim, statistic, level: Some(1e-3), samples: 7, holds }
    }

    #[test]
    fn what_holds_passes() {
        conclude(&[finding(true)]);
    }

    #[test]
    #[should_panic(expected = "the sky is blue: 470 nm")]
    fn what_does_not_hold_fails() {
        conclude(&[finding(true), finding(false)]);
    }

    #[test]
    #[should_panic(expected = "nothing was tested")]
    fn nothing_is_no_proof() {
        conclude(&[]);
    }

    #[test]
    fn a_line_names_the_test_and_can_be_read_again() {
        let entry: Entry = serde_json::from_str(&line(&finding(true))).unwrap();
        assert!(entry.test.ends_with("a_line_names_the_test_and_can_be_read_again"));
        assert_eq!(entry.finding, finding(true));
    }
}
