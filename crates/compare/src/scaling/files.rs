//! What is left in a folder.

use super::{Scaling, csv};
use crate::chart;
use crate::store::{StoreError, make_folder, write_text};
use std::path::Path;

/// Writes `scaling.csv`, and a chart an axis beside it.
///
/// # Errors
/// A file cannot be written.
pub fn write(folder: &Path, scaling: &Scaling) -> Result<(), StoreError> {
    make_folder(folder)?;
    for axis in &scaling.axes {
        if let Some(chart) = chart::scaling(axis) {
            write_text(&folder.join(format!("{}.svg", axis.axis.name())), &chart)?;
        }
    }
    write_text(&folder.join("scaling.csv"), &csv(scaling))
}
