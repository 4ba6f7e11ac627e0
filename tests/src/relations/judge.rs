//! Judges relations.
//!
//! In looks with random numbers of their own, each with four times as many passes
//! as the one before: only what is suspicious at a look is looked at again. Looks
//! are independent, so a claim that is true is refused with the product of their
//! levels, 10⁻⁹. None is left out, however improbable those before it were: where two
//! renderings share their random numbers, what little differs may come in a few samples, for
//! which no statistics hold. Rounding may shift light a little and is no fault: each claim says
//! by how much, and the test is of a difference beyond that.

use crate::relations::form::Files;
use crate::relations::render::{Built, CELLS, Cells, Estimator, Trouble, Workshop};
use std::sync::Arc;
use traylib_statistics::student::two_sided;
use traylib_statistics::{Sample, shortfall};

/// The probability below which each look must find a claim for it to be looked at again.
pub const LEVELS: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// In fewer passes than this light was hardly met.
const FEW: usize = 20;

/// Part of the brightest light that may be lost where numbers become too small.
const LOST: f64 = 1e-14;

/// The factors between the passes of each look and those of the first.
const PASSES: [u32; 3] = [1, 4, 16];

/// A rendering that is one side of a claim, or a part of it.
#[derive(Clone, Debug)]
pub struct Part {
    /// The scene that is rendered.
    pub built: Arc<Built>,
    /// The estimator that renders it.
    pub estimator: Estimator,
    /// The greatest sample that there can be: says how rare light can be that was
    /// not met.
    pub brightest: f64,
    /// True if much of the light may come in such samples. If not, this matters only where hardly
    /// any light was met.
    pub is_rare: bool,
}

/// One side of a claim.
#[derive(Clone, Debug)]
pub enum Side {
    /// The sum of these.
    Rendered(Vec<Part>),
    /// This radiance in every pixel.
    Known(f64),
    /// A file as Mitsuba renders it.
    Outside(Outside),
}

/// A rendering by another program.
#[derive(Clone, Debug)]
pub struct Outside {
    /// The file, with what has to lie beside it.
    pub files: Arc<Files>,
    /// What its samples are like.
    pub part: Part,
}

/// The law that is claimed of the two sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Both are the same picture, bit for bit.
    SameBits,
    /// The same mean, up to this part of it, over all and over each quarter.
    SameMean(f64),
    /// The same mean over all of the picture, up to this part of it.
    MeanOfAll(f64),
    /// The left mean is not greater than the right one, up to this part of it.
    AtMost(f64),
}

/// The random numbers of both sides, the same or independent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbers {
    /// Both share their numbers: differences are taken pass by pass.
    Common,
    /// Others.
    Own,
}

impl Numbers {
    /// Common ones if there are as many lamps on both sides. If not, those that hardly matter
    /// take another share of the choices: all samples of the others then differ by a little,
    /// always the same way, until one that was lost makes up for it. No spread tells of that.
    pub fn of(sides: [&Built; 2]) -> Self {
        let [left, right] = sides.map(|side| side.scene.lights().len());
        if left == right { Self::Common } else { Self::Own }
    }
}

/// A relation that must hold.
#[derive(Clone, Debug)]
pub struct Claim {
    /// In words.
    pub what: String,
    /// One side.
    pub left: Side,
    /// The other.
    pub right: Side,
    /// True if the right picture is the left one with left for right.
    pub flipped: bool,
    /// The factor by which the left picture is as bright as the right one.
    pub factor: f64,
    /// The law that must hold.
    pub law: Law,
    /// Random numbers of the sides.
    pub numbers: Numbers,
}

/// The figures of the first look, whatever came of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct First {
    /// Mean of the picture, left and right.
    pub means: [f64; 2],
    /// Variances of these means.
    pub variances: [f64; 2],
    /// The probability of that, if the claim is true.
    pub p: f64,
}

/// The verdict on a claim.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It holds, as far as can be seen.
    Holds(First),
    /// It does not: what each look saw.
    Broken(Vec<Look>),
    /// It could not be rendered.
    Failed(Trouble),
}

