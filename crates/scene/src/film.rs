//! The film, which gathers light.

mod block;
mod pass_image;
mod sequence;

pub use block::{FilmBlock, FilmSquares};
pub use pass_image::PassImage;

use sequence::Sequence;
use std::collections::{BTreeMap, BTreeSet};
use traylib_math::{Grid, Rgb};

/// The mean of many passes, and how much they differ.
///
/// Samples within a pass depend on one another, once light paths splat. Passes do not as a
/// rule, so the pass is what variance is estimated from. Those of quasi-random points do: they
/// belong to sequences by turns, and variance is estimated from the means of these.
///
/// Passes have numbers, and a film may hold any of them. Sums are made of two halves, those
/// of halves again, as numbers say, whoever rendered what first: a film that is
/// [merged](Self::merge) from parts has the bits of one that was rendered at once.
///
/// Each sum that waits for its other half takes 48 bytes a pixel, and 24 more for each further
/// picture; that of a single pass or in one of several sequences takes 24 and 24. Of the first n
/// passes of a sequence as many sums wait as n has binary ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    width: usize,
    height: usize,
    /// Passes belong to them by turns.
    sequences: Vec<Sequence>,
}

/// The reason why two films cannot become one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MergeError {
    /// They have different sizes: width and height of each.
    #[error("one film has {}x{} pixels, the other {}x{}", .0[0][0], .0[0][1], .0[1][0], .0[1][1])]
    Size([[usize; 2]; 2]),
    /// Their passes belong to different numbers of sequences.
    #[error("the passes of one film make {} sequences, those of the other {}", .0[0], .0[1])]
    Sequences([usize; 2]),
    /// Both have this pass, whose light would count twice.
    #[error("both films have pass {0}")]
    SamePass(u64),
    /// A block cannot be part of such a film: its size, the numbers of its passes, or which
    /// squares it keeps.
    #[error("a block of {passes} passes from {first} on cannot be part of this film")]
    Block {
        /// The first of its passes.
        first: u64,
        /// The number of passes.
        passes: u64,
    },
}

impl Film {
    /// A film without light, for passes that are independent of one another.
    pub fn new(width: u32, height: u32) -> Self {
        Self::of_sequences(width, height, 1)
    }

    /// A film without light whose passes belong to so many sequences by turns, the means of
    /// which are independent; to one if passes are.
    ///
    /// # Panics
    /// If there is no sequence.
    pub fn of_sequences(width: u32, height: u32, sequences: u32) -> Self {
        assert!(sequences > 0, "passes belong to a sequence");
        let sequences = vec![Sequence::default(); sequences as usize];
        Self { width: width as usize, height: height as usize, sequences }
    }

    /// Adds a pass of the same size, which has this number.
    ///
    /// # Panics
    /// If the sizes differ, or the film has this pass.
    pub fn add_pass(&mut self, number: u32, pass: PassImage) {
        let (width, height) = (pass.light.width(), pass.light.height());
        let (sequence, place) = self.place(number);
        let block = FilmBlock::of_pass(place, pass, self.sequences.len() == 1);
        let mut film =
            Self { width, height, sequences: vec![Sequence::default(); self.sequences.len()] };
        film.sequences[sequence].insert(block);
        if let Err(error) = self.merge(film) {
            panic!("{error}");
        }
    }

    /// Adds the passes of another film, in any order: the result is the same, bit for bit.
    ///
    /// # Errors
    /// [`MergeError`] if the sizes or the numbers of sequences differ, or a pass is in both; then
    /// nothing is added.
    pub fn merge(&mut self, other: Self) -> Result<(), MergeError> {
        let sizes = [self, &other].map(|film| [film.width, film.height]);
        if sizes[0] != sizes[1] {
            return Err(MergeError::Size(sizes));
        }
        let counts = [self, &other].map(|film| film.sequences.len());
        if counts[0] != counts[1] {
            return Err(MergeError::Sequences(counts));
        }
        for (number, (own, other)) in self.sequences.iter().zip(&other.sequences).enumerate() {
            if let Some(pass) = other.blocks().find_map(|block| own.first_of(&block.passes())) {
                return Err(MergeError::SamePass(pass * counts[0] as u64 + number as u64));
            }
        }
        for (own, other) in self.sequences.iter_mut().zip(other.sequences) {
            other.into_blocks().into_iter().for_each(|block| own.insert(block));
        }
        Ok(())
    }

