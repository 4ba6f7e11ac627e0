//! The table as it was expected, written down before anything was measured, and
//! where measuring showed it wrong.

use crate::stability::column::Column;
use crate::stability::judge::Verdict;

/// A verdict foreseen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// Not applicable.
    No,
    /// Ok.
    Ok,
    /// Slow but right; the best of all that are slow is this, too.
    V,
    /// Blind.
    Blind,
    /// No variance.
    Alarm,
    /// Bit-identical.
    Same,
}

use Expected::{Alarm, Blind, No, Ok, Same, V};

/// Rows by the scene's name, columns as in [`Column::ALL`]: trace, puremc,
/// directlight, combined, particle, bdpt.
pub const EXPECTED: [(&str, [Expected; 6]); 18] = [
    ("F1", [No, V, Ok, Ok, Ok, Ok]),
    ("F2", [No, Ok, V, Ok, V, Ok]),
    ("F3", [No, V, V, Ok, V, Ok]),
    ("F4", [No, V, V, V, Ok, Ok]),
    ("F5", [No, V, V, V, Blind, V]),
    ("F6", [No, V, V, V, Ok, Ok]),
    ("F7", [No, V, V, V, V, V]),
    // F8 in words: ok if large · V, but ok with power · the same · V · V; for
    // area lamps nothing for trace.
    ("F8", [No, Ok, Ok, Ok, V, V]),
    // Power is no help here.
    ("F8b", [No, Ok, V, V, V, V]),
    // No point can be hit: puremc aims at them as directlight does.
    ("F8p", [Ok, Ok, Ok, Ok, V, V]),
    ("F9", [No, Ok, Ok, Ok, Ok, Ok]),
    ("F10", [No, Ok, Alarm, Ok, Ok, Ok]),
    ("F11", [Same; 6]),
    ("F12", [No, Ok, Ok, Ok, Ok, Ok]),
    ("F12p", [Ok, Ok, Ok, Ok, Ok, Ok]),
    ("F13", [Ok, Ok, Ok, Ok, V, Ok]),
    ("F14", [Blind; 6]),
    ("F15", [Blind, Blind, Blind, Blind, Ok, Ok]),
];

/// A cell where measuring showed the expectation wrong.
#[derive(Clone, Copy, Debug)]
pub struct Correction {
    /// The scene's name.
    pub scene: &'static str,
    /// The program.
    pub column: Column,
    /// The verdict that stands.
    pub verdict: Expected,
    /// Why, in a line.
    pub reason: &'static str,
}

/// All corrections.
pub const CORRECTIONS: &[Correction] = &[];

/// What was expected of a cell; `None` for a scene that is not in the table.
pub fn expected(scene: &str, column: Column) -> Option<Expected> {
    let (_, row) = EXPECTED.iter().find(|(id, _)| *id == scene)?;
    let index = Column::ALL.iter().position(|&other| other == column)?;
    Some(row[index])
}

/// The correction of a cell, if it has one.
pub fn correction(scene: &str, column: Column) -> Option<&'static Correction> {
    CORRECTIONS.iter().find(|c| c.scene == scene && c.column == column)
}

impl Expected {
    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            No => "—",
            Ok => "ok",
            V => "V",
            Blind => "blind",
            Alarm => "alarm",
            Same => "identical",
        }
    }

    /// Whether this is the verdict.
    pub fn agrees(self, verdict: &Verdict) -> bool {
        match self {
            No => *verdict == Verdict::NotApplicable,
            Ok => *verdict == Verdict::Ok,
            V => matches!(verdict, Verdict::Slow | Verdict::OkSlow),
            Blind => *verdict == Verdict::Blind,
            Alarm => *verdict == Verdict::Alarm,
            Same => *verdict == Verdict::Identical,
        }
    }
}
