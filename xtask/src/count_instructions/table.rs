//! Counts: printed, kept, compared.

use anyhow::{Context, Result};
use serde_json::{Map, Value, json};
use std::path::Path;

/// The instructions that a case took.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Count {
    /// In all.
    instructions: u64,
    /// The number of rays or triangles that it worked on.
    items: u64,
    /// The name of these items.
    unit: String,
}

impl Count {
    /// From what the bench says that it worked on, as `4096 rays`.
    pub(super) fn new(instructions: u64, done: &str) -> Option<Self> {
        let (items, unit) = done.split_once(' ')?;
        let items = items.parse().ok().filter(|&items| items > 0)?;
        Some(Self { instructions, items, unit: unit.to_owned() })
    }

    fn each(&self) -> f64 {
        self.instructions as f64 / self.items as f64
    }

    fn to_json(&self) -> Value {
        let Self { instructions, items, unit } = self;
        json!({ "instructions": instructions, "items": items, "unit": unit })
    }

    fn from_json(value: &Value) -> Option<Self> {
        let number = |name| value.get(name)?.as_u64();
        let unit = value.get("unit")?.as_str()?.to_owned();
        Some(Self { instructions: number("instructions")?, items: number("items")?, unit })
    }
}

/// Counts by the names of their cases.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Table(Map<String, Value>);

impl Table {
    pub(super) fn insert(&mut self, case: &str, count: &Count) {
        self.0.insert(case.to_owned(), count.to_json());
    }

    fn get(&self, case: &str) -> Option<Count> {
        Count::from_json(self.0.get(case)?)
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn read(file: &Path) -> Result<Self> {
        let text =
            std::fs::read(file).with_context(|| format!("cannot read {}", file.display()))?;
        let table = serde_json::from_slice(&text);
        Ok(Self(table.with_context(|| format!("{} is no table of counts", file.display()))?))
    }

    pub(super) fn write(&self, file: &Path) -> Result<()> {
        let text = serde_json::to_string_pretty(&self.0)? + "\n";
        std::fs::write(file, text).with_context(|| format!("cannot write {}", file.display()))
    }
}

pub(super) fn print_head() {
    println!("{:<24} {:>16} {:>18} {:>9}", "case", "instructions", "each of", "change");
}

/// With the change from `before`, if the case was there.
pub(super) fn print_row(case: &str, count: &Count, before: Option<&Table>) {
    let change = before.and_then(|table| table.get(case)).map(|before| change(count, &before));
    let change = change.unwrap_or_default();
    let items = format!("{} {}", count.items, count.unit);
    println!("{case:<24} {:>16.1} {items:>18} {change:>9}", count.each());
}

/// In percent of what each one took; nothing where not the same work was done.
fn change(after: &Count, before: &Count) -> String {
    if (after.items, &after.unit) != (before.items, &before.unit) {
        return "other work".to_owned();
    }
    if after.instructions == before.instructions {
        return "none".to_owned();
    }
    format!("{:+.2} %", 100.0 * (after.each() / before.each() - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_are_told_in_percent() {
        let count = |n| Count::new(n, "4 rays").unwrap();
        assert_eq!(change(&count(500), &count(400)), "+25.00 %");
        assert_eq!(change(&count(390), &count(400)), "-2.50 %");
        assert_eq!(change(&count(400), &count(400)), "none");
        assert_eq!(change(&count(400), &Count::new(400, "5 rays").unwrap()), "other work");
    }

    #[test]
    fn what_is_kept_is_what_was_counted() {
        let count = Count::new(123, "4 rays").unwrap();
        assert_eq!(Count::from_json(&count.to_json()), Some(count));
        assert_eq!(Count::new(123, "many rays"), None);
        assert_eq!(Count::new(123, "0 rays"), None);
    }
}
