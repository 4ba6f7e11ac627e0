//! A comparison in parts: references once, then runs by anybody, then the page of all.
//!
//! All results lie in the folder under keys of what decides them, so the runs of all parts need no
//! merging: a comparison finds them there.

use super::{Work, warn};
use crate::options::Options;
use crate::prepare::Prepared;
use crate::progress::Plan;
use crate::reference::{Reference, find};
use crate::results::How;
use traylib_demos::{Failure, Shard};
use traylib_integrators::Control;

/// Renders the references of all scenes, as far as they are not there; tells whether it was
/// not stopped.
///
/// # Errors
/// A scene makes no sense, the system refuses threads, or nothing can be written.
pub fn references(options: &Options, how: &How, stop: &Control) -> Result<bool, Failure> {
    options.check()?;
    let work = Work::prepare(options, how, stop)?;
    let plan = Plan::new(work.references_seconds());
    for prepared in &work.scenes {
        plan.begin(&prepared.loaded.name);
        work.reference(prepared, &plan)?;
    }
    plan.clear();
    Ok(!work.stopped())
}

/// Makes one of several parts of the runs on all scenes; tells whether it was not stopped.
///
/// # Errors
/// A scene makes no sense or has no reference yet, the system refuses threads, or nothing can
/// be written.
pub fn runs(options: &Options, shard: Shard, how: &How, stop: &Control) -> Result<bool, Failure> {
    options.check()?;
    let work = Work::prepare(options, how, stop)?;
    // All of them are there before any run is made.
    let references: Vec<Reference> =
        work.scenes.iter().map(|scene| work.found_reference(scene)).collect::<Result<_, _>>()?;
    // Runs are divided as passes are.
    let turns = shard.passes(options.seeds());
    let plan = Plan::new(work.runs_seconds(turns.len() as u32));
    for (prepared, reference) in work.scenes.iter().zip(&references) {
        warn(prepared);
        plan.begin(&prepared.loaded.name);
        if reference.nothing_to_compare().is_none() {
            work.runs(prepared, reference, turns.clone(), &plan)?;
        }
    }
    plan.clear();
    Ok(!work.stopped())
}

impl Work<'_> {
    /// Parts that rendered a reference each would hold their runs against different ones.
    fn found_reference(&self, prepared: &Prepared) -> Result<Reference, Failure> {
        let known = self.known_reference(prepared)?;
        known.or_else(|| find(&self.making(prepared))).ok_or_else(|| {
            Failure::usage(format_args!(
                "--shard: {} has no reference by this build in {} yet: the same command with \
                 --references-only instead renders it",
                prepared.loaded.name,
                self.options.folder().display()
            ))
        })
    }
}
