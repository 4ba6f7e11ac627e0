//! The failures of estimators: every method over every failure scene, measured and judged.
//!
//! Each cell of the table is rendered in sixteen independent runs. What is kept
//! of them ([`cell`]) becomes figures ([`figures`]), these a verdict ([`judge`]),
//! and the verdicts are held against a table written down beforehand
//! ([`expected`]). `docs/stability.md` says how the table is read.

pub mod cell;
pub mod closed;
pub mod crowded;
pub mod expected;
pub mod figures;
pub mod judge;
pub mod page;
pub mod plate;
pub mod reference;
pub mod run;
pub mod scale;
pub mod scene;
pub mod table;
