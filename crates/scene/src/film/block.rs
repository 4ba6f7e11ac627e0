//! Sums over passes that lie side by side.

use super::pass_image::{PassImage, black};
use std::collections::BTreeMap;
use std::ops::Range;
use traylib_math::Grid;

/// Sums over 2ᵏ passes of a sequence, the first of which has a multiple of 2ᵏ as its number.
#[derive(Clone, Debug, PartialEq)]
pub struct FilmBlock {
    /// The number of its first pass in the sequence.
    pub first: u64,
    /// The number of passes that are summed up.
    pub passes: u64,
    /// The sum of their radiance.
    pub sum: Grid<[f64; 3]>,
    /// The sum of its squares.
    pub squares: FilmSquares,
    /// The sums of further pictures by number, of those into which any light fell.
    pub layers: BTreeMap<u16, Grid<[f64; 3]>>,
}

/// Sums over the squares of what passes gave a pixel. Of passes, not of samples: samples of a
/// pass depend on one another.
#[derive(Clone, Debug, PartialEq)]
pub enum FilmSquares {
    /// Passes depend on one another, too.
    Unwanted,
    /// The squares are those of the sum: there is one pass.
    OfOne,
    /// The sum of the squares of more passes.
    Sum(Grid<[f64; 3]>),
}

impl FilmBlock {
    /// A pass by its number in its sequence. FilmSquares are kept of independent passes.
    pub(super) fn of_pass(number: u64, pass: PassImage, independent: bool) -> Self {
        let PassImage { light, layers } = pass;
        let squares = if independent { FilmSquares::OfOne } else { FilmSquares::Unwanted };
        Self { first: number, passes: 1, sum: light, squares, layers }
    }

    /// Tells whether it may be part of a film of so many sequences and pixels.
    pub(super) fn is_sound(&self, sequences: usize, width: usize, height: usize) -> bool {
        let fits = |grid: &Grid<[f64; 3]>| (grid.width(), grid.height()) == (width, height);
        let squares_fit = match &self.squares {
            FilmSquares::Unwanted => sequences > 1,
            FilmSquares::OfOne => sequences == 1 && self.passes == 1,
            FilmSquares::Sum(squares) => sequences == 1 && self.passes > 1 && fits(squares),
        };
        // Passes have numbers of 32 bits.
        let last = self.first.checked_add(self.passes).map(|end| end - 1);
        let last = last.and_then(|last| last.checked_mul(sequences as u64));
        self.passes.is_power_of_two()
            && self.first.is_multiple_of(self.passes)
            && last.is_some_and(|last| last <= u32::MAX.into())
            && squares_fit
            && fits(&self.sum)
            && self.layers.values().all(fits)
    }

    /// The numbers of its passes.
    pub(super) fn passes(&self) -> Range<u64> {
        self.first..self.first + self.passes
    }

    /// Returns the beginning of the block with which it makes one of twice its size.
    pub(super) fn sibling(&self) -> u64 {
        self.first ^ self.passes
    }

    /// Tells whether both make one block, this one first.
    pub(super) fn joins(&self, next: &Self) -> bool {
        self.passes == next.passes && self.sibling() == next.first && self.first < next.first
    }

    /// Adds the passes of the block that comes after it.
    pub(super) fn join(&mut self, next: &Self) {
        self.join_squares(next);
        add(&mut self.sum, next.sum.values().iter().copied());
        let (width, height) = (self.sum.width(), self.sum.height());
        for (&number, layer) in &next.layers {
            let sum = self.layers.entry(number).or_insert_with(|| black(width, height));
            add(sum, layer.values().iter().copied());
        }
        self.passes += next.passes;
    }

    fn join_squares(&mut self, next: &Self) {
        let squares = match &mut self.squares {
            FilmSquares::Unwanted => return,
            FilmSquares::Sum(squares) => squares,
            of_one @ FilmSquares::OfOne => {
                *of_one = FilmSquares::Sum(self.sum.map(|&sum| square(sum)));
                return self.join_squares(next);
            }
        };
        match &next.squares {
            FilmSquares::Sum(next) => add(squares, next.values().iter().copied()),
            FilmSquares::OfOne => add(squares, next.sum.values().iter().map(|&sum| square(sum))),
            FilmSquares::Unwanted => {}
        }
    }

    /// The sum of a pixel.
    pub(super) fn pixel(&self, index: usize) -> [f64; 3] {
        self.sum.values()[index]
    }

    /// The sum of the squares of a pixel: zero where they are not kept.
    pub(super) fn squares_of(&self, index: usize) -> [f64; 3] {
        match &self.squares {
            FilmSquares::Unwanted => [0.0; 3],
            FilmSquares::OfOne => square(self.pixel(index)),
            FilmSquares::Sum(squares) => squares.values()[index],
        }
    }

    /// The sums alone.
    pub(super) fn into_sum(self) -> Grid<[f64; 3]> {
        self.sum
    }

    /// The sum of a pixel of a layer.
    pub(super) fn layer_pixel(&self, number: u16, index: usize) -> [f64; 3] {
        self.layers.get(&number).map_or([0.0; 3], |layer| layer.values()[index])
    }

    /// The numbers of the layers into which light fell.
    pub(super) fn layers(&self) -> impl Iterator<Item = u16> {
        self.layers.keys().copied()
    }
}

fn square(values: [f64; 3]) -> [f64; 3] {
    values.map(|value| value * value)
}

fn add(sums: &mut Grid<[f64; 3]>, values: impl Iterator<Item = [f64; 3]>) {
    for (sum, value) in sums.values_mut().iter_mut().zip(values) {
        for (sum, value) in sum.iter_mut().zip(value) {
            *sum += value;
        }
    }
}