    /// Adds passes that were summed up elsewhere to a sequence.
    ///
    /// # Errors
    /// [`MergeError::Block`] if no film like this has such sums, [`MergeError::SamePass`] if one
    /// of the passes is there; then nothing is added.
    ///
    /// # Panics
    /// If there is no such sequence.
    pub fn add_block(&mut self, sequence: usize, block: FilmBlock) -> Result<(), MergeError> {
        let sequences = self.sequences.len();
        if !block.is_sound(sequences, self.width, self.height) {
            return Err(MergeError::Block { first: block.first, passes: block.passes });
        }
        if let Some(pass) = self.sequences[sequence].first_of(&block.passes()) {
            return Err(MergeError::SamePass(pass * sequences as u64 + sequence as u64));
        }
        self.sequences[sequence].insert(block);
        Ok(())
    }

    /// The blocks of each sequence, in the order of their passes: all that there is.
    pub fn sequences(&self) -> impl ExactSizeIterator<Item = impl Iterator<Item = &FilmBlock>> {
        self.sequences.iter().map(Sequence::blocks)
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Tells whether it has the pass of this number.
    pub fn has_pass(&self, number: u32) -> bool {
        let (sequence, pass) = self.place(number);
        self.sequences[sequence].has(pass)
    }

    /// The numbers of its passes, in their order.
    pub fn pass_numbers(&self) -> Vec<u32> {
        let number =
            |place: u64, sequence: usize| place * self.sequences.len() as u64 + sequence as u64;
        let of = |(sequence, passes): (usize, &Sequence)| {
            let places = passes.blocks().flat_map(FilmBlock::passes).collect::<Vec<u64>>();
            places.into_iter().map(move |place| number(place, sequence) as u32)
        };
        let mut numbers: Vec<u32> = self.sequences.iter().enumerate().flat_map(of).collect();
        numbers.sort_unstable();
        numbers
    }

    /// Returns the number of passes that it holds.
    pub fn passes(&self) -> u32 {
        self.sequences.iter().map(Sequence::passes).sum()
    }

    /// The sequence of a pass, and its number in that.
    fn place(&self, number: u32) -> (usize, u64) {
        let number = number as usize;
        (number % self.sequences.len(), (number / self.sequences.len()) as u64)
    }

    fn blocks(&self) -> impl Iterator<Item = &FilmBlock> {
        self.sequences.iter().flat_map(Sequence::blocks)
    }

    /// Mean radiance of each pixel, in W/m²/sr; black without passes.
    pub fn mean(&self) -> Grid<[f64; 3]> {
        self.picture(|pixel| self.mean_of(pixel))
    }

    /// Mean radiance of each pixel in each sequence, with the number of its passes: black without
    /// any. The means are independent of one another.
    pub fn sequence_means(&self) -> impl Iterator<Item = (Grid<[f64; 3]>, u32)> {
        self.sequences.iter().map(|sequence| {
            let passes = sequence.passes();
            let n = f64::from(passes.max(1));
            let mean =
                |pixel| total(sequence.blocks().map(|block| block.pixel(pixel))).map(|sum| sum / n);
            (self.picture(mean), passes)
        })
    }

    /// The mean as a picture.
    pub fn develop(&self) -> Grid<Rgb> {
        self.picture(|pixel| self.develop_pixel(pixel))
    }

    /// A pixel of [`develop`](Self::develop) by its row-major index, for whoever makes the
    /// picture on many threads.
    ///
    /// # Panics
    /// If there are passes, and no such pixel.
    #[inline]
    pub fn develop_pixel(&self, pixel: usize) -> Rgb {
        Rgb::from(self.mean_of(pixel).map(|band| band as f32))
    }

    /// The mean as a picture, for which the film is given up: of a single sum the memory of a
    /// picture alone is needed in the end, and that of the film on the way.
    pub fn into_picture(self) -> Grid<Rgb> {
        let n = f64::from(self.passes());
        if self.blocks().count() != 1 {
            return self.develop();
        }
        let blocks = self.sequences.into_iter().flat_map(Sequence::into_blocks);
        let pixel = |sum: [f64; 3]| Rgb::from(sum.map(|band| (band / n) as f32));
        let mut pictures = blocks.map(|block| block.into_sum().into_map(pixel));
        pictures.next_back().unwrap_or_else(|| Grid::filled(self.width, self.height, Rgb::BLACK))
    }

    /// The means of further pictures, by number, of those into which any light fell.
    pub fn develop_layers(&self) -> BTreeMap<u16, Grid<Rgb>> {
        let numbers: BTreeSet<u16> = self.blocks().flat_map(FilmBlock::layers).collect();
        let n = f64::from(self.passes().max(1));
        let mean = |number, pixel| {
            let sums = self.blocks().map(|block| block.layer_pixel(number, pixel));
            Rgb::from(total(sums).map(|sum| (sum / n) as f32))
        };
        numbers
            .into_iter()
            .map(|number| (number, self.picture(|pixel| mean(number, pixel))))
            .collect()
    }

    /// Estimated variance of each pixel's mean; `None` before two passes, or two sequences.
    pub fn variance_of_mean(&self) -> Option<Grid<[f64; 3]>> {
        (self.independent_means() > 1).then(|| self.picture(|pixel| self.moments_of(pixel).1))
    }

    /// Estimated error of the picture: root of the mean variance over the mean
    /// radiance; `None` before two passes, or two sequences, or without light.
    pub fn relative_error(&self) -> Option<f64> {
        if self.independent_means() < 2 {
            return None;
        }
        let (mut mean, mut variance) = (0.0, 0.0);
        for pixel in 0..self.width * self.height {
            let (mean_of, variance_of) = self.moments_of(pixel);
            mean += mean_of.iter().sum::<f64>();
            variance += variance_of.iter().sum::<f64>();
        }
        let count = 3.0 * (self.width * self.height) as f64;
        (mean > 0.0).then(|| (variance / count).sqrt() / (mean / count))
    }

    /// Counts what the variance is estimated from: passes, or sequences that have any.
    fn independent_means(&self) -> usize {
        match &self.sequences[..] {
            [one] => one.passes() as usize,
            more => more.iter().filter(|sequence| sequence.passes() > 0).count(),
        }
    }

    fn mean_of(&self, pixel: usize) -> [f64; 3] {
        let n = f64::from(self.passes().max(1));
        total(self.blocks().map(|block| block.pixel(pixel))).map(|sum| sum / n)
    }

    /// Mean, and variance of the mean, of at least two passes.
    fn moments_of(&self, pixel: usize) -> ([f64; 3], [f64; 3]) {
        let mean = self.mean_of(pixel);
        let variance = match &self.sequences[..] {
            [_] => self.variance_between_passes(pixel, mean),
            sequences => variance_between_sequences(sequences, pixel, mean),
        };
        (mean, variance)
    }

    fn variance_between_passes(&self, pixel: usize, mean: [f64; 3]) -> [f64; 3] {
        let n = f64::from(self.passes());
        let squares = total(self.blocks().map(|block| block.squares_of(pixel)));
        [0, 1, 2].map(|b| (squares[b] / n - mean[b] * mean[b]).max(0.0) / (n - 1.0))
    }

    /// A picture by the row-major indices of its pixels.
    fn picture<T>(&self, pixel: impl FnMut(usize) -> T) -> Grid<T> {
        Grid::from_fn(self.width, self.height, pixel)
    }
}

/// From the means of sequences, each counted by its passes.
fn variance_between_sequences(sequences: &[Sequence], pixel: usize, mean: [f64; 3]) -> [f64; 3] {
    let passes: u32 = sequences.iter().map(Sequence::passes).sum();
    let (mut squares, mut count) = ([0.0; 3], 0.0);
    for sequence in sequences.iter().filter(|sequence| sequence.passes() > 0) {
        let own_passes = f64::from(sequence.passes());
        let sum = total(sequence.blocks().map(|block| block.pixel(pixel)));
        for band in 0..3 {
            let deviation = sum[band] / own_passes - mean[band];
            squares[band] += own_passes / f64::from(passes) * deviation * deviation;
        }
        count += 1.0;
    }
    squares.map(|square| square / (count - 1.0))
}

/// The sum of vectors, one after the other.
fn total(values: impl Iterator<Item = [f64; 3]>) -> [f64; 3] {
    values.fold([0.0; 3], |sum, value| [0, 1, 2].map(|band| sum[band] + value[band]))
}

#[cfg(test)]
mod tests;
