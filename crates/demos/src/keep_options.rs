//! Options of what is kept of a rendering, to go on with.

use crate::duration::parse_duration;
use crate::shard::Shard;
use clap::Args;
use std::path::PathBuf;
use std::time::Duration;

/// The options for keeping a rendering, to go on with.
#[derive(Args, Clone, Debug, Default)]
pub struct KeepOptions {
    /// Keep all that is done in this file (.film) while it is rendered and in the end; the
    /// one before is kept as FILE.previous
    #[arg(long, value_name = "FILE")]
    pub checkpoint: Option<PathBuf>,

    /// Time between checkpoints, after one early [default: 60s, and longer if to write them
    /// would take more than a hundredth of the time]
    #[arg(long, value_name = "TIME", requires = "checkpoint", value_parser = parse_duration)]
    pub checkpoint_every: Option<Duration>,

    /// Go on from the checkpoint; from the beginning if there is none
    #[arg(long, requires = "checkpoint")]
    pub resume: bool,

    /// Render only part I, from 0 on, of N into the checkpoint, for `film merge`, and no
    /// picture
    #[arg(long, value_name = "I/N", requires = "checkpoint", conflicts_with = "outfile")]
    pub shard: Option<Shard>,
}
