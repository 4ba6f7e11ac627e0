//! All scenes of a run, some at a time.

use crate::relations::case::Known;
use crate::relations::draw::{self, Dice};
use crate::relations::judge::{First, Verdict, judge};
use crate::relations::relation::{Relation, Subject};
use crate::relations::render::Workshop;
use crate::relations::scene::DrawnScene;
use crate::relations::shrink::shrink;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// The plan of a run.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Numbers of the scenes.
    pub scenes: std::ops::Range<u64>,
    /// Another seed, other scenes.
    pub seed: u64,
    /// Passes of the first look.
    pub passes: u32,
    /// The number of changes that are tried on each scene, and whether all other relations are.
    pub changes: usize,
    /// Only this relation.
    pub only: Option<Relation>,
    /// No rendering may take longer.
    pub patience: Duration,
    /// The time for which a smaller scene is looked for, if at all.
    pub shrink: Option<Duration>,
    /// Scenes at a time.
    pub threads: usize,
}

impl Default for Plan {
    fn default() -> Self {
        Self {
            scenes: 0..5000,
            seed: 1,
            passes: 128,
            changes: 6,
            only: None,
            patience: Duration::from_mins(1),
            shrink: Some(Duration::from_secs(20)),
            threads: 2,
        }
    }
}

/// The outcome of one relation on one scene.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The scene's number.
    pub scene: u64,
    /// The scene.
    pub drawn: DrawnScene,
    /// A smaller one that breaks the same relation, with what came of that.
    pub smallest: Option<Box<Outcome>>,
    /// The relation.
    pub relation: Relation,
    /// The claim in words; empty if the relation could not be tried.
    pub what: String,
    /// The verdict on it.
    pub verdict: Verdict,
}

/// The outcome of a run.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// Scenes drawn.
    pub scenes: u64,
    /// Claims judged.
    pub claims: u64,
    /// The claims that hold: relation, words, what the first look saw.
    pub held: Vec<(Relation, String, First)>,
    /// All others.
    pub others: Vec<Outcome>,
    /// The slowest scenes, with seconds.
    pub slowest: Vec<(u64, f64)>,
}

/// Draws and judges; `tell` is called with what does not hold, as it is found.
///
/// # Panics
/// If the folder for files cannot be made.
pub fn run(plan: &Plan, tell: &(dyn Fn(&Outcome) + Sync)) -> Summary {
    let next = AtomicU64::new(plan.scenes.start);
    let summary: Mutex<Vec<(u64, Summary)>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..plan.threads {
            scope.spawn(|| {
                let workshop = Workshop::new(plan.patience).expect("a folder for files");
                loop {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    if number >= plan.scenes.end {
                        break;
                    }
                    let of_scene = one(plan, number, &workshop);
                    of_scene.others.iter().for_each(tell);
                    summary.lock().expect("no task panics with it").push((number, of_scene));
                }
            });
        }
    });
    let mut parts = summary.into_inner().expect("all tasks are done");
    parts.sort_by_key(|(number, _)| *number);
    let mut sum = Summary::default();
    for (_, part) in parts {
        sum.add(part);
    }
    sum
}

fn one(plan: &Plan, number: u64, workshop: &Workshop) -> Summary {
    let start = Instant::now();
    let drawn = draw::scene(plan.seed, number);
    let relations = chosen(plan, &mut Dice::for_use(plan.seed, number, 0));
    let bench =
        Bench { workshop, seed: plan.seed, number, passes: plan.passes, right: None, turn: 0 };
    let mut summary = bench.judge(&drawn, &relations);
    for outcome in &mut summary.others {
        outcome.smallest = plan.shrink.and_then(|time| bench.shrink(outcome, time));
    }
    summary.scenes = 1;
    summary.slowest = vec![(number, start.elapsed().as_secs_f64())];
    summary
}

/// All relations but changes, and some of these.
fn chosen(plan: &Plan, dice: &mut Dice) -> Vec<Relation> {
    let mut changes = Relation::all();
    let others = changes.extract_if(.., |relation| !matches!(relation, Relation::Changed(_)));
    let others: Vec<Relation> = others.collect();
    dice.shuffle(&mut changes);
    changes.truncate(plan.changes);
    let all = others.into_iter().chain(changes);
    match plan.only {
        None => all.collect(),
        Some(only) => vec![only],
    }
}

/// The settings with which one scene is judged.
#[derive(Clone, Copy, Debug)]
pub struct Bench<'a> {
    /// The workshop that files go to.
    pub workshop: &'a Workshop,
    /// Seed of the run.
    pub seed: u64,
    /// Number of the scene.
    pub number: u64,
    /// Passes of the first look.
    pub passes: u32,
    /// The mean that is known of the scene.
    pub right: Option<Known>,
    /// Another number, other random numbers for the same claims.
    pub turn: u64,
}

impl Bench<'_> {
    /// Judges these relations on a scene.
    pub fn judge(&self, drawn: &DrawnScene, relations: &[Relation]) -> Summary {
        let mut summary = Summary::default();
        let outcome = |relation: Relation, what: &str, verdict: Verdict| Outcome {
            scene: self.number,
            drawn: drawn.clone(),
            smallest: None,
            relation,
            what: what.into(),
            verdict,
        };
        let subject = match Subject::new(drawn, self.workshop) {
            Ok(subject) => Subject { right: self.right, ..subject },
            Err(trouble) => {
                let failed = Verdict::Failed(trouble);
                summary.others.push(outcome(Relation::Methods, "the scene can be loaded", failed));
                return summary;
            }
        };
        for &relation in relations {
            let claims = match relation.claims(&subject, &mut relation.dice(self.seed, self.number))
            {
                Ok(claims) => claims,
                Err(trouble) => {
                    let failed = Verdict::Failed(trouble);
                    summary.others.push(outcome(relation, "the other form can be loaded", failed));
                    continue;
                }
            };
            for claim in claims {
                summary.claims += 1;
                match judge(&claim, self.workshop, self.passes, self.numbers()) {
                    Verdict::Holds(first) => summary.held.push((relation, claim.what, first)),
                    verdict @ (Verdict::Broken(_) | Verdict::Failed(_)) => {
                        summary.others.push(outcome(relation, &claim.what, verdict));
                    }
                }
            }
        }
        summary
    }

    /// The seed of all renderings.
    fn numbers(&self) -> u64 {
        self.seed ^ (self.number << 20) ^ (self.turn << 50)
    }

    /// A smaller scene on which the same relation is broken, with other random
    /// numbers and twice as many passes.
    fn shrink(&self, outcome: &Outcome, time: Duration) -> Option<Box<Outcome>> {
        let failed = matches!(outcome.verdict, Verdict::Failed(_));
        let mut last = None;
        let mut tried = 0;
        shrink(&outcome.drawn, time, |candidate| {
            tried += 1;
            let stricter = Bench { passes: 2 * self.passes, turn: tried, right: None, ..*self };
            let summary = stricter.judge(candidate, &[outcome.relation]);
            let alike = |other: &Outcome| matches!(other.verdict, Verdict::Failed(_)) == failed;
            let found = summary.others.into_iter().find(alike);
            let is_broken = found.is_some();
            last = found.or(last.take());
            is_broken
        });
        last.map(Box::new)
    }
}

impl Summary {
    fn add(&mut self, part: Self) {
        self.scenes += part.scenes;
        self.claims += part.claims;
        self.held.extend(part.held);
        self.others.extend(part.others);
        self.slowest.extend(part.slowest);
        self.slowest.sort_by(|a, b| b.1.total_cmp(&a.1));
        self.slowest.truncate(10);
    }
}
