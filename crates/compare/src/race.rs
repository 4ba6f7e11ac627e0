//! All runs on a scene: every method once, then all again with the next seed.
//!
//! Methods run by turns, so that whatever else the machine does falls on all alike.

use crate::judge::Entry;
use crate::picture::{Picture, double, single};
use crate::progress::Plan;
use crate::run::{Race, Record};
use crate::store::{Store, key_of};
use std::ops::Range;
use std::time::Duration;
use traylib_demos::Failure;
use traylib_integrators::Method;

/// The time for which each method renders before the race, in seconds.
pub const WARM_UP: f64 = 0.1;

/// Looking and keeping cost so much on top.
pub const OVERHEAD: f64 = 1.15;

/// The runs that are wanted.
#[derive(Debug)]
pub struct Field<'a> {
    /// The race that they take part in.
    pub race: Race<'a>,
    /// Hash of scene, reference and program: all that the methods do not decide.
    pub key: u64,
    /// The methods that run.
    pub methods: &'a [Method],
    /// The numbers of the runs to do of each method.
    pub turns: Range<u32>,
    /// Seed of run 0.
    pub first_seed: u64,
    /// The store of finished runs.
    pub store: &'a Store,
}

/// Runs them all, or those that are not done yet; fewer of each if it is stopped.
///
/// # Errors
/// The system refuses threads, or a file cannot be written.
pub fn race(field: &Field<'_>, plan: &Plan) -> Result<Vec<Entry>, Failure> {
    let entry = |&method: &Method| Entry { method, records: Vec::new(), pictures: Vec::new() };
    let mut entries: Vec<Entry> = field.methods.iter().map(entry).collect();
    let mut warm = false;
    for turn in field.turns.clone() {
        // Nobody always follows the same neighbour.
        for place in 0..entries.len() {
            let number = entries.len();
            let entry = &mut entries[(place + turn as usize) % number];
            let seed = field.first_seed + u64::from(turn);
            plan.detail(&format!("{}, run {} of {}", entry.method, turn + 1, field.turns.end));
            let Some((record, picture)) = field.one(entry.method, seed, &mut warm)? else {
                return Ok(entries);
            };
            entry.records.push(record);
            entry.pictures.push(picture);
            plan.done(field.seconds());
        }
    }
    Ok(entries)
}

impl Field<'_> {
    /// Returns the seconds that one run is planned to take.
    pub fn seconds(&self) -> f64 {
        OVERHEAD * self.race.budgets.last().copied().unwrap_or(0.0)
    }

    fn one(
        &self,
        method: Method,
        seed: u64,
        warm: &mut bool,
    ) -> Result<Option<(Record, Picture)>, Failure> {
        let Race { budgets, threads, points, .. } = self.race;
        let key = key_of(&(self.key, method.to_string(), seed, budgets, threads, points.name()));
        let found = self.store.numbers(key).zip(self.store.picture(key, "mean"));
        if found.is_some() {
            return Ok(found);
        }
        if !std::mem::replace(warm, true) {
            self.warm_up()?;
        }
        if self.race.stop.is_cancelled() {
            return Ok(None);
        }
        let done = self.race.run(method, seed).map_err(Failure::output)?;
        // As it would come from the store, so that it makes no difference whether it does.
        let done = done.map(|(record, picture)| (record, double(&single(&picture))));
        if let Some((record, picture)) = &done {
            self.store.keep(key, record, &[("mean", picture)]).map_err(Failure::output)?;
        }
        Ok(done)
    }

    fn warm_up(&self) -> Result<(), Failure> {
        for &method in self.methods {
            let time = Duration::from_secs_f64(WARM_UP);
            self.race.warm_up(method, time).map_err(Failure::output)?;
        }
        Ok(())
    }
}
