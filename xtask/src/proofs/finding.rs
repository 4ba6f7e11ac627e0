//! The findings that tests wrote down.

use anyhow::{Context, Result};
use serde_json::Value;
use std::path::Path;

/// One comparison: a line of findings that `traylib_tests::findings` writes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Finding {
    pub(crate) test: String,
    pub(crate) claim: String,
    pub(crate) statistic: String,
    pub(crate) level: Option<f64>,
    pub(crate) samples: u64,
    pub(crate) holds: bool,
}

impl Finding {
    /// Reads all findings of a file; there are none if no test wrote one.
    pub(crate) fn read(file: &Path) -> Result<Vec<Self>> {
        if !file.exists() {
            return Ok(Vec::new());
        }
        let text = std::fs::read_to_string(file)
            .with_context(|| format!("cannot read {}", file.display()))?;
        text.lines().map(|line| Self::of(line).context("a line of findings")).collect()
    }

    fn of(line: &str) -> Result<Self> {
        let entry: Value = serde_json::from_str(line)?;
        let text = |key: &str| {
            entry[key].as_str().map(String::from).with_context(|| format!("no `{key}` in {line}"))
        };
        Ok(Self {
            test: text("test")?,
            claim: text("claim")?,
            statistic: text("statistic")?,
            level: entry["level"].as_f64(),
            samples: entry["samples"].as_u64().context("no `samples`")?,
            holds: entry["holds"].as_bool().context("no `holds`")?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_read() {
        let line = r#"{"test":"a::b","claim":"c","statistic":"1 ± 2","level":null,
            "samples":7,"holds":true}"#;
        let found = Finding::of(line).unwrap();
        assert_eq!((found.test.as_str(), found.level, found.samples), ("a::b", None, 7));
        assert!(Finding::of("{}").is_err());
    }
}
