//! Running the table: what to render, by two threads, one cell each.

use crate::stability::cell::{self, Kept};
use crate::stability::expected::METHODS;
use crate::stability::figures::Figures;
use crate::stability::judge::{Verdict, Word, best, factor, judge};
use crate::stability::reference::Reference;
use crate::stability::scale;
use crate::stability::scene::{FailureScene, SCENES};
use crate::stability::table::Judged;
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use traylib_integrators::{BlindSpot, Method, SceneFacts};
use traylib_known::cost::seconds_per_pass;
use traylib_scene::Scene;

/// Cells rendered at a time, each by one thread.
const AT_A_TIME: usize = 2;

/// The choice of what is to be done.
#[derive(Clone, Debug, Default)]
pub struct Choice {
    /// One scene by its name, or all.
    pub scene: Option<String>,
    /// One method of the table, or all.
    pub method: Option<Method>,
    /// An eighth of the passes.
    pub quick: bool,
}

/// Pictures of a row: what it should be, and what each method has after the
/// same time.
#[derive(Clone, Debug)]
pub struct Pictures {
    /// The reference.
    pub reference: Reference,
    /// For each method, of the first run: passes and pixels.
    pub equal_time: Vec<(Method, u32, Vec<f64>)>,
}

/// A row of the table.
#[derive(Clone, Debug)]
pub struct Row {
    /// The cells.
    pub cells: Vec<Judged>,
    /// The pictures of the cells; `None` for F11.
    pub pictures: Option<Pictures>,
}

/// A scene that is ready.
struct Prepared {
    row: FailureScene,
    scene: Scene,
    reference: Reference,
}

/// Renders and judges all that was chosen; `tell` is called with a line a cell.
pub fn run(choice: &Choice, tell: &(dyn Fn(&str) + Sync)) -> Vec<Row> {
    let chosen: Vec<&FailureScene> = SCENES.iter().filter(|row| choice.scene(row.id)).collect();
    let methods: Vec<Method> =
        METHODS.into_iter().filter(|method| choice.method(*method)).collect();
    let prepared = in_parallel(&chosen, |row| {
        let scene = row.build();
        let reference = Reference::of(row, &scene);
        tell(&format!("{} reference, mean {:.5}", row.id, reference.mean()));
        Prepared { row: choice.shortened(row), scene, reference }
    });
    let cells: Vec<(usize, Method)> = (0..prepared.len())
        .flat_map(|row| methods.iter().map(move |&method| (row, method)))
        .collect();
    let kept = in_parallel(&cells, |&(row, method)| prepared[row].render(method, tell));
    let mut by_row: BTreeMap<usize, Vec<(Method, Option<Kept>)>> = BTreeMap::new();
    for ((row, method), kept) in cells.into_iter().zip(kept) {
        by_row.entry(row).or_default().push((method, kept));
    }
    let mut rows: Vec<Row> =
        by_row.into_iter().map(|(row, cells)| prepared[row].judge(&cells)).collect();
    if choice.scene("F11") {
        let at = rows.iter().position(|row| row.cells[0].scene == "F12").unwrap_or(rows.len());
        rows.insert(at, Row { cells: in_parallel(&methods, |&c| scaled(c)), pictures: None });
    }
    rows
}

impl Choice {
    fn scene(&self, id: &str) -> bool {
        self.scene.as_ref().is_none_or(|wanted| wanted.eq_ignore_ascii_case(id))
    }

    fn method(&self, method: Method) -> bool {
        self.method.is_none_or(|wanted| wanted == method)
    }

    fn shortened(&self, row: &FailureScene) -> FailureScene {
        let passes = if self.quick { (row.passes / 8).max(32) } else { row.passes };
        FailureScene { passes, ..*row }
    }
}

impl Prepared {
    fn announced(&self, method: Method) -> Vec<BlindSpot> {
        method.up_to(self.row.max_depth).build().blind_spots(&SceneFacts::of(&self.scene))
    }

