//! Proofs that draw their own scenes: relations that a right renderer keeps on
//! any scene, judged on scenes that a generator makes up.
//!
//! | module | what is in it |
//! |---|---|
//! | [`scene`] | a scene as plain data, and what is in it |
//! | [`draw`] | what is drawn |
//! | [`form`] | in which forms: files, and the same scene moved, cut, joined |
//! | [`relation`] | which relations there are |
//! | [`render`] | a scene as numbers, a few for each pass |
//! | [`outside`] | a renderer by others, where it is installed |
//! | [`judge`] | how a relation is judged |
//! | [`shrink`] | how a scene that breaks one is made small |
//! | [`run`] | all scenes, by two threads; [`pooled`] over them all |
//! | [`case`] | scenes on disk that were caught once |
//!
//! `docs/proofs.md` tells how to read what comes of it.

pub mod case;
pub mod draw;
pub mod form;
pub mod judge;
pub mod outside;
pub mod pooled;
pub mod relation;
pub mod render;
pub mod report;
pub mod run;
pub mod scene;
pub mod shrink;
