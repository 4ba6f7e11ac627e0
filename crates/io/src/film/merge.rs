//! Many films made one, in the memory of a stripe or two.

use super::header::Header;
use super::read::FilmReader;
use super::sums::StripeWriter;
use super::{FilmAbout, STRIPE};
use crate::film_fault::FilmDifference;
use crate::{Error, write_file_by};
use std::io;
use std::path::Path;
use traylib_scene::{Film, MergeError};

/// Files that stay open from stripe to stripe; systems allow some hundreds.
const MOST_OPEN: usize = 200;

/// Puts films into the order of their passes and finds out whether they fit together: the
/// film that they make, without its pixels.
///
/// # Errors
/// [`Error::FilmsDiffer`] or [`Error::FilmsOverlap`], of two films.
///
/// # Panics
/// If there is no film.
pub fn check_films_fit(films: &mut [FilmReader]) -> Result<Film, Error> {
    films.sort_by_cached_key(|film| film.shape().pass_numbers().first().copied());
    let (first, others) = films.split_first().expect("there is a film");
    let mut shape = first.shape().clone();
    for (count, film) in (1..).zip(others) {
        if let Some(difference) = difference(first, film) {
            return Err(Error::FilmsDiffer { files: files(first, film), difference });
        }
        // Nothing else can be wrong.
        if let Err(MergeError::SamePass(pass)) = shape.merge(film.shape().clone()) {
            let has_it = |film: &&FilmReader| film.shape().has_pass(pass as u32);
            let other = films[..count].iter().find(has_it).unwrap_or(&films[0]);
            return Err(Error::FilmsOverlap { files: files(other, film), pass });
        }
    }
    Ok(shape)
}

fn files(a: &FilmReader, b: &FilmReader) -> [std::path::PathBuf; 2] {
    [a, b].map(|film| film.path().to_path_buf())
}

fn difference(a: &FilmReader, b: &FilmReader) -> Option<FilmDifference> {
    let sizes = [a, b].map(FilmReader::size);
    if sizes[0] != sizes[1] {
        let words = sizes.map(|[width, height]| format!("{width}x{height}"));
        return Some(FilmDifference { name: "size".into(), words });
    }
    a.about().difference(b.about()).or_else(|| {
        let sequences = [a, b].map(|film| film.shape().sequences().len());
        let words = sequences.map(|count| count.to_string());
        let difference = FilmDifference { name: "number of sequences".into(), words };
        (sequences[0] != sequences[1]).then_some(difference)
    })
}

/// Writes the film that others make together, with these notes and the sums of their counters.
/// It has the bytes of the film that one rendering of all their passes would have written.
///
/// # Errors
/// As [`check_films_fit`]; [`Error::ReadFilm`] or [`Error::Write`]. Then nothing is written.
///
/// # Panics
/// If there is no film.
pub fn merge_films(
    path: &Path,
    films: &mut [FilmReader],
    notes: Vec<(String, String)>,
) -> Result<(), Error> {
    let shape = check_films_fit(films)?;
    let [width, height] = films[0].size();
    let about =
        FilmAbout { settings: films[0].about().settings.clone(), notes, counters: counters(films) };
    let sequences = shape.sequences().len() as u32;
    let header = Header { width, height, about, shape, bytes: 0 };
    let pixels = width as usize * height as usize;
    // What is wrong with a film that is read is no fault of the one that is written.
    let mut fault = None;
    let written = write_file_by(path, None, &mut |out| {
        out.write_all(&header.encode())?;
        let mut writer = StripeWriter::default();
        let mut bytes = Vec::new();
        for start in (0..pixels).step_by(STRIPE) {
            let stripe = start..(start + STRIPE).min(pixels);
            let mut sum = Film::of_sequences(stripe.len() as u32, 1, sequences);
            for (number, film) in films.iter_mut().enumerate() {
                let part = film.read_stripe(&stripe, &mut bytes).map_err(|error| {
                    fault = Some(error);
                    io::ErrorKind::InvalidData
                })?;
                if number >= MOST_OPEN {
                    film.close();
                }
                sum.merge(part).map_err(io::Error::other)?;
            }
            writer.write(out, &sum, 0..stripe.len())?;
        }
        Ok(())
    });
    fault.map_or(written, Err)
}

/// The sums of counters, in the order in which they come first.
fn counters(films: &[FilmReader]) -> Vec<(String, u64)> {
    let mut sums: Vec<(String, u64)> = Vec::new();
    for (name, counter) in films.iter().flat_map(|film| &film.about().counters) {
        match sums.iter_mut().find(|(known, _)| known == name) {
            Some((_, sum)) => *sum = sum.wrapping_add(*counter),
            None => sums.push((name.clone(), *counter)),
        }
    }
    sums
}
