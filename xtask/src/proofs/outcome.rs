//! The results of tests.

use super::Finding;
use std::path::Path;
use std::process::Output;

/// The results of test programs.
#[derive(Debug, Default)]
pub(crate) struct Outcome {
    /// Names of the tests that passed, and of those that did not. A program that
    /// died stands for itself.
    pub(crate) passed: Vec<String>,
    pub(crate) failed: Vec<String>,
    /// The output of the failing programs.
    pub(crate) complaints: String,
    pub(crate) findings: Vec<Finding>,
}

impl Outcome {
    /// Takes in what one program printed.
    pub(super) fn add(&mut self, program: &Path, output: &Output) {
        let text = String::from_utf8_lossy(&output.stdout);
        let before = self.failed.len();
        for line in text.lines() {
            match verdict(line) {
                Some((name, "ok")) => self.passed.push(name.to_owned()),
                Some((name, "FAILED")) => self.failed.push(name.to_owned()),
                _ => {}
            }
        }
        if output.status.success() {
            return;
        }
        self.complaints += &text;
        if self.failed.len() == before {
            let name = program.file_stem().map_or_else(String::new, |n| n.to_string_lossy().into());
            self.complaints += &String::from_utf8_lossy(&output.stderr);
            self.failed.push(name);
        }
    }

    /// The findings of one test.
    pub(crate) fn findings_of<'a>(&'a self, test: &'a str) -> impl Iterator<Item = &'a Finding> {
        self.findings.iter().filter(move |finding| finding.test == test)
    }
}

/// Name and verdict in a line of the test harness.
fn verdict(line: &str) -> Option<(&str, &str)> {
    let (name, verdict) = line.strip_prefix("test ")?.rsplit_once(" ... ")?;
    // "should panic" stands behind the name of such a test.
    Some((name.split(" - ").next()?, verdict))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_harness_is_understood() {
        assert_eq!(verdict("test a::b ... ok"), Some(("a::b", "ok")));
        assert_eq!(verdict("test a - should panic ... FAILED"), Some(("a", "FAILED")));
        assert_eq!(verdict("test result: ok. 3 passed"), None);
    }
}