/// The figures of one look, as sequential tests call a stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Passes of each side.
    pub passes: u32,
    /// The seed of the left side.
    pub seed: u64,
    /// Mean of the cell that differs most, left and right.
    pub means: [f64; 2],
    /// Standard error of their difference.
    pub error: f64,
    /// The probability of this, if the claim is true.
    pub p: f64,
    /// The figures of the first look.
    pub first: First,
}

/// Judges a claim; the first look has so many passes.
pub fn judge(claim: &Claim, workshop: &Workshop, passes: u32, seed: u64) -> Verdict {
    let mut looks = Vec::new();
    for (number, (&level, &times)) in LEVELS.iter().zip(&PASSES).enumerate() {
        match look(claim, workshop, passes * times, seed_of(seed, number as u64)) {
            Err(trouble) => return Verdict::Failed(trouble),
            Ok(look) if look.p >= level => {
                let first = looks.first().unwrap_or(&look).first;
                return Verdict::Holds(first);
            }
            Ok(look) => looks.push(look),
        }
    }
    Verdict::Broken(looks)
}

/// The seed of this look; those of parts follow.
fn seed_of(seed: u64, look: u64) -> u64 {
    seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(look << 32)
}

fn look(claim: &Claim, workshop: &Workshop, passes: u32, seed: u64) -> Result<Look, Trouble> {
    let left = rendered(&claim.left, workshop, passes, seed)?;
    let others = if claim.numbers == Numbers::Common { seed } else { seed + 1000 };
    let right = rendered(&claim.right, workshop, passes, others)?;
    let right = right.map(|cells| if claim.flipped { cells.flipped() } else { cells });
    let right =
        right.map(|cells| if claim.factor == 1.0 { cells } else { cells.times(claim.factor) });
    let seen = Seen { claim, sides: [left, right], passes };
    Ok(seen.judge(seed))
}

/// `None` for a side that is known.
fn rendered(
    side: &Side,
    workshop: &Workshop,
    passes: u32,
    seed: u64,
) -> Result<Option<Cells>, Trouble> {
    let parts = match side {
        Side::Known(_) => return Ok(None),
        Side::Outside(Outside { files, .. }) => {
            return workshop.render_outside(files, seed, passes).map(Some);
        }
        Side::Rendered(parts) => parts,
    };
    let mut sum: Option<Cells> = None;
    for (number, part) in parts.iter().enumerate() {
        let cells = workshop.render(&part.built, part.estimator, seed + number as u64, passes)?;
        sum = Some(match sum {
            None => cells,
            Some(sum) => sum.plus(&cells),
        });
    }
    Ok(sum)
}

/// Both sides of a claim at one look.
struct Seen<'a> {
    claim: &'a Claim,
    sides: [Option<Cells>; 2],
    passes: u32,
}

