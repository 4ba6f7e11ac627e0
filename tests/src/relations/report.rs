//! The report of a run.

use crate::relations::form::Files;
use crate::relations::judge::{Look, Verdict};
use crate::relations::render::Trouble;
use crate::relations::run::Outcome;
use std::path::{Path, PathBuf};
use std::{fmt, fs, io};

/// Writes the scene of an outcome with all that was found, as a file that programs
/// and `cargo xtask relations --case` read.
///
/// # Errors
/// If it cannot be written.
pub fn save(outcome: &Outcome, seed: u64, folder: &Path) -> io::Result<PathBuf> {
    let stem = format!("{seed}-{}-{}", outcome.scene, outcome.relation);
    fs::create_dir_all(folder)?;
    if let Some(smallest) = &outcome.smallest {
        return save(smallest, seed, folder);
    }
    let file = folder.join(format!("{stem}.ron"));
    let depth =
        outcome.drawn.max_depth.map_or(String::new(), |depth| format!("max-depth: {depth}\n"));
    let (place, relation, scene) = (file.display(), outcome.relation, outcome.scene);
    let again = format!(
        "cargo xtask relations --case {place} --relation {relation} --seed {seed} --first {scene}"
    );
    let head = format!("{depth}{outcome}\nagain: {again}");
    Files::of(&outcome.drawn, &stem).save(folder, &head)?;
    Ok(file)
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "scene {}, {}: {}", self.scene, self.relation, self.what)?;
        match &self.verdict {
            Verdict::Holds(_) => write!(f, ": holds"),
            Verdict::Broken(looks) => looks.iter().try_for_each(|look| write!(f, "\n    {look}")),
            Verdict::Failed(trouble) => write!(f, ": {trouble}"),
        }
    }
}

impl fmt::Display for Look {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [left, right] = self.means;
        let Self { passes, error, p, .. } = self;
        write!(f, "{left:.6e} and {right:.6e} ± {error:.1e}, p = {p:.1e}, {passes} passes")
    }
}

impl fmt::Display for Trouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(why) => write!(f, "refused: {why}"),
            Self::Slow(seconds) => write!(f, "not done after {seconds:.0} s"),
            Self::Unsound(samples) => write!(f, "{samples} samples negative or not finite"),
        }
    }
}
