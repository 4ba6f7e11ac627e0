//! The results of a comparison, as plain data: `results.json` is this, and the page, the table and
//! the chart are made from it and from pictures alone.
//!
//! Errors are relMSE with the noise of the reference taken off, times are seconds
//! of rendering with all threads, without loading, film output and the metrics
//! themselves.

use serde::{Deserialize, Serialize};
pub use traylib_statistics::{Estimate, NOTHING_KNOWN};

/// A whole comparison.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// The way the comparison was made.
    pub how: How,
    /// The results on each scene.
    pub scenes: Vec<SceneResults>,
    /// Measurement against theory.
    pub oracle: Option<Oracle>,
    /// `false` if it was interrupted and something is missing.
    pub complete: bool,
}

impl Results {
    /// Tells whether nothing at all was found.
    pub fn is_empty(&self) -> bool {
        self.scenes.is_empty() && self.oracle.is_none()
    }
}

/// The way a comparison was made: machine, program and settings.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct How {
    /// The command that repeats it.
    pub command: String,
    /// Name and version of the program.
    pub program: String,
    /// The commit it was built from, as of `--version`, where that is known.
    pub commit: Option<String>,
    /// The processor's own name.
    pub processor: String,
    /// Threads of each render.
    pub threads: usize,
    /// The source of the runs' random numbers, as `--sampler` spells it.
    pub sampler: String,
    /// Runs of each method.
    pub seeds: u32,
    /// Seed of the first.
    pub first_seed: u64,
    /// The times at which each run is looked at, in seconds; it ends with the last.
    pub budgets: Vec<f64>,
    /// Seconds for everything, work that was found done included.
    pub seconds: f64,
}

/// The results on one scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SceneResults {
    /// The scene's name.
    pub name: String,
    /// Columns of its pictures here.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Primitives in the scene.
    pub primitives: u64,
    /// Lamps with an area, and the sky if there is one.
    pub area_lights: u64,
    /// Point lights.
    pub point_lights: u64,
    /// Reading the file and building its tree, in seconds.
    pub load_seconds: f64,
    /// Bytes that the scene holds.
    pub scene_bytes: u64,
    /// ε of relMSE: mean (x − r)²/(r² + ε).
    pub epsilon: f64,
    /// The reference that pictures were held against.
    pub reference: ReferenceResults,
    /// The answer.
    pub verdict: Verdict,
    /// Every method, as they were asked for; empty where the reference is such that
    /// nothing can be compared.
    pub methods: Vec<MethodResults>,
    /// Pictures of other programs.
    pub outside: Vec<OutsidePoint>,
    /// Shares by path length, one edge first; the last stands for all longer ones.
    /// Empty where nobody looked.
    pub lengths: Vec<LengthShare>,
}

/// The reference that pictures were held against.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReferenceResults {
    /// Its origin, in words that end a sentence "The reference is …".
    pub origin: String,
    /// Its own relMSE, estimated from its passes; zero for a closed form.
    pub own_error: f64,
    /// Seconds that it took when it was rendered.
    pub seconds: f64,
    /// The agreement of two methods on it, where two made it.
    pub agreement: Option<ReferenceAgreement>,
    /// The method whose runs say that it is noisy or shows another scene: there is then
    /// no verdict, and no time to any error. Only a picture that was given is doubted.
    pub doubted_by: Option<String>,
}

/// Two methods render the same picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ReferenceAgreement {
    /// The two.
    pub methods: [String; 2],
    /// Mean of the first over mean of the second, and its 99.9 % interval; `None` where
    /// one has no light.
    pub mean_ratio: Option<Estimate>,
    /// Tiles compared by Welch's test.
    pub tiles: u32,
    /// The number of tiles that differ, at 0.1 % for all tiles together.
    pub refused: u32,
    /// Share of pixels left out because they see a mirror, which one of the two
    /// cannot.
    pub masked: f64,
}

/// The verdict on a scene: the method to use.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// The method that reaches a given error soonest; `None` where no factor between
    /// methods means anything, and the sentence says why.
    pub best: Option<String>,
    /// The methods that cannot be told from it, at 5 % for all pairs of the scene.
    pub rivals: Vec<String>,
    /// Both in a sentence, with the factor; and what stands against it.
    pub sentence: String,
}

/// The results of one method on one scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MethodResults {
    /// Its name with its settings, as `bdpt --max-depth 6`.
    pub name: String,
    /// True if some light is lost however long it renders, because of a limit on path lengths or
    /// because it is blind to some.
    pub biased: bool,
    /// The light that it cannot produce in such a scene, in words.
    pub blind: Vec<String>,
    /// Edges of the longest paths that it follows, where its settings limit them.
    pub longest_path: Option<u32>,
    /// Error after each power of two of passes that all runs reached.
    pub points: Vec<Point>,
    /// Error at the times of the budgets, then those of averaged runs, each twice as
    /// long as the one before.
    pub budgets: Vec<Point>,
    /// Error times seconds: what an error of one costs.
    pub cost: Estimate,
    /// Its cost over that of the best method; the intervals of all methods of the
    /// scene hold together with 95 %. One, exactly, for the best. Means nothing where
    /// the verdict knows no best.
    pub cost_ratio: Estimate,
    /// Error of one pass, were the error its noise alone.
    pub error_per_pass: Estimate,
    /// Seconds of one pass: median, shortest and longest of the runs.
    pub seconds_per_pass: Estimate,
    /// The times at which it reaches the errors that are asked for; empty where the reference is in
    /// doubt.
    pub targets: Vec<Target>,
    /// Metrics of a picture after the longest budget: means over the runs.
    pub metrics: Metrics,
    /// The rays of a pass, on average.
    pub rays: Rays,
    /// Most bytes it held while it rendered, beside scene and reference.
    pub peak_bytes: u64,
    /// The steadiness of its estimates.
    pub stability: Stability,
    /// The methods that plans chose for its runs, each once, if plans were made.
    pub plans: Vec<String>,
}

