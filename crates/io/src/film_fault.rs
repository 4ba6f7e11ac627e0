//! Faults of film files: of one, or of two that do not fit together.

use crate::MAX_PIXELS;
use std::io;

/// The form of the file that is written, and the only one that is read.
pub(crate) const VERSION: u32 = 1;

/// A setting in which two films differ.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilmDifference {
    /// Its name.
    pub name: String,
    /// The values in both files.
    pub words: [String; 2],
}

/// The reason why a file is no film that can be used.
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
        /// The bytes that it has.
        found: u64,
        /// The bytes that its header says.
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
