//! Which method reaches which error in which time.
//!
//! | module | what it does |
//! |---|---|
//! | [`options`], [`contestant`], [`prepare`], [`radiance`] | what is compared |
//! | [`reference`](mod@reference) | what pictures are held against |
//! | [`race`], [`run`](mod@run), [`store`] | the runs, by turns, kept on disk |
//! | [`judge`], [`bootstrap`] | from runs to intervals and a verdict |
//! | [`results`], [`pictures`] | what was found, as plain data |
//! | [`page`], [`table`], [`csv`] | what is shown of it |

pub mod bootstrap;
mod chart;
pub mod compare;
pub mod contestant;
pub mod csv;
pub mod how;
pub mod judge;
pub mod lengths;
pub mod memory;
mod mirrors;
pub mod options;
pub mod oracle;
pub mod outside;
pub mod page;
pub mod pictures;
pub mod precision;
pub mod prepare;
pub mod progress;
pub mod race;
pub mod radiance;
pub mod reference;
pub mod results;
pub mod run;
#[doc(hidden)]
pub mod sample;
pub mod store;
pub mod table;
pub mod techniques;

use std::path::PathBuf;

/// The folder of everything that is built, beside the workspace.
pub fn target() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../target"))
}
