//! From figures to a verdict.

use crate::stability::figures::{Figures, TARGET};
use serde::{Deserialize, Serialize};
use std::fmt;
use traylib_statistics::tail;

/// Times the best method's time to relMSE 10⁻² beyond which a cell is slow.
pub const SLOW: f64 = 10.0;

/// The passes to relMSE 10⁻² beyond which all are slow, if even the best needs more.
pub const ALL_SLOW: f64 = 16384.0;

/// The relative error that an image mean may have, where its interval can tell.
pub const EQUIVALENCE: f64 = 5e-3;

/// Fireflies per megapixel.
const FIREFLIES: f64 = 10.0;

/// The greatest deviation of a slope from −1.
const SLOPE: f64 = 0.05;

/// The verdict on a cell.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// No light of the scene is of a kind that the method is for, and it says so.
    NotApplicable,
    /// It found nothing, and said so beforehand.
    Blind,
    /// Its values have no variance.
    Alarm,
    /// Right, at more than ten times the price of the best, or where nothing is
    /// fast.
    Slow,
    /// The best where nothing is fast.
    OkSlow,
    /// Right and fast.
    Ok,
    /// Right and fast, but single pixels stand out.
    Sparks,
    /// The bits are the same at every scale.
    Identical,
    /// None of these: something is wrong, and this is what.
    Unsettled(String),
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotApplicable => "—",
            Self::Blind => "blind",
            Self::Alarm => "alarm",
            Self::Slow => "V",
            Self::OkSlow => "ok-slow",
            Self::Ok => "ok",
            Self::Sparks => "sparks",
            Self::Identical => "identical",
            Self::Unsettled(_) => "unsettled",
        })
    }
}

/// The word of a method on itself before rendering, as far as it matters here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// It can produce the light of this scene.
    Sees,
    /// It announced a kind of light that all of this scene's light belongs to.
    Announced,
}

/// The time to relMSE 10⁻² and the passes it takes, of the best of a row: right,
/// and of finite variance.
pub fn best<'a>(row: impl IntoIterator<Item = &'a Figures>) -> Option<&'a Figures> {
    row.into_iter()
        .filter(|figures| !is_blind(figures) && !has_alarm(figures) && wrong(figures).is_none())
        .min_by(|a, b| a.seconds_to_target().total_cmp(&b.seconds_to_target()))
}

/// Judges a cell: blind, then alarm, then slow, then ok.
pub fn judge(figures: &Figures, word: Word, best: Option<&Figures>) -> Verdict {
    if is_blind(figures) || word == Word::Announced {
        return blind(figures, word);
    }
    if has_alarm(figures) {
        return Verdict::Alarm;
    }
    if let Some(complaint) = wrong(figures) {
        return Verdict::Unsettled(complaint);
    }
    let Some(best) = best else { return Verdict::Unsettled("nothing to compare with".into()) };
    let all_slow = best.passes_to_target() > ALL_SLOW;
    if all_slow && best == figures {
        return Verdict::OkSlow;
    }
    if all_slow || factor(figures, best) > SLOW {
        return Verdict::Slow;
    }
    if figures.fireflies > FIREFLIES {
        return Verdict::Sparks;
    }
    unsteady(figures).map_or(Verdict::Ok, Verdict::Unsettled)
}

/// Time to relMSE 10⁻² over that of the best.
pub fn factor(figures: &Figures, best: &Figures) -> f64 {
    figures.seconds_to_target() / best.seconds_to_target()
}

fn is_blind(figures: &Figures) -> bool {
    figures.mean == 0.0 && figures.truth > 0.0
}

fn has_alarm(figures: &Figures) -> bool {
    tail::alarm(figures.tail, figures.far_tail)
}

fn blind(figures: &Figures, word: Word) -> Verdict {
    match (is_blind(figures), word) {
        (true, Word::Announced) => Verdict::Blind,
        (true, Word::Sees) => Verdict::Unsettled("found nothing and had not announced it".into()),
        (false, _) => {
            Verdict::Unsettled("announced that it would find nothing, and found light".into())
        }
    }
}

/// Says why an estimate is wrong, whatever its noise; `None` if it is not.
fn wrong(figures: &Figures) -> Option<String> {
    let Figures { mean, half_width, truth, rejected, .. } = *figures;
    let narrow = half_width <= EQUIVALENCE * truth;
    let allowed = if narrow { EQUIVALENCE * truth } else { half_width };
    if rejected > 0 {
        Some(format!("{rejected} samples were not sound numbers"))
    } else if (mean - truth).abs() > allowed {
        Some(format!("mean {mean:.5} ± {half_width:.5}, truth {truth:.5}"))
    } else {
        None
    }
}

/// Says why a fast method is not ok; `None` if it is.
fn unsteady(figures: &Figures) -> Option<String> {
    match figures.slope {
        Some(slope) if (slope.slope + 1.0).abs() > SLOPE => {
            Some(format!("slope {:.3} ± {:.3}", slope.slope, slope.deviation))
        }
        // Without noise there is no slope.
        None if figures.worst_rel_mse > 1e-6 * TARGET => Some("no slope".into()),
        _ => None,
    }
}
