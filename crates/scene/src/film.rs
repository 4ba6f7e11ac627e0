//! Where light is gathered.

mod block;
mod pass_image;

pub use pass_image::PassImage;

use block::Block;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use traylib_math::{Grid, Rgb};

/// The mean of many passes, and how much they differ.
///
/// Passes are independent of one another; samples within a pass are not, once
/// light paths splat. So the pass is what variance is estimated from.
///
/// Passes have numbers, and a film may hold any of them. Sums are made of two halves, those
/// of halves again, as numbers say, whoever rendered what first: a film that is
/// [merged](Self::merge) from parts has the bits of one that was rendered at once.
///
/// Each sum that waits for its other half takes 48 bytes a pixel, and 24 more for each further
/// picture; that of a single pass takes 24 and 24. Of the first n passes as many sums wait as
/// n has binary ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    width: usize,
    height: usize,
    /// In the order of their passes; no two of them make one.
    blocks: Vec<Block>,
}

/// Why two films cannot become one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MergeError {
    /// They have different sizes: width and height of each.
    #[error("one film has {}x{} pixels, the other {}x{}", .0[0][0], .0[0][1], .0[1][0], .0[1][1])]
    Size([[usize; 2]; 2]),
    /// Both have this pass, whose light would count twice.
    #[error("both films have pass {0}")]
    SamePass(u64),
}

impl Film {
    /// A film without light.
    pub fn new(width: u32, height: u32) -> Self {
        Self { width: width as usize, height: height as usize, blocks: Vec::new() }
    }

    /// Adds a pass of the same size, which has this number.
    ///
    /// # Panics
    /// If the sizes differ, or the film has this pass.
    pub fn add_pass(&mut self, number: u32, pass: PassImage) {
        let (width, height) = (pass.light.width(), pass.light.height());
        let film = Self { width, height, blocks: vec![Block::of_pass(number, pass)] };
        if let Err(error) = self.merge(film) {
            panic!("{error}");
        }
    }

    /// Adds the passes of another film, in any order: the result is the same, bit for bit.
    ///
    /// # Errors
    /// [`MergeError`] if the sizes differ or a pass is in both; then nothing is added.
    pub fn merge(&mut self, other: Self) -> Result<(), MergeError> {
        let sizes = [self, &other].map(|film| [film.width, film.height]);
        if sizes[0] != sizes[1] {
            return Err(MergeError::Size(sizes));
        }
        for block in &other.blocks {
            self.check_free(block.passes())?;
        }
        for block in other.blocks {
            self.insert(block);
        }
        Ok(())
    }

    fn check_free(&self, passes: Range<u64>) -> Result<(), MergeError> {
        let first = |block: &Block| passes.start.max(block.passes().start);
        let both = |block: &&Block| first(block) < passes.end.min(block.passes().end);
        self.blocks.iter().find(both).map_or(Ok(()), |b| Err(MergeError::SamePass(first(b))))
    }

    /// Adds a block of passes that are not there yet.
    fn insert(&mut self, block: Block) {
        let mut place =
            self.blocks.partition_point(|other| other.passes().start < block.passes().start);
        self.blocks.insert(place, block);
        // As long as it has become one half of something, and the other half is there.
        loop {
            if place > 0 && self.blocks[place - 1].joins(&self.blocks[place]) {
                place -= 1;
            } else if !self.blocks.get(place + 1).is_some_and(|next| self.blocks[place].joins(next))
            {
                return;
            }
            let next = self.blocks.remove(place + 1);
            self.blocks[place].join(&next);
        }
    }

    /// Whether it has the pass of this number.
    pub fn has_pass(&self, number: u32) -> bool {
        self.blocks.iter().any(|block| block.passes().contains(&number.into()))
    }

    /// How many passes there are.
    pub fn passes(&self) -> u32 {
        let count = |block: &Block| (block.passes().end - block.passes().start) as u32;
        self.blocks.iter().map(count).sum()
    }

    /// Mean radiance of each pixel, in W/m²/sr; black without passes.
    pub fn mean(&self) -> Grid<[f64; 3]> {
        self.picture(|pixel| self.mean_of(pixel))
    }

    /// The mean as a picture.
    pub fn develop(&self) -> Grid<Rgb> {
        self.picture(|pixel| Rgb::from(self.mean_of(pixel).map(|band| band as f32)))
    }

    /// The mean as a picture, for which the film is given up: of a single sum the memory of a
    /// picture alone is needed in the end, and that of the film on the way.
    pub fn into_picture(mut self) -> Grid<Rgb> {
        if self.blocks.len() != 1 {
            return self.develop();
        }
        let n = f64::from(self.passes());
        let sum = self.blocks.remove(0).into_sum();
        sum.into_map(|sum| Rgb::from(sum.map(|band| (band / n) as f32)))
    }

    /// The means of further pictures, by number, of those into which any light fell.
    pub fn develop_layers(&self) -> BTreeMap<u16, Grid<Rgb>> {
        let numbers: BTreeSet<u16> = self.blocks.iter().flat_map(Block::layers).collect();
        let n = f64::from(self.passes().max(1));
        let mean = |number, pixel| {
            let sums = self.blocks.iter().map(|block| block.layer_pixel(number, pixel));
            Rgb::from(total(sums).map(|sum| (sum / n) as f32))
        };
        numbers
            .into_iter()
            .map(|number| (number, self.picture(|pixel| mean(number, pixel))))
            .collect()
    }

    /// Estimated variance of each pixel's mean; `None` before two passes.
    pub fn variance_of_mean(&self) -> Option<Grid<[f64; 3]>> {
        (self.passes() > 1).then(|| self.picture(|pixel| self.moments_of(pixel).1))
    }

    /// Estimated error of the picture: root of the mean variance over the mean
    /// radiance; `None` before two passes or without light.
    pub fn relative_error(&self) -> Option<f64> {
        if self.passes() < 2 {
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

    fn mean_of(&self, pixel: usize) -> [f64; 3] {
        let n = f64::from(self.passes().max(1));
        total(self.blocks.iter().map(|block| block.pixel(pixel).0)).map(|sum| sum / n)
    }

    /// Mean, and variance of the mean, of at least two passes.
    fn moments_of(&self, pixel: usize) -> ([f64; 3], [f64; 3]) {
        let n = f64::from(self.passes());
        let (mut sum, mut squares) = ([0.0; 3], [0.0; 3]);
        for (of_block, squares_of_block) in self.blocks.iter().map(|block| block.pixel(pixel)) {
            for band in 0..3 {
                sum[band] += of_block[band];
                squares[band] += squares_of_block[band];
            }
        }
        let mean = sum.map(|sum| sum / n);
        let variance =
            |band: usize| (squares[band] / n - mean[band] * mean[band]).max(0.0) / (n - 1.0);
        (mean, [0, 1, 2].map(variance))
    }

    /// A picture by the row-major indices of its pixels.
    fn picture<T>(&self, pixel: impl FnMut(usize) -> T) -> Grid<T> {
        Grid::from_fn(self.width, self.height, pixel)
    }
}

/// The sum of vectors, one after the other.
fn total(values: impl Iterator<Item = [f64; 3]>) -> [f64; 3] {
    values.fold([0.0; 3], |sum, value| [0, 1, 2].map(|band| sum[band] + value[band]))
}

#[cfg(test)]
mod tests;
