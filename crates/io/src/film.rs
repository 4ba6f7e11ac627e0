//! Films as files: all sums of a rendering, to go on with or to merge with others.
//!
//! `docs/film-format.md` says what is in them, byte by byte. In short: a header with its own
//! checksum, then [stripes](STRIPE) of pixels, each with the sums of all blocks and a checksum.
//! So films that do not fit into memory are read, merged and written stripe by stripe.

mod header;
mod merge;
mod read;
mod sums;
#[cfg(test)]
mod tests;

pub use merge::{check_films_fit, merge_films};
pub use read::{FilmReader, load_film};

use crate::film_fault::FilmDifference;
use crate::{Error, write_file_by};
use header::Header;
use std::path::Path;
use sums::StripeWriter;
use traylib_scene::Film;

/// Pixels of a stripe, in the order of the picture; the last one may have fewer.
pub(crate) const STRIPE: usize = 1 << 14;

/// The description of a film that its file has beside the sums.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FilmAbout {
    /// The settings that its light depends on, by name. Films fit together only if all of these are
    /// the same.
    pub settings: Vec<(String, String)>,
    /// Notes that its light does not depend on, by name.
    pub notes: Vec<(String, String)>,
    /// Counters of the rendering, by name. When films are merged, these are added up.
    pub counters: Vec<(String, u64)>,
}

impl FilmAbout {
    /// The first setting that is not as in another film, with the words of both. A note of the
    /// same name stands beside it.
    pub fn difference(&self, other: &Self) -> Option<FilmDifference> {
        let names = self.settings.iter().chain(&other.settings).map(|(name, _)| name);
        let differs = |name: &&String| self.setting(name) != other.setting(name);
        let name = names.into_iter().find(differs)?;
        let words = [self, other].map(|about| about.words(name));
        Some(FilmDifference { name: name.clone(), words })
    }

    fn setting(&self, name: &str) -> Option<&str> {
        text_of(&self.settings, name)
    }

    /// A setting with the note that explains it.
    fn words(&self, name: &str) -> String {
        let note = text_of(&self.notes, name).map_or_else(String::new, |note| format!(" ({note})"));
        format!("{}{note}", self.setting(name).unwrap_or("none"))
    }
}

fn text_of<'a>(texts: &'a [(String, String)], name: &str) -> Option<&'a str> {
    texts.iter().find(|(known, _)| known == name).map(|(_, text)| text.as_str())
}

/// Writes a film, whole or not at all; the file that is replaced becomes `kept`, if given.
///
/// # Errors
/// [`Error::Write`].
pub fn save_film(
    path: &Path,
    kept: Option<&Path>,
    film: &Film,
    about: &FilmAbout,
) -> Result<(), Error> {
    write_file_by(path, kept, &mut |out| {
        out.write_all(&Header::of(film, about).encode())?;
        let mut writer = StripeWriter::default();
        let pixels = film.width() * film.height();
        (0..pixels)
            .step_by(STRIPE)
            .try_for_each(|start| writer.write(out, film, start..(start + STRIPE).min(pixels)))
    })
}
