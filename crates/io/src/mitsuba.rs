//! Decoder of Mitsuba's scene files (`.xml`), of versions 3 and 2 as well as 0.6 and 0.5.
//!
//! Text becomes a [`Document`]: the objects of the scene, each with its type, its properties and
//! the objects within it. Nothing is known here of what types there are and what they mean.
//! Files that `include` names are read, `default` and `$name` are put in, `ref` and `alias`
//! lead to the objects that they name, and transforms come to one matrix. Names of properties
//! are those of version 3: `toWorld` and `intIOR` of older files become `to_world` and `int_ior`.
//!
//! XML is read by `roxmltree`: it checks that a file is well formed before anything is made of
//! it, knows where each element stands, expands no entities and needs nothing but itself.
//! A file with a document type is refused.
//!
//! Read are `scene`; `shape`, `bsdf`, `emitter`, `sensor`, `film`, `texture` and the other
//! classes; `float`, `integer`, `boolean`, `string`, `point`, `vector`, `rgb`, `srgb`, `spectrum`,
//! `transform` with `translate`, `scale`, `rotate`, `matrix` and `lookat`; `default`, `include`,
//! `ref`, `alias`. Not read, and counted in [`Document::warnings`]: all else.
//!
//! Source: *Mitsuba 3 documentation*, Scene XML file format, W. Jakob et al., 2022 to 2026;
//! what version 3.9.1 does; *Mitsuba documentation*, version 0.5, 2014, for older files.

mod bounds;
mod document;
mod error;
mod lines;
mod names;
mod parameters;
mod reader;
mod transform;
mod values;
mod warning;

pub use document::{Child, Class, Document, Object, Place, Property, Value};
pub use error::{Error, Fault};
pub use warning::WarningKind;

/// Bounds on what files may ask for. What exceeds one is an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The most bytes of all files together, each anew whenever it is included.
    pub bytes: usize,
    /// The most elements of all files together.
    pub elements: usize,
    /// The most files that include each other.
    pub depth: usize,
    /// The most triangles of all meshes together, in every place anew.
    pub triangles: u64,
}

impl Default for Limits {
    /// 2²⁵ bytes, 2¹⁸ elements, 16 files, 2²⁴ triangles.
    fn default() -> Self {
        Self { bytes: 1 << 25, elements: 1 << 18, depth: 16, triangles: 1 << 24 }
    }
}

/// An included file: a name that is the same for each way to write it, and its bytes.
#[derive(Clone, Debug)]
pub struct Included {
    /// The name.
    pub name: String,
    /// All of it.
    pub bytes: Vec<u8>,
}

/// Decodes a file, which messages call `name`, with those that it includes: `load` finds them by
/// the names that stand there, or says why it does not.
///
/// Memory stays within a fixed multiple of the size of the files.
///
/// # Errors
/// The first fault, with its file, line and column.
pub fn decode(
    name: &str,
    bytes: &[u8],
    limits: Limits,
    load: &mut dyn FnMut(&str) -> Result<Included, String>,
) -> Result<Document, Error> {
    reader::read(name, bytes, limits, load)
}

#[cfg(test)]
mod tests;