impl MethodResults {
    /// A word beside its name if it does not see all light of the scene: `blind` for
    /// what it is, `biased` for how it is set.
    pub fn badge(&self) -> Option<&'static str> {
        if !self.blind.is_empty() {
            return Some("blind");
        }
        self.biased.then_some("biased")
    }

    /// Its name, with the badge behind it where it has one.
    pub fn marked_name(&self) -> String {
        let badge = self.badge().map(|badge| format!(" ({badge})"));
        format!("{}{}", self.name, badge.unwrap_or_default())
    }
}

/// Less than this is no error but the rounding of pictures to single precision:
/// (2⁻²³)², above the square of half a unit in the last place.
pub const LEAST_ERROR: f64 = (f32::EPSILON as f64) * (f32::EPSILON as f64);

/// The error after some time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Mean number of passes.
    pub passes: f64,
    /// Median of seconds.
    pub seconds: f64,
    /// Mean relMSE, and its 95 % interval (bootstrap over the runs).
    pub error: Estimate,
    /// relMSE that one run in twenty stays below.
    pub low: f64,
    /// relMSE that one run in twenty exceeds.
    pub high: f64,
    /// The number of runs that were averaged into one picture; 1 is a run by itself.
    pub averaged: u32,
    /// True if the reference is good enough here: its own error less than 5 % of this one.
    pub solid: bool,
}

/// An error with the time at which it is reached.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Target {
    /// The error.
    pub error: f64,
    /// Seconds; `None` if never, because of what the method loses.
    pub seconds: Option<Estimate>,
}

/// Measures of difference from the reference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Metrics {
    /// relMSE, the reference's own noise taken off.
    pub rel_mse: f64,
    /// The mean without the worst 0.1 % of pixels; the reference's noise stays.
    pub trimmed_rel_mse: f64,
    /// Mean |x − r|/(|x| + |r|), from 0 to 1.
    pub smape: f64,
    /// Mean of the picture over that of the reference, less one.
    pub bias: f64,
    /// The bias in standard errors, over runs and reference.
    pub bias_z: f64,
    /// Variance between the runs over relMSE: 1 if all of the error is noise.
    pub noise_share: f64,
}

/// Rays and paths of one pass.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rays {
    /// From the camera.
    pub camera: f64,
    /// From surfaces and lamps.
    pub bounce: f64,
    /// Between two points.
    pub shadow: f64,
    /// Rays of all kinds, a second.
    pub per_second: f64,
}

/// The steadiness of a method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stability {
    /// Index of the tail of single pass values with its 95 % interval; `None`
    /// where there is no tail.
    pub tail: Option<Estimate>,
    /// True if the tail is so heavy that there is no variance: error bars are void.
    pub alarm: bool,
    /// Pixels off by more than ten deviations and a tenth of the mean, per
    /// megapixel, after the longest budget; `None` if there were not runs enough to
    /// tell.
    pub fireflies: Option<f64>,
    /// relMSE of the worst run over that of the middle one.
    pub worst_over_median: f64,
    /// Samples left out as negative or not finite, of all runs.
    pub rejected: u64,
}

/// A picture of another program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OutsidePoint {
    /// The name it was given.
    pub name: String,
    /// Its seconds, as given.
    pub seconds: f64,
    /// relMSE, the reference's own noise taken off.
    pub error: f64,
    /// True if the reference is good enough here.
    pub solid: bool,
}

/// The gain and the cost of paths of one length in bdpt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LengthShare {
    /// Edges.
    pub edges: u32,
    /// Their share of all light.
    pub light: f64,
    /// Their share of the noise, as if lengths were independent.
    pub variance: f64,
    /// Their share of all rays.
    pub rays: f64,
}

/// Measurement against theory: noise of one sample under a coaxial disk lamp of
/// radius R at height h.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Oracle {
    /// Each estimator at each radius.
    pub curves: Vec<OracleCurve>,
    /// The crossing at which `puremc` and `directlight` are equally noisy.
    pub crossing: OracleCrossing,
    /// The crossing at which their variance times seconds are equal.
    pub crossing_in_time: OracleCrossing,
    /// Samples behind each point.
    pub samples: u64,
}

/// One estimator.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OracleCurve {
    /// Its name, as of a method.
    pub method: String,
    /// The points by R/h, ascending.
    pub points: Vec<OraclePoint>,
}

/// One estimator at one radius.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct OraclePoint {
    /// R/h.
    pub radius: f64,
    /// The variance of one sample by theory, in units of (ρ·Le)².
    pub theory: f64,
    /// The measured one, with its 99.9 % interval.
    pub variance: Estimate,
    /// Seconds of one sample.
    pub seconds: f64,
}

/// The ratio R/h at which two methods are worth the same.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct OracleCrossing {
    /// The measured value, with its 95 % interval.
    pub measured: Estimate,
    /// The value by theory; for the crossing in time, with the measured cost of a sample.
    pub theory: f64,
}