impl Seen<'_> {
    fn judge(&self, seed: u64) -> Look {
        let (mut p, mut cell) = (1.0_f64, 0);
        match self.claim.law {
            Law::SameBits => {
                if !self.same_bits() {
                    p = 0.0;
                    cell = (0..CELLS)
                        .max_by(|&a, &b| self.gap(a).total_cmp(&self.gap(b)))
                        .unwrap_or(0);
                }
            }
            Law::MeanOfAll(margin) => p = self.p(0, margin),
            Law::SameMean(margin) | Law::AtMost(margin) => {
                for candidate in 0..CELLS {
                    let found = (self.p(candidate, margin) * CELLS as f64).min(1.0);
                    if found < p {
                        (p, cell) = (found, candidate);
                    }
                }
            }
        }
        let means = [self.mean(0, cell), self.mean(1, cell)];
        let error = self.difference(cell).variance_of_mean.sqrt();
        Look { passes: self.passes, seed, means, error, p, first: self.first(p) }
    }

    /// Tells whether the pictures are the same to the last bit, but for light that is
    /// beyond all range beside the brightest: products of single precision lose it.
    fn same_bits(&self) -> bool {
        let [Some(left), Some(right)] = &self.sides else { return false };
        let brightest = left.bands.iter().copied().fold(0.0, f64::max);
        let mut pairs = left.bands.iter().zip(&right.bands);
        pairs.all(|(left, right)| left == right || (left - right).abs() < LOST * brightest)
    }

    fn first(&self, p: f64) -> First {
        let samples = [0, 1].map(|side| self.sample(side, 0));
        First { means: samples.map(|s| s.mean), variances: samples.map(|s| s.variance_of_mean), p }
    }

    fn sample(&self, side: usize, cell: usize) -> Sample {
        match (&self.sides[side], [&self.claim.left, &self.claim.right][side]) {
            (Some(cells), _) => Sample::of(&cells.values[cell]),
            (None, &Side::Known(mean)) => Sample { count: usize::MAX, mean, variance_of_mean: 0.0 },
            (None, Side::Rendered(_) | Side::Outside(_)) => {
                Sample { count: 0, mean: 0.0, variance_of_mean: 0.0 }
            }
        }
    }

    fn mean(&self, side: usize, cell: usize) -> f64 {
        self.sample(side, cell).mean
    }

    fn gap(&self, cell: usize) -> f64 {
        (self.mean(0, cell) - self.mean(1, cell)).abs()
    }

    /// The difference of the means, with its variance.
    fn difference(&self, cell: usize) -> Sample {
        if let ([Some(left), Some(right)], Numbers::Common) = (&self.sides, self.claim.numbers) {
            let pairs = left.values[cell].iter().zip(&right.values[cell]);
            let differences: Vec<f64> = pairs.map(|(left, right)| left - right).collect();
            return Sample::of(&differences);
        }
        let [a, b] = [0, 1].map(|side| self.sample(side, cell));
        Sample {
            // Of Welch's degrees of freedom, at least those of the shorter side.
            count: a.count.min(b.count),
            mean: a.mean - b.mean,
            variance_of_mean: a.variance_of_mean + b.variance_of_mean,
        }
    }

    /// Returns the probability of such a difference if the means are the same but for the margin:
    /// Student's law, both sides.
    fn p(&self, cell: usize, margin: f64) -> f64 {
        let difference = self.difference(cell);
        let means = [self.mean(0, cell), self.mean(1, cell)];
        // A quarter may be dark by itself: rounding is a part of all there is.
        let allowed = margin * means[0].abs().max(means[1].abs());
        let one_sided = matches!(self.claim.law, Law::AtMost(_));
        let size = if one_sided { difference.mean } else { difference.mean.abs() };
        let beyond = size - allowed;
        if beyond <= 0.0 {
            return 1.0;
        }
        let error = difference.variance_of_mean.sqrt();
        let freedom = (difference.count.min(1_000_000) as f64 - 1.0).max(1.0);
        let by_spread = if error > 0.0 { two_sided(beyond / error, freedom) } else { 0.0 };
        by_spread.max(self.by_rarity(cell, means))
    }

    /// Returns the probability that the darker side missed light that comes in samples as bright as
    /// its brightest; zero where that is not known.
    fn by_rarity(&self, cell: usize, means: [f64; 2]) -> f64 {
        let darker = usize::from(means[1] < means[0]);
        let Some(cells) = &self.sides[darker] else { return 0.0 };
        let parts = match [&self.claim.left, &self.claim.right][darker] {
            Side::Rendered(parts) => parts.as_slice(),
            Side::Outside(outside) => std::slice::from_ref(&outside.part),
            Side::Known(_) => return 0.0,
        };
        let hardly_met = cells.values[cell].iter().filter(|value| **value > 0.0).count() < FEW;
        if !hardly_met && !parts.iter().any(|part| part.is_rare) {
            return 0.0;
        }
        let brightest = parts.iter().map(|part| part.brightest).fold(0.0, f64::max);
        let other = self.sample(1 - darker, cell);
        let truth = other.mean - 3.0 * other.variance_of_mean.sqrt();
        let share = if cell == 0 { 1.0 } else { 0.25 };
        let samples = f64::from(cells.pixels) * share * f64::from(self.passes);
        shortfall(samples, brightest, truth, truth - means[darker])
    }
}
