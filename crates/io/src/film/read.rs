//! Reading films, at once or stripe by stripe.

use super::header::Header;
use super::sums::{BYTES_OF_PIXEL, decode};
use super::{FilmAbout, STRIPE};
use crate::Error;
use crate::film_fault::FilmFault;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};
use traylib_math::Grid;
use traylib_scene::{Film, FilmBlock, FilmSquares};

/// A film's file of which the header has been read.
#[derive(Debug)]
pub struct FilmReader {
    path: PathBuf,
    header: Header,
    /// Open as long as it is read often.
    file: Option<File>,
    /// The offset of the next byte in the file, if it is open.
    at: u64,
}

impl FilmReader {
    /// Opens a file and reads what it says of itself.
    ///
    /// # Errors
    /// [`Error::ReadFilm`].
    pub fn open(path: &Path) -> Result<Self, Error> {
        let open = || {
            let mut file = File::open(path)?;
            if !file.metadata()?.is_file() {
                return Err(FilmFault::Foreign);
            }
            let header = Header::read(&mut file)?;
            let (found, wanted) = (file.metadata()?.len(), header.offset(header.pixels()));
            if found == wanted {
                Ok((file, header))
            } else {
                Err(FilmFault::Length { found, wanted })
            }
        };
        let (file, header) = open().map_err(|cause| error(path, cause))?;
        let at = header.bytes;
        Ok(Self { path: path.to_path_buf(), header, file: Some(file), at })
    }

    /// Its file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the description that the file has of the film.
    pub fn about(&self) -> &FilmAbout {
        &self.header.about
    }

    /// Width and height.
    pub fn size(&self) -> [u32; 2] {
        [self.header.width, self.header.height]
    }

    /// The film without its pixels: which passes it has, and which layers.
    pub fn shape(&self) -> &Film {
        &self.header.shape
    }

    /// Bytes of its file.
    pub fn bytes(&self) -> u64 {
        self.header.offset(self.header.pixels())
    }

    /// Gives the file back to the system until it is read again.
    pub(super) fn close(&mut self) {
        self.file = None;
    }

    /// A stripe of pixels as a film of one row. `bytes` is room for what is in the file: of
    /// thousands of films, only one at a time needs it.
    pub(super) fn read_stripe(
        &mut self,
        pixels: &Range<usize>,
        bytes: &mut Vec<u8>,
    ) -> Result<Film, Error> {
        self.fetch(pixels, bytes)?;
        let mut blocks = self.blank_blocks(pixels.len(), 1);
        decode_into(&mut blocks, bytes, &(0..pixels.len()));
        Ok(self.film_of(blocks, pixels.len() as u32, 1))
    }

    /// All of it.
    fn read_whole(mut self) -> Result<(Film, FilmAbout), Error> {
        let [width, height] = self.size();
        let pixels = self.header.pixels() as usize;
        let mut bytes = Vec::new();
        let mut blocks = self.blank_blocks(width as usize, height as usize);
        for start in (0..pixels).step_by(STRIPE) {
            let stripe = start..(start + STRIPE).min(pixels);
            self.fetch(&stripe, &mut bytes)?;
            decode_into(&mut blocks, &bytes, &stripe);
        }
        Ok((self.film_of(blocks, width, height), self.header.about))
    }

    /// Its blocks without light, each with its sequence.
    fn blank_blocks(&self, width: usize, height: usize) -> Vec<(usize, FilmBlock)> {
        let black = || Grid::filled(width, height, [0.0; 3]);
        let blank = |block: &FilmBlock| FilmBlock {
            first: block.first,
            passes: block.passes,
            sum: black(),
            squares: match &block.squares {
                FilmSquares::Unwanted => FilmSquares::Unwanted,
                FilmSquares::OfOne => FilmSquares::OfOne,
                FilmSquares::Sum(_) => FilmSquares::Sum(black()),
            },
            layers: block.layers.keys().map(|&layer| (layer, black())).collect(),
        };
        let sequences = self.header.shape.sequences().enumerate();
        sequences
            .flat_map(|(n, blocks)| blocks.map(move |block| (n, block)))
            .map(|(n, block)| (n, blank(block)))
            .collect()
    }

    fn film_of(&self, blocks: Vec<(usize, FilmBlock)>, width: u32, height: u32) -> Film {
        let sequences = self.header.shape.sequences().len() as u32;
        let mut film = Film::of_sequences(width, height, sequences);
        for (sequence, block) in blocks {
            // It was in the header's own film.
            let _ = film.add_block(sequence, block);
        }
        film
    }

    /// Reads the bytes of a stripe and holds them against their checksum.
    fn fetch(&mut self, pixels: &Range<usize>, bytes: &mut Vec<u8>) -> Result<(), Error> {
        let begin = self.header.offset(pixels.start as u64);
        let end = self.header.offset(pixels.end as u64);
        bytes.resize((end - begin) as usize, 0);
        let fetched = self.fetch_bytes(begin, bytes);
        fetched.map_err(|cause| error(&self.path, cause.into()))?;
        let checksum = bytes.split_off(bytes.len() - 4);
        if crc32fast::hash(bytes).to_le_bytes() == checksum[..] {
            Ok(())
        } else {
            Err(error(&self.path, FilmFault::Pixels(pixels.start as u64)))
        }
    }

    fn fetch_bytes(&mut self, begin: u64, bytes: &mut [u8]) -> std::io::Result<()> {
        let file = match &mut self.file {
            Some(file) => file,
            closed => {
                self.at = 0;
                closed.insert(File::open(&self.path)?)
            }
        };
        if self.at != begin {
            file.seek(SeekFrom::Start(begin))?;
        }
        file.read_exact(bytes)?;
        self.at = begin + bytes.len() as u64;
        Ok(())
    }
}

/// A whole film, and what it says of itself.
///
/// # Errors
/// [`Error::ReadFilm`].
pub fn load_film(path: &Path) -> Result<(Film, FilmAbout), Error> {
    FilmReader::open(path)?.read_whole()
}

/// Puts the bytes of a stripe into these pixels of blocks.
fn decode_into(blocks: &mut [(usize, FilmBlock)], bytes: &[u8], pixels: &Range<usize>) {
    let planes = blocks.iter_mut().flat_map(|(_, block)| planes_mut(block));
    for (plane, bytes) in planes.zip(bytes.chunks_exact(BYTES_OF_PIXEL * pixels.len())) {
        decode(bytes, &mut plane.values_mut()[pixels.clone()]);
    }
}

/// Returns the planes of a block in the order in which they are read.
fn planes_mut(block: &mut FilmBlock) -> impl Iterator<Item = &mut Grid<[f64; 3]>> {
    let squares = match &mut block.squares {
        FilmSquares::Sum(squares) => Some(squares),
        FilmSquares::Unwanted | FilmSquares::OfOne => None,
    };
    std::iter::once(&mut block.sum).chain(squares).chain(block.layers.values_mut())
}

fn error(path: &Path, cause: FilmFault) -> Error {
    Error::ReadFilm { file: path.to_path_buf(), cause }
}
