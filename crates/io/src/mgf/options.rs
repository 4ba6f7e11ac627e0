//! What a caller may bound.

use std::path::PathBuf;

/// Bounds on what files may ask for. The defaults suit any scene that fits a
/// desktop's memory: a tree of 365,352 cones and spheres takes a tenth of each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// The folder that includes may not leave, symbolic links followed; the
    /// folder of the first file, if none is given.
    pub root: Option<PathBuf>,
    /// How deep files may include each other; 64.
    pub max_depth: usize,
    /// How many transforms may be open at once; 1,024.
    pub max_transforms: usize,
    /// How many surfaces there may be, and how many copies open arrays may make
    /// together; 4,000,000.
    pub max_surfaces: u64,
    /// How many vertices all polygons and prisms may have together; 16,000,000.
    pub max_vertices: u64,
    /// How many vertices one polygon may have; 4,096. Cutting it into triangles
    /// takes time with their square.
    pub max_corners: usize,
    /// Length of a line in bytes, continuations included; 1 MiB.
    pub max_line: usize,
    /// Length of all different files together in bytes; 256 MiB.
    pub max_bytes: u64,
    /// Bytes of text that are read, counting every repetition by an array or an
    /// include anew; 512 MiB. Work beside reading counts as some bytes.
    pub max_text: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            root: None,
            max_depth: 64,
            max_transforms: 1024,
            max_surfaces: 4_000_000,
            max_vertices: 16_000_000,
            max_corners: 4096,
            max_line: 1 << 20,
            max_bytes: 256 << 20,
            max_text: 512 << 20,
        }
    }
}
