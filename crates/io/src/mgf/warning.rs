//! The warnings of the decoder: what it skips or repairs.

use super::Place;
use super::error::shown;
use std::collections::BTreeMap;
use std::fmt;

/// The kinds of what a reader skips or repairs in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum WarningKind {
    /// A line whose first word is no keyword.
    UnknownEntity,
    /// A comment without a blank after its `#`.
    CommentWithoutBlank,
    /// Luminaire data.
    LuminaireSkipped,
    /// A transform that its file leaves open.
    TransformLeftOpen,
    /// An object that its file leaves open.
    ObjectLeftOpen,
    /// A material that scatters more than arrives.
    ScattersTooMuch,
    /// A colour without luminance where there is light to be coloured.
    ColourWithoutLuminance,
    /// A surface without area or axis.
    NoArea,
    /// A surface with numbers beyond single precision.
    NotFinite,
}

/// A warning: what was skipped or repaired for one reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The reason.
    pub kind: WarningKind,
    /// The keyword, file or material, or empty.
    pub subject: String,
    /// The place where it was first met.
    pub place: Place,
    /// The number of times.
    pub count: u32,
}

impl Warning {
    /// Returns what was met, without where and how often.
    pub fn what(&self) -> String {
        let subject = &self.subject;
        match self.kind {
            WarningKind::UnknownEntity => format!("unknown entity `{subject}` skipped"),
            WarningKind::CommentWithoutBlank => {
                format!("`{subject}` taken for a comment (a blank belongs after its #)")
            }
            WarningKind::LuminaireSkipped => {
                format!("luminaire `{subject}` skipped with its light (ies is not read)")
            }
            WarningKind::TransformLeftOpen => "xf left open, closed at the file's end".into(),
            WarningKind::ObjectLeftOpen => "o left open, closed at the file's end".into(),
            WarningKind::ScattersTooMuch => {
                format!("material `{subject}` with rd + td + rs + ts over 1, scaled down")
            }
            WarningKind::ColourWithoutLuminance => {
                format!("material `{subject}` with a colour of no luminance, black")
            }
            WarningKind::NoArea => format!("surface `{subject}` dropped: it has no area"),
            WarningKind::NotFinite => format!("surface `{subject}` dropped: it is too large"),
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.what())?;
        if self.count > 1 { write!(f, " ({} times)", self.count) } else { Ok(()) }
    }
}

/// Warnings, each kind and subject once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Warnings(BTreeMap<(WarningKind, String), Warning>);

impl Warnings {
    /// More subjects than these are counted together, under `…`.
    const MOST: usize = 1000;

    /// Returns how often a kind was met.
    pub fn count(&self, kind: WarningKind) -> u32 {
        let own = self.0.values().filter(|warning| warning.kind == kind);
        own.fold(0, |sum, warning| sum.saturating_add(warning.count))
    }

    /// All warnings, in a fixed order.
    pub fn iter(&self) -> impl Iterator<Item = &Warning> {
        self.0.values()
    }

    pub(super) fn add(&mut self, kind: WarningKind, subject: &str, place: impl FnOnce() -> Place) {
        let mut key = (kind, shown(subject));
        if self.0.len() >= Self::MOST && !self.0.contains_key(&key) {
            key.1 = "…".to_string();
        }
        let subject = key.1.clone();
        let new = || Warning { kind, subject, place: place(), count: 0 };
        let warning = self.0.entry(key).or_insert_with(new);
        warning.count = warning.count.saturating_add(1);
    }
}
