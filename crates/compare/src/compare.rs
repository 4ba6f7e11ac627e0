//! The whole comparison, from options to results.

mod field;
mod outcome;
mod part;

use crate::csv;
use crate::how::build_key;
use crate::judge::Entry;
use crate::lengths::lengths;
use crate::method::suits;
use crate::options::{ORACLE, Options};
use crate::oracle::oracle;
use crate::outside::{self, OutsideEntry};
use crate::picture::double;
use crate::pictures::ScenePictures;
use crate::prepare::{Prepared, prepare};
use crate::progress::Plan;
use crate::race::{Field, OVERHEAD, race};
use crate::reference::{Making, Reference, make};
use crate::results::{How, LengthShare, Results, SceneResults};
use crate::run::Race;
use crate::store::{Store, key_of};
use crate::techniques::technique_pictures;
pub use part::{references, runs};

use outcome::{finished, shown, told, told_without};
use std::ops::Range;
use std::path::Path;
use std::time::Instant;
use traylib_demos::{Failure, say};
use traylib_integrators::{Control, Method};
use traylib_io::{LoadOptions, load_scene_with};
use traylib_math::{Grid, Rgb};

/// Each of the two methods of a reference takes as long as so many of the longest runs, so that
/// its own error is small beside theirs.
const REFERENCE_LENGTH: f64 = 25.0;

/// The outcome of a comparison: results and pictures.
#[derive(Debug)]
pub struct Comparison {
    /// The numbers.
    pub results: Results,
    /// The pictures, in the order of the scenes.
    pub pictures: Vec<ScenePictures>,
    /// `results.csv`; empty if there was no run.
    pub csv: String,
}

/// Compares; what is done when `stop` is raised is kept.
///
/// # Errors
/// A scene makes no sense, the system refuses threads, or nothing can be written.
pub fn compare(options: &Options, how: How, stop: &Control) -> Result<Comparison, Failure> {
    options.check()?;
    let work = Work::prepare(options, &how, stop)?;
    let plan = Plan::new(work.seconds());
    let comparison = work.all(how, &plan);
    plan.clear();
    comparison
}

struct Work<'a> {
    options: &'a Options,
    scenes: Vec<Prepared>,
    with_oracle: bool,
    outside: Vec<OutsideEntry>,
    methods: Vec<Method>,
    budgets: Vec<f64>,
    references: Store,
    runs: Store,
    /// The program itself: another build may render something else, or faster.
    build: u64,
    /// The key of everything else that decides the result of a run: the build, the processor and
    /// the threads.
    key: u64,
    stop: &'a Control,
    start: Instant,
}

impl<'a> Work<'a> {
    /// Prepares a comparison; everything that can go wrong early does so here.
    fn prepare(options: &'a Options, how: &How, stop: &'a Control) -> Result<Self, Failure> {
        let asked = options.scenes();
        let rendered = asked.iter().filter(|scene| *scene != ORACLE);
        let scenes: Vec<Prepared> =
            rendered.map(|scene| prepare(scene, options)).collect::<Result<_, _>>()?;
        field::check_names(&scenes)?;
        field::check_fit(&options.methods, &scenes)?;
        for (file, scene) in options.reference.iter().zip(&scenes) {
            outside::warn_of_another(file, &scene.loaded.name);
        }
        let outside = options.outside.as_deref().map(|file| outside(file, &scenes)).transpose()?;
        let build = build_key();
        let store = |folder: std::path::PathBuf| Store::open(folder).map_err(Failure::output);
        Ok(Self {
            options,
            scenes,
            with_oracle: asked.iter().any(|scene| scene == ORACLE),
            outside: outside.unwrap_or_default(),
            methods: options.methods(),
            budgets: options.budgets(),
            references: store(options.folder().join("references"))?,
            runs: store(options.folder().join("runs"))?,
            build,
            key: key_of(&(build, &how.processor, how.threads)),
            stop,
            start: Instant::now(),
        })
    }

