//! The passes that a program renders.

use crate::job::Job;
use crate::outcome::Failure;
use crate::shard::Shard;
use std::ops::Range;
use traylib_io::Loaded;

/// The passes that a program renders.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Plan {
    /// The passes of the whole picture; `None` if it is the time that ends them.
    pub(crate) spp: Option<u32>,
    /// The part of it that is rendered here.
    pub(crate) shard: Shard,
    /// Its passes.
    pub(crate) passes: Range<u32>,
}

impl Plan {
    /// Returns the passes that a command line asks for.
    ///
    /// # Errors
    /// Parts are wanted of nobody knows how many passes, or an error by nobody knows when.
    pub(crate) fn of(job: &Job<'_>, loaded: &Loaded) -> Result<Self, Failure> {
        let spp = job.spp(loaded);
        let shard = job.options.keep.shard.unwrap_or(Shard::WHOLE);
        if spp.is_none() && job.options.keep.shard.is_some() {
            return Err(Failure::usage(
                "--shard with --time-limit needs --spp: parts are of so many passes",
            ));
        }
        let options = job.options;
        if options.noise.is_some() && options.spp.is_none() && options.time_limit.is_none() {
            return Err(Failure::usage(
                "--noise needs --spp or --time-limit, which ends what never gets there",
            ));
        }
        Ok(Self { spp, shard, passes: shard.passes(spp.unwrap_or(u32::MAX)) })
    }
}
