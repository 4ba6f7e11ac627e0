//! The beginning of a film's file: everything but its sums.

use super::{FilmAbout, STRIPE};
use crate::MAX_PIXELS;
use crate::film_fault::{FilmFault, VERSION};
use std::collections::BTreeMap;
use std::io::Read;
use traylib_math::Grid;
use traylib_scene::{Film, FilmBlock, FilmSquares};

/// The first bytes of every film. A byte that is no text, and line ends of two kinds, show what
/// carelessness does to files on their way.
const MAGIC: [u8; 8] = *b"\x89FILM\r\n\n";

/// No header is longer: it has a line or two for each block and setting.
const MOST_BYTES: u32 = 1 << 22;

const BYTES_BEFORE: usize = 16;
const BYTES_OF_CHECKSUM: usize = 4;
const BYTES_OF_PIXEL: u64 = 24;

/// The contents of a film but for its sums.
#[derive(Debug)]
pub(super) struct Header {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) about: FilmAbout,
    /// The film without its pixels: blocks and layers.
    pub(super) shape: Film,
    /// Bytes that it takes in the file.
    pub(super) bytes: u64,
}

impl Header {
    /// The header of a film.
    pub(super) fn of(film: &Film, about: &FilmAbout) -> Self {
        Self {
            width: film.width() as u32,
            height: film.height() as u32,
            about: about.clone(),
            shape: shape_of(film),
            bytes: 0,
        }
    }

    /// Bytes of the sums of one pixel.
    pub(super) fn bytes_per_pixel(&self) -> u64 {
        let planes = |block: &FilmBlock| {
            let squares = u64::from(matches!(block.squares, FilmSquares::Sum(_)));
            1 + squares + block.layers.len() as u64
        };
        BYTES_OF_PIXEL * self.shape.sequences().flatten().map(planes).sum::<u64>()
    }

    /// Returns the number of pixels.
    pub(super) fn pixels(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height)
    }

    /// Returns the offset in bytes of the sums of a stripe, or of the end of the file.
    pub(super) fn offset(&self, pixel: u64) -> u64 {
        let stripes = pixel.div_ceil(STRIPE as u64);
        self.bytes + pixel * self.bytes_per_pixel() + stripes * BYTES_OF_CHECKSUM as u64
    }

    /// The bytes of the file.
    pub(super) fn encode(&self) -> Vec<u8> {
        let mut out = Output(Vec::new());
        out.u32(self.width);
        out.u32(self.height);
        out.u32(self.shape.sequences().len() as u32);
        let FilmAbout { settings, notes, counters } = &self.about;
        for texts in [settings, notes] {
            out.u32(texts.len() as u32);
            for (name, text) in texts {
                out.text(name);
                out.text(text);
            }
        }
        out.u32(counters.len() as u32);
        for (name, counter) in counters {
            out.text(name);
            out.u64(*counter);
        }
        for blocks in self.shape.sequences() {
            let blocks: Vec<&FilmBlock> = blocks.collect();
            out.u32(blocks.len() as u32);
            for block in blocks {
                out.u64(block.first);
                out.u64(block.passes);
                out.u32(block.layers.len() as u32);
                block.layers.keys().for_each(|&layer| out.u32(layer.into()));
            }
        }
        let body = out.0;
        let mut bytes = Vec::from(MAGIC);
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend((body.len() as u32).to_le_bytes());
        bytes.extend(body);
        let checksum = crc32fast::hash(&bytes);
        bytes.extend(checksum.to_le_bytes());
        bytes
    }

    /// Reads it from the beginning of a file.
    pub(super) fn read(file: &mut impl Read) -> Result<Self, FilmFault> {
        let mut bytes = Vec::new();
        file.take(BYTES_BEFORE as u64).read_to_end(&mut bytes)?;
        if !bytes.starts_with(&MAGIC) {
            return Err(FilmFault::Foreign);
        }
        let mut begin = Input(&bytes[MAGIC.len()..]);
        let (Some(version), Some(length)) = (begin.u32(), begin.u32()) else {
            return Err(FilmFault::Header);
        };
        if version != VERSION {
            return Err(FilmFault::Version(version));
        }
        if length > MOST_BYTES {
            return Err(FilmFault::Header);
        }
        file.take(u64::from(length) + BYTES_OF_CHECKSUM as u64).read_to_end(&mut bytes)?;
        let (all, checksum) = bytes.split_last_chunk().ok_or(FilmFault::Header)?;
        let is_whole = all.len() == BYTES_BEFORE + length as usize;
        if !is_whole || u32::from_le_bytes(*checksum) != crc32fast::hash(all) {
            return Err(FilmFault::Header);
        }
        let header = Self::decode(&mut Input(&all[BYTES_BEFORE..]), bytes.len() as u64);
        let header = header.ok_or(FilmFault::Header)?;
        match header.pixels() {
            too_many if too_many > MAX_PIXELS => Err(FilmFault::TooLarge(too_many)),
            _ => Ok(header),
        }
    }

    fn decode(input: &mut Input<'_>, bytes: u64) -> Option<Self> {
        let [width, height, sequences] = [input.u32()?, input.u32()?, input.u32()?];
        let settings = input.texts()?;
        let notes = input.texts()?;
        let counters = (0..input.count()?)
            .map(|_| Some((input.text()?, input.u64()?)))
            .collect::<Option<Vec<_>>>()?;
        let about = FilmAbout { settings, notes, counters };
        // Each has four bytes at least.
        if width == 0
            || height == 0
            || sequences == 0
            || u64::from(sequences) > input.0.len() as u64 / 4
        {
            return None;
        }
        let mut shape = Film::of_sequences(0, 0, sequences);
        for sequence in 0..sequences as usize {
            for _ in 0..input.count()? {
                let (first, passes) = (input.u64()?, input.u64()?);
                let layers = (0..input.count()?)
                    .map(|_| Some((u16::try_from(input.u32()?).ok()?, empty())))
                    .collect::<Option<BTreeMap<_, _>>>()?;
                let squares = match (sequences, passes) {
                    (1, 1) => FilmSquares::OfOne,
                    (1, _) => FilmSquares::Sum(empty()),
                    _ => FilmSquares::Unwanted,
                };
                let block = FilmBlock { first, passes, sum: empty(), squares, layers };
                shape.add_block(sequence, block).ok()?;
            }
        }
        input.0.is_empty().then_some(Self { width, height, about, shape, bytes })
    }
}

