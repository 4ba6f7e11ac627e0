//! Bounds on what files may ask for, by names that users know.

use std::fmt;

/// The most pixels a picture may have. Larger ones are taken for a slip: 2²⁸
/// pixels are 3 GiB of film.
pub const MAX_PIXELS: u64 = 1 << 28;

/// A bound that a caller may set otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Bytes of all MGF files together, of a file of any other format, and of a picture.
    Bytes,
    /// Bytes kept in memory of MGF files.
    Memory,
    /// Work on MGF files, in bytes of text, every copy anew.
    Work,
    /// Surfaces of MGF files, and copies by open arrays; triangles of glTF in all places.
    Surfaces,
    /// Vertices of one polygon.
    Corners,
    /// Squares of the numbers of vertices of polygons, summed.
    Cutting,
    /// Bytes of one line of MGF.
    Line,
    /// MGF files that include each other.
    Depth,
    /// Transforms of MGF that are open at once.
    Transforms,
    /// Meshes, lights, cameras, materials and nodes of a 3DS file, and its maps; those of each
    /// kind of a glTF file.
    Items,
    /// Pixels of one picture on surfaces; where they are more than usual for all together,
    /// of all.
    Pixels,
}

impl Limit {
    /// Every one.
    pub const ALL: [Self; 11] = [
        Self::Bytes,
        Self::Memory,
        Self::Work,
        Self::Surfaces,
        Self::Corners,
        Self::Cutting,
        Self::Line,
        Self::Depth,
        Self::Transforms,
        Self::Items,
        Self::Pixels,
    ];

    /// Its name in messages and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bytes => "bytes",
            Self::Memory => "memory",
            Self::Work => "work",
            Self::Surfaces => "surfaces",
            Self::Corners => "corners",
            Self::Cutting => "cutting",
            Self::Line => "line",
            Self::Depth => "depth",
            Self::Transforms => "transforms",
            Self::Items => "items",
            Self::Pixels => "pixels",
        }
    }

    /// The limit of this name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|limit| limit.name() == name)
    }

    /// Advises what to do where it is exceeded on purpose, `value` being its present value.
    pub(crate) fn remedy(self, value: u64) -> impl fmt::Display {
        let (name, more) = (self.name(), value.saturating_mul(2));
        fmt::from_fn(move |f| write!(f, "if that is meant, `--limit {name}={more}` allows more"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_limit_has_a_name_and_a_place() {
        for (index, limit) in Limit::ALL.into_iter().enumerate() {
            assert_eq!((Limit::of_name(limit.name()), limit as usize), (Some(limit), index));
        }
        assert_eq!(Limit::of_name("faces"), None);
    }
}
