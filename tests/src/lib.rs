//! The parts that tests of the whole share: scenes with known answers, and the statistics that
//! compare pictures with them and with one another.

pub mod ablation;
pub mod agreement;
pub mod findings;
pub mod laws;
pub mod measure;
pub mod methods;
pub mod relations;
pub mod stability;
pub mod still_life;
