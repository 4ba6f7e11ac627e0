//! The reasons why files are not a scene.

use super::Place;
use crate::Limit;
use std::path::PathBuf;

/// Files that cannot be read or make no sense.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file that the caller named cannot be read.
    #[error("{}: {fault}", .file.display())]
    File {
        /// The file.
        file: PathBuf,
        /// The fault of the file.
        fault: FileFault,
    },
    /// A known entity makes no sense or asks for too much.
    #[error("{place}: {entity}: {cause}")]
    Entity {
        /// The place.
        place: Place,
        /// Its keyword.
        entity: &'static str,
        /// The cause.
        cause: Cause,
    },
}

/// The reason why a file cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileFault {
    /// The system says no.
    #[error("cannot be read: {}", crate::source::why(.0))]
    Read(#[from] std::io::Error),
    /// A folder, a pipe or the like.
    #[error("is not a file")]
    NotAFile,
    /// All files together are too long.
    #[error("all files together have more than {0} bytes; {more}", more = Limit::Bytes.remedy(*.0))]
    TooManyBytes(u64),
    /// All that is kept takes too much memory.
    #[error("takes more memory than is left of {0} bytes; {more}", more = Limit::Memory.remedy(*.0))]
    TooMuchMemory(u64),
    /// A line is too long.
    #[error("line {line} has more than {limit} bytes; {}", Limit::Line.remedy(*.limit as u64))]
    LineTooLong {
        /// The line on which it begins.
        line: u32,
        /// The bound.
        limit: usize,
    },
}

/// The reason why an entity makes no sense.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// A name that nothing has.
    #[error("no {what} is named `{name}`")]
    Undefined {
        /// Colour, material or vertex.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// The wrong number or kind of words.
    #[error("{found} arguments where it takes {expected}")]
    Arguments {
        /// The arguments that it takes.
        expected: &'static str,
        /// The number of arguments there are.
        found: usize,
    },
    /// A word that should be a finite number.
    #[error("`{0}` is not a finite number")]
    NotANumber(String),
    /// A word that should be an integer.
    #[error("`{0}` is not an integer of 0 or more")]
    NotACount(String),
    /// A number that may not be.
    #[error("{what} is {value}, it must be {range}")]
    Range {
        /// The quantity that the number stands for.
        what: &'static str,
        /// The number.
        value: f64,
        /// The range that it may be in.
        range: &'static str,
    },
    /// Numbers that do not fit each other.
    #[error("{0}")]
    Illegal(&'static str),
    /// A word among the arguments of a transform that is no option.
    #[error("`{0}` is no option of a transform")]
    UnknownOption(String),
    /// An option without all of its numbers.
    #[error("`{0}` lacks a number")]
    OptionCut(String),
    /// An `xf` or `o` that closes nothing of the same file.
    #[error("closes nothing that this file has opened")]
    Unmatched,
    /// An absolute name of a file.
    #[error("`{0}` is an absolute name; included files are named relative to the including one")]
    Absolute(String),
    /// An included file outside of the root folder.
    #[error("`{name}` is outside of {}, which includes may not leave; `--root` names another folder", .root.display())]
    Outside {
        /// Its name.
        name: String,
        /// The folder.
        root: PathBuf,
    },
    /// A file that includes itself, directly or by others.
    #[error("`{0}` is being read already: files include each other in a circle")]
    Circle(String),
    /// An included file cannot be read.
    #[error("`{name}` {fault}")]
    Include {
        /// Its name.
        name: String,
        /// The fault of the file.
        fault: FileFault,
    },
    /// A bound is exceeded.
    #[error("more than {limit} {what}; {}", .option.remedy(*.limit))]
    Limit {
        /// The kind of thing that there is too much of.
        what: &'static str,
        /// The bound.
        limit: u64,
        /// Its name.
        option: Limit,
    },
}

/// A word for a message: as it is, or its beginning.
pub(super) fn shown(word: &str) -> String {
    const LONGEST: usize = 60;
    match word.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &word[..end]),
        None => word.to_string(),
    }
}
