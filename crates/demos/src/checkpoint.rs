//! Checkpoints: the film that is kept of a rendering, to go on with.

mod about;

pub(crate) use about::{SHARD, picture_info, shard, spp};

use crate::job::Job;
use crate::outcome::Failure;
use crate::plan::Plan;
use crate::say::say;
use crate::shard::Shard;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use traylib_integrators::Statistics;
use traylib_io::{Error, FilmAbout, Loaded, load_film, save_film};
use traylib_scene::Film;

/// Without a wish, checkpoints are so far apart and more.
const EVERY: Duration = Duration::from_mins(1);

/// Without a wish, the time between them is so many times what the last one took.
const TIMES_COST: u32 = 99;

/// The file in which a rendering is kept.
#[derive(Debug)]
pub(crate) struct Checkpoint<'a> {
    file: &'a Path,
    previous: PathBuf,
    every: Option<Duration>,
    /// The film's description, with the counters of the runs before.
    about: FilmAbout,
    /// The time at which the last one was written, and how long that took.
    last: Option<(Instant, Duration)>,
    /// Passes that are in the file.
    saved: Option<u32>,
}

impl<'a> Checkpoint<'a> {
    /// Makes the checkpoint of a job, if it wants one.
    pub(crate) fn of(job: &Job<'a>, loaded: &Loaded, plan: &Plan) -> Option<Self> {
        let options = &job.options.keep;
        let file = options.checkpoint.as_deref()?;
        let about = about::about(job, loaded, plan);
        let previous = previous(file);
        let every = options.checkpoint_every;
        Some(Self { file, previous, every, about, last: None, saved: None })
    }

    /// Returns the film to go on from, if that is wanted; says how much of it is done.
    ///
    /// # Errors
    /// There is a film and it is of another rendering, damaged, or not wanted.
    pub(crate) fn begin(&mut self, job: &Job<'_>, plan: &Plan) -> Result<Option<Film>, Failure> {
        let options = job.options;
        // Whoever was killed between two names has left only the older one.
        let is_there = self.file.exists();
        let file = if is_there { self.file } else { self.previous.as_path() };
        if !options.keep.resume {
            return if is_there {
                Err(Failure::usage(format_args!(
                    "{}: there is a checkpoint already; go on from it with --resume, or remove it",
                    self.file.display()
                )))
            } else {
                Ok(None)
            };
        }
        if !file.exists() {
            return Ok(None);
        }
        let (film, about) = load_film(file).map_err(|error| self.damaged(error))?;
        self.check(file, &film, &about, plan)?;
        self.about.counters = about.counters;
        self.saved = is_there.then_some(film.passes());
        if !options.quiet {
            let (done, wanted) = (film.passes(), plan.spp.map(|_| plan.passes.len()));
            let of = wanted.map_or_else(String::new, |wanted| format!(" of {wanted}"));
            say(format_args!("going on from {}: {done}{of} passes are done", file.display()));
        }
        Ok(Some(film))
    }

    /// Tells whether it is a film of this rendering, and of this part of it.
    fn check(
        &self,
        file: &Path,
        film: &Film,
        about: &FilmAbout,
        plan: &Plan,
    ) -> Result<(), Failure> {
        let unfit = |why: String| {
            Failure::unfit(format_args!("{}: is not of this rendering: {why}", file.display()))
        };
        if let Some(difference) = about.difference(&self.about) {
            let [found, wanted] = &difference.words;
            return Err(unfit(format!("its {} is {found}, not {wanted}", difference.name)));
        }
        let is_wanted = |pass: &u32| plan.passes.contains(pass);
        match film.pass_numbers().into_iter().find(|pass| !is_wanted(pass)) {
            None => Ok(()),
            Some(pass) if plan.shard == Shard::WHOLE => Err(unfit(format!(
                "it has {} passes, pass {pass} among them, and {} are wanted",
                film.passes(),
                plan.passes.len()
            ))),
            Some(pass) => Err(unfit(format!(
                "it has pass {pass}, and part {} has passes {} to {}",
                plan.shard,
                plan.passes.start,
                i64::from(plan.passes.end) - 1
            ))),
        }
    }

    /// Describes the damage of the newest one, and whether the one before is any better.
    fn damaged(&self, error: Error) -> Failure {
        let whole = if self.file.exists() { load_film(&self.previous).ok() } else { None };
        match whole {
            Some((film, _)) => Failure::scene(format_args!(
                "{error}; {} is whole, with {} passes: rename it to go on from there",
                self.previous.display(),
                film.passes()
            )),
            None => error.into(),
        }
    }

    /// Tells whether it is time to write a film.
    pub(crate) fn is_due(&self, film: &Film) -> bool {
        let is_time = self.last.is_none_or(|(when, cost)| {
            when.elapsed() >= self.every.unwrap_or_else(|| EVERY.max(TIMES_COST * cost))
        });
        film.passes() > 0 && is_time
    }

    /// Writes the film unless the file has it; the statistics are those of this run.
    ///
    /// # Errors
    /// It cannot be written. The file is as it was.
    pub(crate) fn save(&mut self, film: &Film, statistics: Statistics) -> Result<(), Failure> {
        if self.saved == Some(film.passes()) {
            return Ok(());
        }
        let start = Instant::now();
        let about = FilmAbout { counters: self.counters(statistics), ..self.about.clone() };
        save_film(self.file, Some(&self.previous), film, &about)?;
        self.saved = Some(film.passes());
        self.last = Some((Instant::now(), start.elapsed()));
        Ok(())
    }

    /// Returns the counters of all runs, with those of this one.
    fn counters(&self, statistics: Statistics) -> Vec<(String, u64)> {
        about::counters(&self.about.counters, statistics)
    }

    /// Samples that were left out in runs before.
    pub(crate) fn rejected_before(&self) -> u64 {
        about::rejected(&self.about)
    }
}

/// The name by which the one before is kept.
fn previous(file: &Path) -> PathBuf {
    let mut name = OsString::from(file);
    name.push(".previous");
    PathBuf::from(name)
}
