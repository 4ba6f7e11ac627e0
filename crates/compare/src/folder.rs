//! The files that a comparison leaves in its folder.

use crate::chart;
use crate::compare::Comparison;
use crate::options::ORACLE;
use crate::page::{charts, page};
use crate::results::Results;
use crate::scaling::{self, Scaling};
use crate::store::{StoreError, make_folder, write_json, write_text};
use serde_json::Value;
use std::path::Path;
use traylib_demos::say;

/// Writes page, charts, numbers and lines of runs over what an earlier comparison left; tells
/// if that was of other scenes.
///
/// # Errors
/// A file cannot be written.
pub fn write(folder: &Path, comparison: &Comparison) -> Result<(), StoreError> {
    let Comparison { results, pictures, csv } = comparison;
    let numbers = folder.join("results.json");
    let lost = lost(&numbers, results);
    if !lost.is_empty() {
        say(format_args!(
            "note: {}: the results of {} there are replaced; --out keeps both",
            folder.display(),
            lost.join(", ")
        ));
    }
    write_json(&numbers, results)?;
    let lines = folder.join("results.csv");
    if csv.is_empty() {
        // Those of an earlier comparison do not belong to this page.
        let _ = std::fs::remove_file(lines);
    } else {
        write_text(&lines, csv)?;
    }
    for (file, chart) in charts(results) {
        write_text(&folder.join(file), &chart)?;
    }
    write_text(&folder.join("index.html"), &page(results, pictures))
}

/// Writes `scaling.csv`, and a chart an axis beside it.
///
/// # Errors
/// A file cannot be written.
pub fn write_scaling(folder: &Path, found: &Scaling) -> Result<(), StoreError> {
    make_folder(folder)?;
    for axis in &found.axes {
        if let Some(chart) = chart::scaling(axis) {
            write_text(&folder.join(format!("{}.svg", axis.axis.name())), &chart)?;
        }
    }
    write_text(&folder.join("scaling.csv"), &scaling::csv(found))
}

/// Returns the scenes, and the oracle, of an earlier comparison that this one has not looked at.
fn lost(numbers: &Path, results: &Results) -> Vec<String> {
    let text = std::fs::read_to_string(numbers).unwrap_or_default();
    // Of whichever version.
    let earlier: Value = serde_json::from_str(&text).unwrap_or_default();
    let scenes = earlier["scenes"].as_array().into_iter().flatten();
    let names = scenes.filter_map(|scene| scene["name"].as_str());
    let mut lost: Vec<String> = names
        .filter(|name| results.scenes.iter().all(|scene| scene.name != **name))
        .map(String::from)
        .collect();
    if !earlier["oracle"].is_null() && results.oracle.is_none() {
        lost.push(ORACLE.into());
    }
    lost
}
