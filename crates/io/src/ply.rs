//! Decoder of polygon files (`.ply`), also called Stanford's: as text, and as bytes of either
//! order.
//!
//! Bytes become a [`Document`]: positions, normals, texture coordinates and polygons. Strips
//! of triangles become triangles. The format has no unit and no axis that is up; the front of a
//! polygon is the side from which its corners turn counter-clockwise.
//!
//! Properties go by the names that are in use: `x y z`; `nx ny nz`; `s t`, `u v` or
//! `texture_u texture_v`; `vertex_indices` or `vertex_index`; of faces also `texcoord`, and a
//! comment `TextureFile`, as MeshLab writes them. Text is taken word by word, whatever lines
//! they stand in. All else is skipped, and counted in [`Document::warnings`].
//!
//! Sources: G. Turk, *The PLY Polygon File Format*, 1994; what common writers add to it.

mod body;
mod declaration;
mod element;
mod error;
mod header;
mod kind;
mod warning;

pub use error::{Cause, Error, Place};
pub use warning::WarningKind;

pub use crate::polygon_limits::{PolygonFault, PolygonLimits as Limits};

use crate::warning_counts::WarningCounts;
use traylib_math::{Vec2, Vec3};

/// The contents of a polygon file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// The positions of vertices.
    pub positions: Vec<Vec3>,
    /// Normals of any length, one for each position or none at all; zero where the file has a
    /// number that is none.
    pub normals: Vec<Vec3>,
    /// Texture coordinates, one for each position or none at all.
    pub uvs: Vec<Vec2>,
    /// The corners of all polygons, one after the other, as numbers of positions.
    pub corners: Vec<u32>,
    /// Texture coordinates of the corners, one for each or none at all. They go before those
    /// of vertices.
    pub corner_uvs: Vec<Vec2>,
    /// The number of corners of each polygon, at least three.
    pub counts: Vec<u32>,
    /// Pictures that comments name.
    pub textures: Vec<String>,
    /// The warnings: what was skipped or repaired.
    pub warnings: WarningCounts<WarningKind>,
}

impl Document {
    /// Every polygon: where its corners begin, and the corners.
    pub fn faces(&self) -> impl Iterator<Item = (usize, &[u32])> {
        let mut next = 0;
        self.counts.iter().map(move |&count| {
            let first = next;
            next += count as usize;
            (first, &self.corners[first..next])
        })
    }
}

/// Decodes a polygon file.
///
/// Memory stays within a fixed multiple of the size of `bytes`.
///
/// # Errors
/// The bytes are no polygon file, or what is read of one makes no sense or asks for too much:
/// the first such fault, with its place.
pub fn decode(bytes: &[u8], limits: Limits) -> Result<Document, Error> {
    if bytes.len() > limits.bytes {
        return Err(Error::TooLong(limits.bytes));
    }
    let (header, body) = header::read(bytes)?;
    element::read(header, body, limits)
}

#[cfg(test)]
mod tests;
