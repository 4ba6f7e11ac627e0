//! The programs, as their users meet them.
#![allow(clippy::unwrap_used, reason = "a helper that fails fails its test")]

mod aov;
mod auto;
mod bdpt;
mod black;
#[cfg(unix)]
mod checkpoints;
mod common;
mod convert;
mod display;
#[cfg(unix)]
mod disturbances;
mod errors;
mod film;
#[cfg(unix)]
mod interrupts;
mod looks;
mod models;
mod noise;
#[cfg(unix)]
mod outputs;
mod pictures;
mod printing;
mod progress;
mod scene;
mod shards;
mod stats;
mod windows;
