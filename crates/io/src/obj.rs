//! Decoder of Wavefront's object files (`.obj`) and material libraries (`.mtl`).
//!
//! Bytes become a [`Document`]: positions, texture coordinates, normals, and polygons that
//! name them, with materials and smoothing groups by name and number. Nothing is welded, cut
//! or smoothed. The format has no unit and no axis that is up; the front of a polygon is the
//! side from which its corners turn counter-clockwise.
//!
//! Read are `v`, `vt`, `vn`, `f` (also with negative numbers, which count back from the last),
//! `g`, `o`, `s`, `usemtl` and `mtllib`, and lines that go on after a `\`. Names may be in any
//! coding. Not read, and counted in [`Document::warnings`]: colours and weights of vertices,
//! points and lines, free-form curves and surfaces, and all that is for display alone.
//!
//! Sources: *Object Files* and *MTL material format*, Alias|Wavefront, 1995, as published by
//! P. Bourke; what common writers add to them.

mod error;
mod lines;
pub mod mtl;
mod reader;
mod warning;
mod words;

pub use error::{Cause, Error};
pub use warning::WarningKind;

pub use crate::polygon_limits::{PolygonFault, PolygonLimits as Limits};

use crate::warning_counts::WarningCounts;
use traylib_math::{Vec2, Vec3};

/// The contents of an object file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// The positions of vertices.
    pub positions: Vec<Vec3>,
    /// Texture coordinates; v is 0 where the file gives u alone.
    pub uvs: Vec<Vec2>,
    /// Normals of any length; zero where the file has a number that is none.
    pub normals: Vec<Vec3>,
    /// The corners of all polygons, one after the other.
    pub corners: Vec<Corner>,
    /// The polygons in the order of the file.
    pub faces: Vec<Face>,
    /// Names of the materials that are used, each once, in the order of first use.
    pub materials: Vec<String>,
    /// The libraries that `mtllib` names, as they stand there.
    pub libraries: Vec<String>,
    /// The warnings: what was skipped or repaired.
    pub warnings: WarningCounts<WarningKind>,
}

/// A corner of a polygon, by numbers from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Its position.
    pub position: u32,
    /// Its texture coordinates.
    pub uv: Option<Index>,
    /// Its normal.
    pub normal: Option<Index>,
}

/// A number from 0 that an option keeps in four bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Index(std::num::NonZeroU32);

impl Index {
    /// The index, if it is not the largest number.
    pub(crate) fn new(index: u32) -> Option<Self> {
        std::num::NonZeroU32::new(index.wrapping_add(1)).map(Self)
    }

    /// The number from 0.
    pub fn get(self) -> u32 {
        self.0.get() - 1
    }
}

/// A polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    /// The index of its first corner among the document's.
    pub first: u32,
    /// The number of its corners, at least three.
    pub count: u32,
    /// The index of its material among the document's.
    pub material: Option<u32>,
    /// Its smoothing group; 0 is none.
    pub smoothing: u32,
}

impl Document {
    /// The corners of a face of this document.
    pub fn corners_of(&self, face: &Face) -> &[Corner] {
        &self.corners[face.first as usize..(face.first + face.count) as usize]
    }
}

/// Decodes an object file.
///
/// Memory stays within a fixed multiple of the size of `bytes`.
///
/// # Errors
/// A statement that is read makes no sense, or asks for too much: the first, with its line.
pub fn decode(bytes: &[u8], limits: Limits) -> Result<Document, Error> {
    check_text(bytes, limits)?;
    reader::read(bytes, limits)
}

/// Refuses files that are too long, and text in words of 16 bits.
fn check_text(bytes: &[u8], limits: Limits) -> Result<(), Error> {
    if bytes.len() > limits.bytes {
        return Err(Error::TooLong(limits.bytes));
    }
    let is_utf16 = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
    if is_utf16 { Err(Error::Utf16) } else { Ok(()) }
}

#[cfg(test)]
mod tests;
