//! The command line.

use crate::method::by_default;
use clap::Parser;
use std::path::PathBuf;
use std::time::Duration;
use traylib_demos::{Failure, Shard, parse_duration, parse_resolution, parse_threads};
use traylib_integrators::{Method, PointSet};

/// Which method reaches which error in which time: renders each scene by each of
/// them, many times and by turns, and charts error against time
///
/// Writes index.html, results.json and results.csv and prints the main table. If it
/// is interrupted, it keeps what is done; the same command goes on from there.
#[derive(Parser, Clone, Debug)]
#[command(
    name = "cargo xtask compare-integrators",
    bin_name = "cargo xtask compare-integrators",
    version = traylib_demos::VERSION,
    max_term_width = 80,
    after_long_help = EXAMPLES
)]
pub struct Options {
    /// Scene files or names of built-in scenes; `oracle` is the test of noise
    /// against theory [default: the paper's scenes cornell, small-light, pyramid,
    /// and oracle]
    pub scenes: Vec<String>,

    /// Methods, each spelled as a command line without a scene, as
    /// "puremc,bdpt --max-depth 6" [default: all, some in several settings]
    #[arg(long, alias = "integrators", value_name = "LIST", value_delimiter = ',')]
    pub methods: Vec<Method>,

    /// When each run is looked at; it ends with the last [default: 0.25s,0.5s,1s,2s]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_duration)]
    pub budgets: Vec<Duration>,

    /// Runs of each method, each with a seed of its own [default: 16]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1024))]
    pub seeds: Option<u32>,

    /// Seed of the first run; the others count up from it
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(..1 << 32))]
    pub first_seed: u64,

    /// Picture to hold all others against, EXR or Radiance, of one scene, taken for true
    /// [default: a closed form, or two long renders by different methods]
    #[arg(long, value_name = "FILE")]
    pub reference: Option<PathBuf>,

    /// Size of the pictures [default: the scene's, made smaller to a width of at
    /// most 128: noise is the same in each pixel, and there are fewer]
    #[arg(long, value_name = "WxH", value_parser = parse_resolution)]
    pub resolution: Option<(u32, u32)>,

    /// Threads, up to 1024, 0 for one a processor
    #[arg(short, long, value_name = "N", default_value_t = 0, value_parser = parse_threads)]
    pub threads: usize,

    /// Where random numbers come from, as for the programs; references are always of
    /// `independent` ones
    #[arg(long, value_name = "NAME", default_value_t = PointSet::default())]
    pub sampler: PointSet,

    /// Pictures of other programs to put on the chart: a JSON list of scene (its name
    /// here: of a file, that without folder and ending), name, seconds and picture
    #[arg(long, value_name = "FILE")]
    pub outside: Option<PathBuf>,

    /// Smaller pictures, eight short runs, each method in one setting: under two
    /// minutes, for a look
    #[arg(long)]
    pub quick: bool,

    /// Where everything goes, references and single runs too, which later comparisons
    /// there find again [default: target/compare]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,

    /// Render the references and nothing else: the first step of runs in parts
    #[arg(long, conflicts_with_all = ["shard", "open"])]
    pub references_only: bool,

    /// Make only part I, from 0 on, of N of the runs, against references that are there,
    /// and no page: the same command without this finds all runs and shows them
    #[arg(long, value_name = "I/N", conflicts_with = "open")]
    pub shard: Option<Shard>,

    /// Show the page when it is done
    #[arg(long)]
    pub open: bool,
}

const EXAMPLES: &str = "Examples:
  cargo xtask compare-integrators --quick
  cargo xtask compare-integrators my.ron --methods \"bdpt,directlight --combine\" --open
  cargo xtask compare-integrators pyramid --budgets 1s,4s,16s --seeds 32";

/// The paper's scenes.
const SCENES: [&str; 4] = ["cornell", "small-light", "pyramid", ORACLE];

/// The name that stands for the test against theory among the scenes.
pub const ORACLE: &str = "oracle";

impl Options {
    /// Returns the scenes to compare on; `oracle` may be among it.
    pub fn scenes(&self) -> Vec<String> {
        if self.scenes.is_empty() { SCENES.map(String::from).to_vec() } else { self.scenes.clone() }
    }

    /// Returns the methods that take part.
    pub fn methods(&self) -> Vec<Method> {
        if self.methods.is_empty() {
            return by_default(self.quick);
        }
        self.methods.iter().map(|method| method.for_many_samples()).collect()
    }

    /// The budgets in seconds, ascending.
    pub fn budgets(&self) -> Vec<f64> {
        let mut budgets: Vec<f64> = if !self.budgets.is_empty() {
            self.budgets.iter().map(Duration::as_secs_f64).collect()
        } else if self.quick {
            vec![0.0625, 0.125, 0.25]
        } else {
            vec![0.25, 0.5, 1.0, 2.0]
        };
        budgets.sort_by(f64::total_cmp);
        budgets.dedup();
        budgets
    }

    /// Runs of each method.
    pub fn seeds(&self) -> u32 {
        self.seeds.unwrap_or(if self.quick { 8 } else { 16 })
    }

    /// The widest picture, unless a size is asked for.
    pub fn largest_width(&self) -> u32 {
        if self.quick { 64 } else { 128 }
    }

    /// Returns the folder of all results.
    pub fn folder(&self) -> PathBuf {
        self.out.clone().unwrap_or_else(|| crate::target().join("compare"))
    }

    /// Refuses what does not go together.
    ///
    /// # Errors
    /// It does not.
    pub fn check(&self) -> Result<(), Failure> {
        let rendered = self.scenes().iter().filter(|scene| *scene != ORACLE).count();
        if self.reference.is_some() && rendered != 1 {
            return Err(Failure::usage("--reference is a picture of one scene: name just that"));
        }
        let methods = self.methods();
        let twice = methods.iter().enumerate().find(|(i, method)| methods[..*i].contains(method));
        match twice {
            Some((_, method)) => {
                Err(Failure::usage(format_args!("--methods has `{method}` twice")))
            }
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn options(words: &[&str]) -> Options {
        Options::try_parse_from([&["x"], words].concat()).unwrap()
    }

    #[test]
    fn lists_are_split_and_sorted() {
        let methods = "trace,bdpt --max-depth 6";
        let found = options(&["--budgets", "4s,1s,4s", "--methods", methods, "cornell"]);
        assert_eq!(found.budgets(), [1.0, 4.0]);
        let names = found.methods().iter().map(ToString::to_string).collect::<Vec<_>>();
        assert_eq!(names, ["trace --jitter", "bdpt --max-depth 6"]);
        assert_eq!(found.scenes(), ["cornell"]);
        assert!(found.check().is_ok());
    }

    #[test]
    fn what_does_not_go_together_is_refused() {
        assert!(options(&["--reference", "a.exr"]).check().is_err());
        assert!(options(&["--reference", "a.exr", "pyramid", "oracle"]).check().is_ok());
        assert!(options(&["--methods", "bdpt,bdpt"]).check().is_err());
        assert!(Options::try_parse_from(["x", "--seeds", "1"]).is_err());
        assert!(Options::try_parse_from(["x", "--methods", "pt"]).is_err());
        let old = Options::try_parse_from(["x", "--integrators", "combined:balance"]);
        let told = old.unwrap_err().to_string();
        assert!(told.contains("`directlight --combine --heuristic balance` now"), "{told}");
    }
}
