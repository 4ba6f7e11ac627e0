//! The table as it was expected, written down before anything was measured, and
//! where measuring showed it wrong.

use crate::methods;
use crate::stability::judge::Verdict;
use traylib_integrators::Method;

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
    /// Fireflies.
    Sparks,
    /// No variance.
    Alarm,
    /// Bit-identical.
    Same,
}

use Expected::{Alarm, Blind, No, Ok, Same, Sparks, V};

/// The columns of the table.
pub const METHODS: [Method; 6] = [
    methods::JITTERED_TRACE,
    methods::PURE_MC,
    methods::DIRECT_LIGHT,
    methods::COMBINED,
    methods::PARTICLE,
    methods::BDPT,
];

/// Rows by the scene's name, columns as in [`METHODS`].
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
    /// The method.
    pub method: Method,
    /// The verdict that stands.
    pub verdict: Expected,
    /// The reason, in a line.
    pub reason: &'static str,
}

/// All corrections.
pub const CORRECTIONS: &[Correction] = &[
    corrected(
        "F1",
        methods::PARTICLE,
        V,
        "light paths hit a pixel or miss it, which is a relMSE of 5 a pass; one light sample, with \
         1e-4, is done after the first",
    ),
    corrected("F2", methods::COMBINED, Sparks, LOBE_EDGE),
    corrected("F2", methods::BDPT, Sparks, LOBE_EDGE),
    corrected("F3", methods::PURE_MC, Alarm, STAIRCASE),
    corrected("F3", methods::DIRECT_LIGHT, Alarm, STAIRCASE),
    corrected("F3", methods::PARTICLE, Alarm, STAIRCASE),
    corrected("F3", methods::COMBINED, Alarm, UNDECIDED),
    corrected("F3", methods::BDPT, Alarm, UNDECIDED),
    corrected("F4", methods::DIRECT_LIGHT, Ok, IMAGES),
    corrected("F4", methods::COMBINED, Ok, IMAGES),
    corrected("F5", methods::DIRECT_LIGHT, Ok, IMAGES),
    corrected("F5", methods::COMBINED, Ok, IMAGES),
    corrected("F5", methods::BDPT, Ok, IMAGES),
    corrected(
        "F8",
        methods::BDPT,
        Ok,
        "nine tenths of its light paths start at the relevant lamp: power serves them as well",
    ),
    corrected("F8b", methods::COMBINED, Ok, HITS),
    corrected("F8b", methods::BDPT, Ok, HITS),
    corrected(
        "F8p",
        methods::JITTERED_TRACE,
        V,
        "1000 shadow rays a pixel bring relMSE to 3e-4 in the first pass, where 1e-2 is asked: the \
         others have that after eight passes of one shadow ray",
    ),
    corrected(
        "F8p",
        methods::BDPT,
        Ok,
        "power serves it as it serves directlight, and its light paths weigh next to nothing",
    ),
    corrected("F14", methods::DIRECT_LIGHT, Ok, JOINED),
    corrected("F14", methods::COMBINED, Ok, JOINED),
    corrected("F14", methods::BDPT, Ok, JOINED),
    corrected("F15", methods::DIRECT_LIGHT, Ok, JOINED),
    corrected("F15", methods::COMBINED, Ok, JOINED),
    corrected("F15", methods::PARTICLE, V, HIT_OR_MISSED),
    corrected(
        "F7",
        methods::PURE_MC,
        Alarm,
        "slow, and more: less than a thousandth of its values are not black, too few to show that \
         their tail ends, though no value is larger than the lamp's radiance",
    ),
    corrected(
        "F10",
        methods::PURE_MC,
        V,
        "walks are as they were, and a relMSE of 6 a pass is 17 times the best since that draws \
         points of a near lamp by solid angle",
    ),
    corrected(
        "F10",
        methods::PARTICLE,
        V,
        "as with walks from the camera: light paths are as they were, and a relMSE of 7 a pass is 24 \
         times the best",
    ),
    corrected(
        "F10",
        methods::DIRECT_LIGHT,
        Ok,
        "points of a lamp that is near are drawn by solid angle; by area the tail has the index 1.5",
    ),
    corrected(
        "F12p",
        methods::PARTICLE,
        V,
        "as in F1: hits and misses, a relMSE of 11 a pass, against shadow rays to a point, which \
         know no chance but that of the place in the pixel",
    ),
];

const LOBE_EDGE: &str = "where the lobe's density has fallen to that of the lamp's points, p_b = \
    p_l, a light sample adds p_b·p_l/(p_b² + p_l²) = 1/2 of the truth; one in 10⁴ lies near there, \
    and relMSE is below 1e-2 from the first pass on, where nothing has averaged yet";

const IMAGES: &str = "walks from the camera aim at images of the lamp in the mirrors; while they \
    did not, F4 was V 60× and on F5 even the best needed more than 16,384 passes";

const JOINED: &str = "the point is joined by way of the mirror, which knows no chance but that of \
    the place in the pixel; while it was not, nobody found F14 and light paths alone F15";

const HIT_OR_MISSED: &str = "light paths hit a pixel or miss it, a relMSE of 42 a pass, as before; \
    directlight and bdpt join the point by way of the mirror, with 5e-5 and 7e-5";

const UNDECIDED: &str = "with 4096 samples a pixel chance decided, once for and once against an \
                         end of the tail; with 32,768 the index of the 64 largest values is 0.9, \
                         and no end is seen; which paths bring them is not known";

const STAIRCASE: &str = "slow, and more: of lamps of one flux the brightest, L, is hit as rarely as \
    1/L, and of the lobes the sharpest, worth n, as rarely as 1/n, so the tail has the index 1 as far \
    as the smallest lamp and the sharpest lobe, of which 32,768 samples a pixel meet too few to show \
    that it ends";

const HITS: &str = "a thousand equal lamps make light samples rare but not their weight: walks hit \
    the large lamp and the heuristic believes them";

const fn corrected(
    scene: &'static str,
    method: Method,
    verdict: Expected,
    reason: &'static str,
) -> Correction {
    Correction { scene, method, verdict, reason }
}

/// Returns what was expected of a cell; `None` for a scene that is not in the table.
pub fn expected(scene: &str, method: Method) -> Option<Expected> {
    let (_, row) = EXPECTED.iter().find(|(id, _)| *id == scene)?;
    let index = METHODS.iter().position(|&other| other == method)?;
    Some(row[index])
}

/// The correction of a cell, if it has one.
pub fn correction(scene: &str, method: Method) -> Option<&'static Correction> {
    CORRECTIONS.iter().find(|c| c.scene == scene && c.method == method)
}

impl Expected {
    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            No => "—",
            Ok => "ok",
            V => "V",
            Blind => "blind",
            Sparks => "sparks",
            Alarm => "alarm",
            Same => "identical",
        }
    }

    /// Tells whether this is the verdict.
    pub fn agrees(self, verdict: &Verdict) -> bool {
        match self {
            No => *verdict == Verdict::NotApplicable,
            Ok => *verdict == Verdict::Ok,
            V => matches!(verdict, Verdict::Slow | Verdict::OkSlow),
            Blind => *verdict == Verdict::Blind,
            Sparks => *verdict == Verdict::Sparks,
            Alarm => *verdict == Verdict::Alarm,
            Same => *verdict == Verdict::Identical,
        }
    }
}
