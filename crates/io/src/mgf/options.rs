//! The bounds that a caller may set.

use std::path::PathBuf;

/// Bounds on what files may ask for. With the defaults the worst files that are known
/// take less than a second and 256 MiB; a tree of 365,352 cones and spheres takes
/// five sixths of each at most.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// The folder that includes may not leave, symbolic links followed; the
    /// folder of the first file, if none is given.
    pub root: Option<PathBuf>,
    /// The depth to which files may include each other; 64.
    pub max_depth: usize,
    /// The number of transforms that may be open at once; 1,024.
    pub max_transforms: usize,
    /// The number of surfaces that there may be, and of copies that open arrays may make together;
    /// 1,000,000.
    pub max_surfaces: u64,
    /// The number of vertices that one polygon may have, its holes and the seams to them included;
    /// 4,096.
    pub max_corners: usize,
    /// The squares of the polygons' numbers of vertices, summed; 3 · 2²⁴. Time to cut
    /// polygons into triangles is at most in proportion.
    pub max_cutting: u64,
    /// Length of a line in bytes, continuations included; 1 MiB.
    pub max_line: usize,
    /// Length of all different files together in bytes; 32 MiB.
    pub max_bytes: u64,
    /// Work, in bytes of text that are read, every repetition by an array or an
    /// include anew; 3 · 2²⁶. A line counts as some bytes more, and so does each of its
    /// words; what takes longer than its text says counts as what it takes.
    pub max_work: u64,
    /// Bytes kept in memory: text, names, surfaces, their vertices and materials;
    /// 160 MiB.
    pub max_memory: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            root: None,
            max_depth: 64,
            max_transforms: 1024,
            max_surfaces: 1_000_000,
            max_corners: 4096,
            max_cutting: 3 << 24,
            max_line: 1 << 20,
            max_bytes: 32 << 20,
            max_work: 3 << 26,
            max_memory: 160 << 20,
        }
    }
}