fn empty() -> Grid<[f64; 3]> {
    Grid::filled(0, 0, [0.0; 3])
}

/// A film without its pixels.
fn shape_of(film: &Film) -> Film {
    let mut shape = Film::of_sequences(0, 0, film.sequences().len() as u32);
    for (sequence, blocks) in film.sequences().enumerate() {
        for block in blocks {
            let squares = match block.squares {
                FilmSquares::Unwanted => FilmSquares::Unwanted,
                FilmSquares::OfOne => FilmSquares::OfOne,
                FilmSquares::Sum(_) => FilmSquares::Sum(empty()),
            };
            let layers = block.layers.keys().map(|&layer| (layer, empty())).collect();
            let (first, passes) = (block.first, block.passes);
            let block = FilmBlock { first, passes, sum: empty(), squares, layers };
            // It was in a film.
            let _ = shape.add_block(sequence, block);
        }
    }
    shape
}

/// Numbers with the lowest byte first, and texts after their length.
struct Output(Vec<u8>);

impl Output {
    fn u32(&mut self, number: u32) {
        self.0.extend(number.to_le_bytes());
    }

    fn u64(&mut self, number: u64) {
        self.0.extend(number.to_le_bytes());
    }

    fn text(&mut self, text: &str) {
        self.u32(text.len() as u32);
        self.0.extend(text.as_bytes());
    }
}

/// Reads the bytes that [`Output`] wrote; `None` where they end too soon.
struct Input<'a>(&'a [u8]);

impl<'a> Input<'a> {
    fn take(&mut self, bytes: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(bytes)?;
        self.0 = rest;
        Some(taken)
    }

    fn u32(&mut self) -> Option<u32> {
        Some(u32::from_le_bytes(self.take(4)?.try_into().ok()?))
    }

    fn u64(&mut self) -> Option<u64> {
        Some(u64::from_le_bytes(self.take(8)?.try_into().ok()?))
    }

    /// A number of entries, of which each takes four bytes at least.
    fn count(&mut self) -> Option<u32> {
        self.u32().filter(|&count| count as usize <= self.0.len() / 4)
    }

    fn text(&mut self) -> Option<String> {
        let length = self.u32()?;
        String::from_utf8(self.take(length as usize)?.to_vec()).ok()
    }

    fn texts(&mut self) -> Option<Vec<(String, String)>> {
        (0..self.count()?).map(|_| Some((self.text()?, self.text()?))).collect()
    }
}
