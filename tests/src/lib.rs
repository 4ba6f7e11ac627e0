//! What the tests of the whole share: scenes with known answers, and the
//! statistics that compare pictures with them and with one another.

pub mod ablation;
pub mod agreement;
pub mod analytic;
pub mod concentric;
pub mod exchange;
pub mod furnace;
pub mod hard;
pub mod horizon;
pub mod laws;
pub mod ledger;
pub mod measure;
pub mod mirrored;
pub mod polygon;
pub mod polygonal;
pub mod programs;
pub mod rooms;
pub mod scenes;
pub mod stability;
pub mod statistics;
pub mod still_life;
pub mod variance;
