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

use crate::{Error, MAX_PIXELS, write_file_by};
use header::{Header, VERSION};
use std::io;
use std::path::Path;
use sums::StripeWriter;
use traylib_scene::Film;

/// Pixels of a stripe, in the order of the picture; the last one may have fewer.
pub(crate) const STRIPE: usize = 1 << 14;

/// What a film says of itself beside its sums.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FilmAbout {
    /// What its light depends on, by name. Films fit together only if all of these are the same.
    pub settings: Vec<(String, String)>,
    /// What else is worth knowing, by name.
    pub notes: Vec<(String, String)>,
    /// What was counted, by name. When films are merged, these are added up.
    pub tallies: Vec<(String, u64)>,
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

/// A setting in which two films differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilmDifference {
    /// Its name.
    pub name: String,
    /// What it is in both.
    pub words: [String; 2],
}

/// Why a file is no film that can be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FilmFault {
    /// The system's reason.
    #[error("{}", crate::source::why(.0))]
    Read(#[from] io::Error),
    /// It begins otherwise.
    #[error("it is no film")]
    Foreign,
    /// It has a form that was not known when this was written.
    #[error("its format has version {0}, and this program knows version {VERSION}")]
    Version(u32),
    /// It is shorter or longer than its header says.
    #[error("it has {found} bytes instead of {wanted}")]
    Length {
        /// How long it is.
        found: u64,
        /// How long it should be.
        wanted: u64,
    },
    /// The checksum of the header is wrong, or what it says makes no sense.
    #[error("its header is damaged")]
    Header,
    /// The checksum of some pixels is wrong.
    #[error("it is damaged from pixel {0} on")]
    Pixels(u64),
    /// It needs more memory than it is worth.
    #[error("it has {0} pixels, more than the {MAX_PIXELS} that pictures may have")]
    TooLarge(u64),
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
