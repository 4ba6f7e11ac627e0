//! Measures which method reaches which error in which time.
//!
//! | module | what it does |
//! |---|---|
//! | [`options`], [`method`], [`prepare`], [`radiance`] | what is compared |
//! | [`reference`](mod@reference) | what pictures are held against |
//! | [`race`], [`run`](mod@run), [`store`] | the runs, by turns, kept on disk |
//! | [`judge`] | from runs to intervals and a verdict |
//! | [`results`], [`pictures`] | what was found, as plain data |
//! | [`page`], [`table`], [`csv`] | what is shown of it |
//! | [`folder`] | where it is left |
//! | [`scaling`] | how time and memory grow |
//! | [`needs`](mod@needs) | what a scene needs of bidirectional tracing |
//! | [`costs`] | what work costs, for plans |

mod bootstrap;
mod chart;
pub mod compare;
pub mod costs;
pub mod csv;
pub mod folder;
pub mod how;
pub mod judge;
pub mod lengths;
pub mod memory;
pub mod method;
mod mirrors;
pub mod needs;
pub(crate) mod number;
pub mod options;
pub mod oracle;
pub mod outside;
pub mod page;
pub mod picture;
pub mod pictures;
pub mod prepare;
pub mod progress;
pub mod race;
pub mod radiance;
pub mod reference;
pub mod results;
pub mod run;
#[doc(hidden)]
pub mod sample;
pub mod scaling;
pub mod store;
pub mod table;
pub mod techniques;

use std::path::{Path, PathBuf};

/// The folder of everything that is built, beside the workspace.
pub fn target() -> PathBuf {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
    workspace.unwrap_or(Path::new("")).join("target")
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_folder_has_a_name_that_can_be_read() {
        let target = super::target();
        assert!(target.ends_with("target") && !target.display().to_string().contains(".."));
    }
}