    /// `None` where the method is not for lamps like these, and says so.
    fn render(&self, method: Method, tell: &(dyn Fn(&str) + Sync)) -> Option<Kept> {
        let announced = self.announced(method).contains(&BlindSpot::AreaLights);
        if announced && self.row.has_area_lights_only() {
            return None;
        }
        let mut kept =
            cell::run(&self.scene, &self.reference, method, self.row.max_depth, self.row.passes);
        let integrator = method.up_to(self.row.max_depth).build();
        kept.seconds = seconds_per_pass(&self.scene, integrator.as_ref());
        let speed = kept.seconds * 1e3;
        tell(&format!("{} {}, {speed:.2} ms a pass", self.row.id, method));
        Some(kept)
    }

    fn judge(&self, cells: &[(Method, Option<Kept>)]) -> Row {
        let figures: Vec<Option<Figures>> = cells
            .iter()
            .map(|(_, kept)| kept.as_ref().map(|kept| Figures::of(kept, &self.reference)))
            .collect();
        let best = best(figures.iter().flatten());
        let judged = cells.iter().zip(&figures).map(|(&(method, _), figures)| {
            let announced = self.announced(method);
            let concerns = announced.iter().any(|spot| self.row.light.contains(spot));
            let word = if concerns { Word::Announced } else { Word::Sees };
            let verdict = figures
                .as_ref()
                .map_or(Verdict::NotApplicable, |figures| judge(figures, word, best));
            let factor = figures.as_ref().zip(best).map(|(figures, best)| factor(figures, best));
            Judged {
                scene: self.row.id.into(),
                title: self.row.title.into(),
                method,
                verdict,
                factor,
                figures: figures.clone(),
                announced: announced.iter().map(ToString::to_string).collect(),
            }
        });
        Row { cells: judged.collect(), pictures: Some(self.pictures(cells)) }
    }

    /// After as long as the slowest method needs for 16 passes, to the next
    /// power of two of passes.
    fn pictures(&self, cells: &[(Method, Option<Kept>)]) -> Pictures {
        let rendered = || cells.iter().filter_map(|(method, kept)| Some((*method, kept.as_ref()?)));
        let seconds = 16.0 * rendered().map(|(_, kept)| kept.seconds).fold(0.0, f64::max);
        let picture = |(method, kept): (Method, &Kept)| {
            let level = (seconds / kept.seconds).log2().round() as usize;
            let level = level.min(kept.last_level());
            (method, 1 << level, kept.picture(0, level))
        };
        let equal_time = rendered().map(picture).collect();
        Pictures { reference: self.reference.clone(), equal_time }
    }
}

fn scaled(method: Method) -> Judged {
    let differences = scale::differences(method);
    let verdict = if differences.is_empty() {
        Verdict::Identical
    } else {
        Verdict::Unsettled(format!("another picture at 2 to the power of {differences:?}"))
    };
    Judged {
        scene: "F11".into(),
        title: "scaled by powers of two".into(),
        method,
        verdict,
        factor: None,
        figures: None,
        announced: Vec::new(),
    }
}

/// `task` of each item, in the order of the items.
fn in_parallel<T: Sync, R: Send>(items: &[T], task: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let results: Mutex<BTreeMap<usize, R>> = Mutex::default();
    std::thread::scope(|scope| {
        for _ in 0..AT_A_TIME {
            scope.spawn(|| {
                while let Some((index, item)) = take(items, &next) {
                    let result = task(item);
                    results.lock().expect("no task panics with it").insert(index, result);
                }
            });
        }
    });
    results.into_inner().expect("all tasks are done").into_values().collect()
}

fn take<'a, T>(items: &'a [T], next: &AtomicUsize) -> Option<(usize, &'a T)> {
    let index = next.fetch_add(1, Ordering::Relaxed);
    Some((index, items.get(index)?))
}