    fn all(&self, how: How, plan: &Plan) -> Result<Comparison, Failure> {
        let mut scenes = Vec::new();
        let mut pictures = Vec::new();
        let mut csv = String::new();
        for prepared in &self.scenes {
            warn(prepared);
            if let Some((results, shown, lines)) = self.scene(prepared, plan)? {
                scenes.push(results);
                pictures.push(shown);
                csv += &lines;
            }
        }
        let oracle = (self.with_oracle && !self.stopped()).then(|| {
            plan.begin(ORACLE);
            oracle(self.options.quick, &|text| plan.detail(text))
        });
        if !csv.is_empty() {
            csv.insert_str(0, csv::HEADER);
        }
        let how = How { seconds: self.start.elapsed().as_secs_f64(), ..how };
        let complete = !self.stopped();
        Ok(Comparison { results: Results { how, scenes, oracle, complete }, pictures, csv })
    }

    /// One scene; `None` if it was stopped before there was anything to judge.
    fn scene(
        &self,
        prepared: &Prepared,
        plan: &Plan,
    ) -> Result<Option<(SceneResults, ScenePictures, String)>, Failure> {
        plan.begin(&prepared.loaded.name);
        let Some(reference) = self.reference(prepared, plan)? else { return Ok(None) };
        if let Some(why) = reference.nothing_to_compare() {
            let pictures = shown(prepared, &reference, &[], Vec::new(), Vec::new());
            let results = told_without(prepared, reference, &why);
            return Ok(Some((results, pictures, String::new())));
        }
        let methods = self.methods_on(prepared);
        let all = self.runs(prepared, &reference, 0..self.options.seeds(), plan)?;
        let first_seed = self.options.first_seed;
        let lines = csv::lines(&prepared.loaded.name, &all, &reference, first_seed);
        let entries = finished(&prepared.loaded.name, all);
        let outside = outside::measure(&self.outside, &prepared.loaded.name, &reference)?;
        let techniques = self.techniques(prepared, &methods, plan)?;
        let lengths = self.lengths(prepared, &methods, &reference, plan)?;
        let (points, outside): (Vec<_>, Vec<_>) = outside.into_iter().unzip();
        let pictures = shown(prepared, &reference, &entries, outside, techniques);
        let results = told(prepared, reference, &entries, points, lengths);
        Ok(results.map(|results| (results, pictures, lines)))
    }

    /// Does so many runs of each method, as far as they are not done yet.
    fn runs(
        &self,
        prepared: &Prepared,
        reference: &Reference,
        turns: Range<u32>,
        plan: &Plan,
    ) -> Result<Vec<Entry>, Failure> {
        let field = Field {
            race: Race {
                scene: &prepared.loaded.scene,
                reference,
                budgets: &self.budgets,
                threads: self.options.threads,
                points: self.options.sampler,
                stop: self.stop,
            },
            key: key_of(&(self.key, prepared.key, reference.picture.values())),
            methods: &self.methods_on(prepared),
            turns,
            first_seed: self.options.first_seed,
            store: &self.runs,
        };
        race(&field, plan)
    }

    fn methods_on(&self, prepared: &Prepared) -> Vec<Method> {
        self.methods.iter().copied().filter(|&method| suits(method, &prepared.facts)).collect()
    }

    fn reference(&self, prepared: &Prepared, plan: &Plan) -> Result<Option<Reference>, Failure> {
        if let Some(known) = self.known_reference(prepared)? {
            return Ok(Some(known));
        }
        let tell = |method| plan.detail(&format!("reference by {method}"));
        let made = make(&self.making(prepared), &tell);
        plan.done(2.0 * self.reference_seconds());
        made.map_err(Failure::output)
    }

