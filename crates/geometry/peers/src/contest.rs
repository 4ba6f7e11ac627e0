//! Building, and casting in turn.

use crate::clock;
use crate::contestant::{Built, Contestant, Found};
use crate::heap;
use crate::reference::Reference;
use crate::statistics::Median;
use crate::support::rays::RaySets;
use crate::support::room::Room;
use std::hint::black_box;
use traylib_geometry::{Mesh, Ray};

/// A contestant with a room.
pub(crate) struct Entry {
    name: &'static str,
    built: Box<dyn Built>,
}

/// The time and memory that building took.
pub(crate) struct Build {
    pub(crate) name: &'static str,
    /// The time of all threads together.
    pub(crate) seconds: Median,
    pub(crate) bytes: usize,
}

/// Rays, and what the reference says of them.
pub(crate) struct RaySet {
    pub(crate) name: &'static str,
    rays: Vec<Ray>,
    question: Question,
}

enum Question {
    /// t of each nearest hit.
    Nearest(Vec<Option<f64>>),
    AnyHit(Vec<bool>),
}

/// The result of a contestant with a set of rays.
pub(crate) struct Score {
    pub(crate) name: &'static str,
    /// Millions of rays a second.
    pub(crate) rate: Median,
    /// The factors by which our own are faster, watertight and fast; both are the first two of the
    /// list.
    pub(crate) ours_to_it: [Median; 2],
    /// Rays answered otherwise than by the reference.
    pub(crate) wrong: usize,
}

/// Builds a room for everyone, up to nine times each while that takes under a second.
pub(crate) fn build_all(
    mesh: &Mesh,
    contestants: &[Contestant],
) -> Result<(Vec<Entry>, Vec<Build>), String> {
    let entries = contestants.iter().map(|contestant| {
        let name = contestant.name;
        let mut times = Vec::new();
        let (built, bytes) = loop {
            let (bytes, start) = (heap::bytes(), clock::process_seconds());
            let built = contestant.build(mesh)?;
            times.push(clock::process_seconds() - start);
            if times.len() == 9 || times.iter().sum::<f64>() > 1.0 {
                let grown = heap::bytes().saturating_sub(bytes);
                break (built, grown);
            }
        };
        let bytes = bytes + built.bytes_elsewhere();
        Ok((Entry { name, built }, Build { name, seconds: Median::of(times), bytes }))
    });
    entries.collect()
}

/// The rays of a room, with answers in double precision.
pub(crate) fn ray_sets(room: &Room, side: u32) -> Vec<RaySet> {
    let reference = Reference::new(&room.mesh);
    let exact = |ray: &Ray| reference.nearest(ray).map(|(t, _)| t);
    let found = |ray: &Ray| reference.nearest(ray).map(|(t, triangle)| (t as f32, triangle));
    let RaySets { primary, bounces, shuffled, shadow } = RaySets::new(room, side, found);
    let nearest = |name, rays: Vec<Ray>| {
        let question = Question::Nearest(rays.iter().map(exact).collect());
        RaySet { name, rays, question }
    };
    let any = shadow.iter().map(|ray| exact(ray).is_some()).collect();
    vec![
        nearest("primary", primary),
        nearest("bounces", bounces),
        nearest("bounces in random order", shuffled),
        RaySet { name: "shadow", rays: shadow, question: Question::AnyHit(any) },
    ]
}

impl RaySet {
    pub(crate) fn len(&self) -> usize {
        self.rays.len()
    }

    /// Returns the number of wrong answers. Also warms up. Also warms up.
    ///
    /// t is wrong when it is off by more than a thousandth, which is ten thousand
    /// roundings: only rays that almost slide along a surface lose more.
    fn wrong(&self, built: &mut dyn Built) -> usize {
        match &self.question {
            Question::Nearest(exact) => {
                let mut found = vec![Found::NOTHING; self.rays.len()];
                built.nearest(&self.rays, &mut found);
                let agree = |(found, exact): &(&Found, &Option<f64>)| match exact {
                    Some(t) => (found.t as f64 - t).abs() <= 1e-3 * t,
                    None => **found == Found::NOTHING,
                };
                found.iter().zip(exact).filter(|pair| !agree(pair)).count()
            }
            Question::AnyHit(exact) => {
                let mut found = vec![false; self.rays.len()];
                built.any_hit(&self.rays, &mut found);
                found.iter().zip(exact).filter(|(found, exact)| found != exact).count()
            }
        }
    }

    /// Seconds of this thread for all rays.
    fn time(&self, built: &mut dyn Built, found: &mut [Found], any: &mut [bool]) -> f64 {
        let start = clock::thread_seconds();
        match self.question {
            Question::Nearest(_) => built.nearest(black_box(&self.rays), found),
            Question::AnyHit(_) => built.any_hit(black_box(&self.rays), any),
        }
        clock::thread_seconds() - start
    }
}

/// Everyone casts all rays, in turn, `runs` times; each time somebody else begins.
pub(crate) fn run(entries: &mut [Entry], set: &RaySet, runs: u16) -> Vec<Score> {
    let wrong: Vec<_> = entries.iter_mut().map(|e| set.wrong(e.built.as_mut())).collect();
    let (mut found, mut any) = (vec![Found::NOTHING; set.len()], vec![false; set.len()]);
    let mut times = vec![Vec::new(); entries.len()];
    for run in 0..usize::from(runs) {
        for place in 0..entries.len() {
            let who = (run + place) % entries.len();
            times[who].push(set.time(entries[who].built.as_mut(), &mut found, &mut any));
        }
    }
    let score = |(who, entry): (usize, &Entry)| score(entry.name, &times, who, set, wrong[who]);
    entries.iter().enumerate().map(score).collect()
}

fn score(name: &'static str, times: &[Vec<f64>], who: usize, set: &RaySet, wrong: usize) -> Score {
    let rate = times[who].iter().map(|time| set.len() as f64 * 1e-6 / time).collect();
    // Of the same round: what disturbs the machine longer than that disturbs both.
    let ratio = |ours: usize| {
        Median::of(times[who].iter().zip(&times[ours]).map(|(its, ours)| its / ours).collect())
    };
    Score { name, rate: Median::of(rate), ours_to_it: [ratio(0), ratio(1)], wrong }
}
