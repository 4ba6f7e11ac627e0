//! Bounds on files of polygons.

/// How much of a file is taken in. What exceeds it is an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PolygonLimits {
    /// The most bytes of a file.
    pub bytes: usize,
    /// The most corners of a polygon.
    pub corners: usize,
    /// The most that the squares of the corners of large polygons may sum up to, which is
    /// what cutting them takes.
    pub cutting: u64,
}

impl Default for PolygonLimits {
    /// 2²⁸ bytes, 4096 corners, and 48 Mi of their squares.
    fn default() -> Self {
        Self { bytes: 1 << 28, corners: 4096, cutting: 48 << 20 }
    }
}
