//! Decoder of the Materials and Geometry Format (`.mgf`, version 2).
//!
//! Files become a [`Document`]: surfaces with exact shapes, after all includes,
//! arrays and transforms, and the materials that they use. MGF is right-handed,
//! in metres and photometric: emission is in lm/m². Positions are kept in double
//! precision and fit single precision too; numbers of materials are single.
//!
//! Not read: luminaire data (`ies`) and the names of objects. What is skipped or
//! repaired is told in [`Warnings`]; a known entity that makes no sense is an
//! [`Error`] with file and line.
//!
//! Includes may not leave a root folder, and [`Options`] bounds whatever a short
//! file could blow up: depths, copies, text, memory.
//!
//! ```
//! # let folder = std::env::temp_dir().join(format!("traylib-mgf-{}", std::process::id()));
//! # std::fs::create_dir_all(&folder)?;
//! # let file = folder.join("ball.mgf");
//! std::fs::write(&file, "v centre =\n\tp 0 0 1\nsph centre 0.5\n")?;
//! let document = traylib_io::mgf::decode(&[file], &traylib_io::mgf::Options::default())?;
//! assert_eq!(document.surfaces.len(), 1);
//! # std::fs::remove_dir_all(folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Source: Ward's description of the format, 1995 to 1997.

mod array;
mod budget;
mod build;
mod colour;
mod contexts;
mod counts;
mod error;
mod files;
mod frames;
mod keyword;
mod material;
mod material_builder;
mod material_table;
mod names;
mod observer;
mod options;
mod place;
mod reader;
mod shape;
mod source;
pub mod tessellate;
mod transform;
mod warning;
mod words;

pub use counts::Counts;
pub use error::{Cause, Error, FileFault};
pub use material::{Material, Part};
pub use options::Options;
pub use place::Place;
pub use shape::{Shape, Vertex};
pub use warning::{Warning, WarningKind, Warnings};

use reader::Reader;
use std::path::PathBuf;

/// The contents of an MGF file and of those that it includes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// Every surface, in the order of the text with its copies.
    pub surfaces: Vec<Surface>,
    /// The materials of the surfaces, in the order of their first use. A name
    /// that is given to several materials in turn is here several times.
    pub materials: Vec<Material>,
    /// The warnings: what was skipped or repaired.
    pub warnings: Warnings,
    /// Counts of everything that was read.
    pub counts: Counts,
}

/// A shape with its material.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// The shape, in world space.
    pub shape: Shape,
    /// Index into the document's materials.
    pub material: usize,
}

/// Reads these files one after the other in one context.
///
/// # Errors
/// If a file cannot be read, an entity makes no sense, or a bound is exceeded.
pub fn decode(files: &[PathBuf], options: &Options) -> Result<Document, Error> {
    let mut reader = Reader::new(options, files)?;
    for file in files {
        reader.read(file)?;
    }
    Ok(reader.finish())
}

#[cfg(test)]
mod tests;
