//! The arguments of a transform: one copy, or an array of them.

use super::Cause;
use super::error::shown;
use super::transform::Transform;
use super::words::{count, number, within};
use traylib_math::glam::DVec3;

/// The copies that a list of arguments stands for. Of segments that are the same in
/// every copy no two follow each other.
#[derive(Clone, Debug)]
pub(super) struct Copies(Vec<Segment>);

/// Arguments between an `-i` or `-a` and the next.
#[derive(Clone, Debug)]
struct Segment {
    transform: Transform,
    repeat: Repeat,
}

#[derive(Clone, Copy, Debug)]
enum Repeat {
    /// `-i`
    Times(u64),
    /// `-a`: copy k repeats it k times.
    Array(u64),
}

/// The most `-a` in one list.
const MAX_DIMENSIONS: usize = 8;

impl Copies {
    pub(super) fn parse(words: &[&str]) -> Result<Self, Cause> {
        let mut copies = Self(Vec::new());
        let mut segment = Segment::new(Repeat::Times(1));
        let mut words = Words(words);
        while let Some(word) = words.next() {
            let repeat = match word {
                "-i" => Repeat::Times(words.count(word)?),
                // No copies mean one, as in Radiance.
                "-a" => Repeat::Array(words.count(word)?.max(1)),
                _ => {
                    segment.transform = segment.transform.then(&words.step(word)?);
                    continue;
                }
            };
            copies.push(std::mem::replace(&mut segment, Segment::new(repeat)));
        }
        copies.push(segment);
        let arrays = copies.0.iter().filter(|segment| segment.is_array()).count();
        if arrays > MAX_DIMENSIONS {
            return Err(Cause::Illegal("an array has 8 dimensions at most"));
        }
        Ok(copies)
    }

    fn push(&mut self, mut segment: Segment) {
        if let Repeat::Times(times) = segment.repeat {
            segment =
                Segment { transform: segment.transform.repeated(times), repeat: Repeat::Times(1) };
            if let Some(last) = self.0.last_mut().filter(|last| !last.is_array()) {
                last.transform = last.transform.then(&segment.transform);
                return;
            }
        }
        self.0.push(segment);
    }

    /// Returns the number of parts that a copy is computed from; 17 at most.
    pub(super) fn segments(&self) -> u64 {
        self.0.len() as u64
    }

    /// Returns the number of copies, at most `u64::MAX`.
    pub(super) fn count(&self) -> u64 {
        self.0.iter().fold(1, |product: u64, segment| product.saturating_mul(segment.size()))
    }

    /// Copy number `index`; the last array counts fastest.
    pub(super) fn transform(&self, mut index: u64) -> Transform {
        let mut total = Transform::IDENTITY;
        for segment in self.0.iter().rev() {
            let times = match segment.repeat {
                Repeat::Times(times) => times,
                Repeat::Array(size) => index % size,
            };
            index /= segment.size();
            total = segment.transform.repeated(times).then(&total);
        }
        total
    }
}

impl Segment {
    fn new(repeat: Repeat) -> Self {
        Self { transform: Transform::IDENTITY, repeat }
    }

    fn is_array(&self) -> bool {
        matches!(self.repeat, Repeat::Array(_))
    }

    fn size(&self) -> u64 {
        match self.repeat {
            Repeat::Times(_) => 1,
            Repeat::Array(size) => size,
        }
    }
}

/// Words not yet read.
struct Words<'a, 'w>(&'a [&'w str]);

impl<'w> Words<'_, 'w> {
    fn next(&mut self) -> Option<&'w str> {
        let (first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(first)
    }

    fn value(&mut self, option: &str) -> Result<&'w str, Cause> {
        self.next().ok_or_else(|| Cause::OptionCut(shown(option)))
    }

    fn count(&mut self, option: &str) -> Result<u64, Cause> {
        count(self.value(option)?)
    }

    fn number(&mut self, option: &str) -> Result<f64, Cause> {
        number(self.value(option)?)
    }

    fn step(&mut self, option: &str) -> Result<Transform, Cause> {
        Ok(match option {
            "-t" => {
                let [x, y, z] = [self.number(option)?, self.number(option)?, self.number(option)?];
                Transform::shift(DVec3::new(x, y, z))
            }
            "-rx" => Transform::rotation(0, self.number(option)?),
            "-ry" => Transform::rotation(1, self.number(option)?),
            "-rz" => Transform::rotation(2, self.number(option)?),
            "-s" => {
                let factor = self.number(option)?;
                Transform::scaling(within(factor != 0.0, factor, "the scale", "other than 0")?)
            }
            "-mx" => Transform::mirror(0),
            "-my" => Transform::mirror(1),
            "-mz" => Transform::mirror(2),
            _ => return Err(Cause::UnknownOption(shown(option))),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn origins(arguments: &str) -> Vec<[f64; 3]> {
        let words: Vec<&str> = arguments.split_whitespace().collect();
        let copies = Copies::parse(&words).unwrap();
        let origin = |index| copies.transform(index).point(DVec3::ZERO).round().to_array();
        (0..copies.count()).map(origin).collect()
    }

    #[test]
    fn a_grid_counts_its_last_dimension_fastest() {
        let grid = origins("-t 1 1 10 -a 3 -t 3 0 0 -a 5 -t 0 3 0");
        assert_eq!(grid.len(), 15);
        assert_eq!(grid[..2], [[1.0, 1.0, 10.0], [1.0, 4.0, 10.0]]);
        assert_eq!((grid[5], grid[14]), ([4.0, 1.0, 10.0], [7.0, 13.0, 10.0]));
    }

    #[test]
    fn what_stands_before_and_after_an_array_acts_on_every_copy() {
        assert_eq!(origins("-t 1 0 0 -a 2 -mx"), [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]]);
        let scaled = origins("-a 2 -t 1 0 0 -i 1 -s 10 -t 0 1 0");
        assert_eq!(scaled, [[0.0, 1.0, 0.0], [10.0, 1.0, 0.0]]);
    }

    #[test]
    fn repetitions_end_at_the_next_one() {
        assert_eq!(origins("-i 3 -t 1 0 0 -rz 90"), [[-1.0, 0.0, 0.0]]);
        assert_eq!(origins("-t 1 0 0 -i 2 -s 2 -i 1 -t 0 1 0"), [[4.0, 1.0, 0.0]]);
        assert_eq!(origins("-i 0 -t 1 0 0"), [[0.0; 3]]);
        assert_eq!(origins("-a 0 -t 1 0 0"), [[0.0; 3]]);
        // No more work than for a small number.
        assert_eq!(origins("-i 1000000000000 -mx"), [[0.0; 3]]);
    }

    #[test]
    fn absurd_counts_are_no_overflow() {
        let words: Vec<&str> = "-a 4000000000 -mx -a 4000000000 -my -a 9".split(' ').collect();
        assert_eq!(Copies::parse(&words).unwrap().count(), u64::MAX);
    }

    #[test]
    fn other_arguments_are_refused() {
        for arguments in
            ["-t 1 2", "-q", "1", "-s 0", "-s", "-rx a", "-a -1", "-a 1.5", "-i", "-t 1 2 inf"]
        {
            let words: Vec<&str> = arguments.split(' ').collect();
            assert!(Copies::parse(&words).is_err(), "{arguments}");
        }
        assert!(Copies::parse(&["-a", "1"].repeat(8)).is_ok());
        assert!(Copies::parse(&["-a", "1"].repeat(9)).is_err());
    }
}
