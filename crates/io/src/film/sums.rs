//! The sums of a stripe of pixels as bytes.

use std::io::{self, Write};
use std::ops::Range;
use traylib_math::Grid;
use traylib_scene::{Film, FilmBlock, FilmSquares};

/// Three bands of eight bytes.
pub(super) const BYTES_OF_PIXEL: usize = 24;

/// Writes stripes; keeps its memory from one to the next.
#[derive(Debug, Default)]
pub(super) struct StripeWriter(Vec<u8>);

impl StripeWriter {
    /// Writes the sums of these pixels of a film, and their checksum.
    pub(super) fn write(
        &mut self,
        out: &mut dyn Write,
        film: &Film,
        pixels: Range<usize>,
    ) -> io::Result<()> {
        let mut checksum = crc32fast::Hasher::new();
        for plane in film.sequences().flatten().flat_map(planes) {
            encode(&plane.values()[pixels.clone()], &mut self.0);
            checksum.update(&self.0);
            out.write_all(&self.0)?;
        }
        out.write_all(&checksum.finalize().to_le_bytes())
    }
}

/// Returns the planes of a block in the order in which they are written.
fn planes(block: &FilmBlock) -> impl Iterator<Item = &Grid<[f64; 3]>> {
    let squares = match &block.squares {
        FilmSquares::Sum(squares) => Some(squares),
        FilmSquares::Unwanted | FilmSquares::OfOne => None,
    };
    std::iter::once(&block.sum).chain(squares).chain(block.layers.values())
}

fn encode(sums: &[[f64; 3]], bytes: &mut Vec<u8>) {
    bytes.resize(BYTES_OF_PIXEL * sums.len(), 0);
    let bands = sums.as_flattened().iter();
    for (bytes, band) in bytes.as_chunks_mut().0.iter_mut().zip(bands) {
        *bytes = band.to_le_bytes();
    }
}

/// The opposite of [`encode`], for as many sums as there is room for.
pub(super) fn decode(bytes: &[u8], sums: &mut [[f64; 3]]) {
    let bands = sums.as_flattened_mut().iter_mut();
    for (band, bytes) in bands.zip(bytes.as_chunks().0) {
        *band = f64::from_le_bytes(*bytes);
    }
}
