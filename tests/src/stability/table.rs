//! The finished table, and how it is written as text.

use crate::stability::expected::{Expected, METHODS, correction, expected};
use crate::stability::figures::Figures;
use crate::stability::judge::{SLOW, Verdict};
use serde::{Deserialize, Serialize};
use std::fmt::Write;
use traylib_integrators::Method;

/// Times on a busy machine scatter by about a third; a factor as near as this to
/// the limit, either way, decides nothing.
pub const BORDER: f64 = 1.5;

/// One cell, judged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Judged {
    /// The scene's name.
    pub scene: String,
    /// The title of the scene.
    pub title: String,
    /// The method.
    #[serde(with = "crate::methods")]
    pub method: Method,
    /// The verdict.
    pub verdict: Verdict,
    /// Time to relMSE 10⁻² over that of the best method of the row.
    pub factor: Option<f64>,
    /// The figures that it was judged by; `None` where nothing random was measured.
    pub figures: Option<Figures>,
    /// Kinds of light that the method said it cannot produce.
    pub announced: Vec<String>,
}

/// The agreement of a verdict with the expectation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agreement {
    /// As expected.
    Expected,
    /// Ok where slow was expected or the other way round, but too near to the limit
    /// for noisy times to tell.
    Border,
    /// As corrected, for this reason.
    Corrected(&'static str),
    /// Neither.
    Disagrees,
}

impl Judged {
    /// Tells whether the verdict is what the tables say.
    pub fn agreement(&self) -> Agreement {
        let correction = correction(&self.scene, self.method);
        let corrected = correction.map(|correction| correction.verdict);
        let expected = corrected.or_else(|| expected(&self.scene, self.method));
        if expected.is_some_and(|expected| expected.agrees(&self.verdict)) {
            correction.map_or(Agreement::Expected, |known| Agreement::Corrected(known.reason))
        } else if self.is_at_the_border() && matches!(expected, Some(Expected::Ok | Expected::V)) {
            Agreement::Border
        } else {
            Agreement::Disagrees
        }
    }

    fn is_at_the_border(&self) -> bool {
        let near = |factor: f64| (SLOW / BORDER..SLOW * BORDER).contains(&factor);
        matches!(self.verdict, Verdict::Ok | Verdict::Slow) && self.factor.is_some_and(near)
    }

    /// The verdict, with the factor where it is the point.
    pub fn word(&self) -> String {
        match (&self.verdict, self.factor) {
            (Verdict::Ok | Verdict::Slow | Verdict::Sparks, Some(factor)) => {
                format!("{} {}×", self.verdict, short(factor))
            }
            (verdict, _) => verdict.to_string(),
        }
    }
}

/// The scenes of the table, in its order.
pub fn scenes(cells: &[Judged]) -> Vec<(&str, &str)> {
    let mut scenes = Vec::new();
    for cell in cells {
        let scene = (cell.scene.as_str(), cell.title.as_str());
        if !scenes.contains(&scene) {
            scenes.push(scene);
        }
    }
    scenes
}

/// A cell by its place.
pub fn cell<'a>(cells: &'a [Judged], scene: &str, method: Method) -> Option<&'a Judged> {
    cells.iter().find(|cell| cell.scene == scene && cell.method == method)
}

/// The table, the figures behind it and every difference from the expectation,
/// in Markdown and without a word about the machine's speed.
pub fn markdown(cells: &[Judged]) -> String {
    let mut text = String::from("| scene |");
    for method in METHODS {
        let _ = write!(text, " {method} |");
    }
    text += "\n|---|---|---|---|---|---|---|\n";
    for (id, title) in scenes(cells) {
        let _ = write!(text, "| {id} {title} |");
        for method in METHODS {
            let _ = write!(text, " {} |", cell(cells, id, method).map_or_else(String::new, marked));
        }
        text.push('\n');
    }
    text + "\n" + &figures(cells) + &differences(cells)
}

/// With a star where the verdict is a corrected one, an exclamation mark where it
/// is neither expected nor corrected.
fn marked(cell: &Judged) -> String {
    let mark = match cell.agreement() {
        Agreement::Expected => "",
        Agreement::Border => " ~",
        Agreement::Corrected(_) => " \\*",
        Agreement::Disagrees => " **!**",
    };
    cell.word() + mark
}

fn figures(cells: &[Judged]) -> String {
    let mut text = String::from(
        "| cell | passes | mean/truth | ± | relMSE/pass | median | worst | α₂₅₆ | α₆₄ | kurtosis | growth | top 0.1 % | fireflies | slope |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    for cell in cells {
        let Some(f) = &cell.figures else { continue };
        let tail = |index: Option<traylib_statistics::tail::TailIndex>| {
            index.map_or("—".into(), |i| match (i.alpha, i.upper) {
                (Some(alpha), Some(upper)) => format!("{alpha:.2} < {upper:.2}"),
                _ => "∞".into(),
            })
        };
        let option = |value: Option<f64>| value.map_or_else(|| "—".into(), short);
        let slope =
            f.slope.map_or("—".into(), |s| format!("{:.3} ± {:.3}", s.slope, s.deviation));
        let _ = writeln!(
            text,
            "| {} {} | {} | {:.4} | {:.4} | {} | {} | {} | {} | {} | {} | {} | {:.0} % | {:.0} | {slope} |",
            cell.scene,
            cell.method,
            f.passes,
            f.mean / f.truth,
            f.half_width / f.truth,
            short(f.rel_mse_per_pass),
            short(f.median_rel_mse),
            short(f.worst_rel_mse),
            tail(f.tail),
            tail(f.far_tail),
            option(f.kurtosis),
            option(f.kurtosis_growth),
            100.0 * f.energy_share,
            f.fireflies,
        );
    }
    text + "\n"
}

fn differences(cells: &[Judged]) -> String {
    let mut text = String::new();
    for cell in cells {
        let expected = expected(&cell.scene, cell.method).map_or("?", |e| e.name());
        let place = format!("{} {}", cell.scene, cell.method);
        let why = match (cell.agreement(), &cell.verdict) {
            (Agreement::Expected, _) => continue,
            (Agreement::Border, _) => String::from("too near to 10× to tell"),
            (Agreement::Corrected(reason), _) => reason.to_owned(),
            (Agreement::Disagrees, Verdict::Unsettled(what)) => format!("**unexpected**: {what}"),
            (Agreement::Disagrees, _) => String::from("**unexpected**"),
        };
        let _ = writeln!(text, "- {place}: expected {expected}, found {}: {why}", cell.word());
    }
    text
}

/// Three digits, whatever the size.
pub fn short(value: f64) -> String {
    match value.abs() {
        0.0 => String::from("0"),
        size if !(1e-2..1e4).contains(&size) => format!("{value:.1e}"),
        size if size < 10.0 => format!("{value:.2}"),
        size if size < 100.0 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}