    /// One that needs no rendering.
    fn known_reference(&self, prepared: &Prepared) -> Result<Option<Reference>, Failure> {
        let size = prepared.size();
        if let (Some(given), Some(file)) = (&prepared.given, &self.options.reference) {
            outside::same_size(file, given, size)?;
            let origin = format!("the picture {}", file.display());
            return Ok(Some(Reference::given(double(given), origin)));
        }
        let radiance = prepared.closed_form();
        Ok(radiance.map(|radiance| Reference::constant(size.0, size.1, radiance)))
    }

    fn making<'s>(&'s self, prepared: &'s Prepared) -> Making<'s> {
        Making {
            scene: &prepared.loaded.scene,
            scene_key: key_of(&(self.build, prepared.key)),
            seconds: self.reference_seconds(),
            threads: self.options.threads,
            stop: self.stop,
            store: &self.references,
        }
    }

    fn reference_seconds(&self) -> f64 {
        REFERENCE_LENGTH * self.budgets.last().copied().unwrap_or(0.0)
    }

    fn techniques(
        &self,
        prepared: &Prepared,
        methods: &[Method],
        plan: &Plan,
    ) -> Result<Vec<(traylib_integrators::Technique, Grid<Rgb>)>, Failure> {
        if self.stopped() || !with_bdpt(methods) {
            return Ok(Vec::new());
        }
        plan.detail("techniques of bdpt");
        let camera = prepared.loaded.scene.camera();
        let rows = THUMBNAIL * camera.height() / camera.width();
        let load =
            LoadOptions { resolution: Some((THUMBNAIL, rows.max(1))), ..LoadOptions::default() };
        let small = load_scene_with(&prepared.asked, load)?;
        let passes = if self.options.quick { 64 } else { 512 };
        technique_pictures(&small.scene, passes).map_err(Failure::output)
    }

    fn lengths(
        &self,
        prepared: &Prepared,
        methods: &[Method],
        reference: &Reference,
        plan: &Plan,
    ) -> Result<Vec<LengthShare>, Failure> {
        if self.stopped() || !with_bdpt(methods) {
            return Ok(Vec::new());
        }
        plan.detail("path lengths of bdpt");
        let passes = if self.options.quick { 16 } else { 64 };
        lengths(&prepared.loaded.scene, reference.epsilon, passes).map_err(Failure::output)
    }

    /// Returns the planned seconds of the comparison, references included.
    fn seconds(&self) -> f64 {
        self.references_seconds() + self.runs_seconds(self.options.seeds())
    }

    fn references_seconds(&self) -> f64 {
        2.0 * self.reference_seconds() * self.scenes.len() as f64
    }

    /// Returns the planned seconds of `turns` runs of each method.
    fn runs_seconds(&self, turns: u32) -> f64 {
        let longest = self.budgets.last().copied().unwrap_or(0.0);
        let methods: usize = self.scenes.iter().map(|scene| self.methods_on(scene).len()).sum();
        f64::from(turns) * longest * OVERHEAD * methods as f64
    }

    fn stopped(&self) -> bool {
        self.stop.is_cancelled()
    }
}

/// The pictures of other programs, all of scenes that exist.
fn outside(file: &Path, scenes: &[Prepared]) -> Result<Vec<OutsideEntry>, Failure> {
    let entries = outside::read(file)?;
    let compared: Vec<&str> = scenes.iter().map(|scene| scene.loaded.name.as_str()).collect();
    if let Some(warning) = outside::check_scenes(file, &entries, &compared)? {
        say(format_args!("warning: {warning}"));
    }
    for prepared in scenes {
        outside::check_pictures(&entries, &prepared.loaded.name, prepared.size())?;
    }
    Ok(entries)
}

/// Columns of the pictures of techniques.
const THUMBNAIL: u32 = 64;

fn with_bdpt(methods: &[Method]) -> bool {
    methods.contains(&Method::BDPT)
}

fn warn(prepared: &Prepared) {
    for warning in &prepared.loaded.warnings {
        say(format_args!("warning: {}: {warning}", prepared.loaded.name));
    }
}
