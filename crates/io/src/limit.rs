//! Bounds on what files may ask for, by names that users know.

use crate::{TextureLimits, mgf, three_ds};
use std::fmt;
use std::path::{Path, PathBuf};

/// A bound that a caller may set otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Bytes of all MGF files together, of a 3DS file, and of a picture.
    Bytes,
    /// Bytes kept in memory of MGF files.
    Memory,
    /// Work on MGF files, in bytes of text, every copy anew.
    Work,
    /// Surfaces of MGF files, and copies by open arrays.
    Surfaces,
    /// Vertices of one polygon of MGF.
    Corners,
    /// Squares of the numbers of vertices of MGF polygons, summed.
    Cutting,
    /// Bytes of one line of MGF.
    Line,
    /// MGF files that include each other.
    Depth,
    /// Transforms of MGF that are open at once.
    Transforms,
    /// Meshes, lights, cameras, materials and nodes of a 3DS file, and its maps.
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

    /// What to do where it is exceeded on purpose, `value` being what it is.
    pub(crate) fn remedy(self, value: u64) -> impl fmt::Display {
        let (name, more) = (self.name(), value.saturating_mul(2));
        fmt::from_fn(move |f| write!(f, "if that is meant, `--limit {name}={more}` allows more"))
    }
}

/// The bounds that a caller has set; the readers' own else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ReadLimits([Option<u64>; Limit::ALL.len()]);

impl ReadLimits {
    /// Sets a bound.
    pub fn set(&mut self, limit: Limit, value: u64) {
        self.0[limit as usize] = Some(value);
    }

    fn get(&self, limit: Limit) -> Option<u64> {
        self.0[limit as usize]
    }

    fn count(&self, limit: Limit, usual: usize) -> usize {
        self.get(limit).map_or(usual, |value| usize::try_from(value).unwrap_or(usize::MAX))
    }

    /// For MGF files that may include from the folder `root`.
    pub(crate) fn mgf(&self, root: Option<&Path>) -> mgf::Options {
        let usual = mgf::Options::default();
        let bound = |limit, usual| self.get(limit).unwrap_or(usual);
        mgf::Options {
            root: root.map(PathBuf::from),
            max_depth: self.count(Limit::Depth, usual.max_depth),
            max_transforms: self.count(Limit::Transforms, usual.max_transforms),
            max_surfaces: bound(Limit::Surfaces, usual.max_surfaces),
            max_corners: self.count(Limit::Corners, usual.max_corners),
            max_cutting: bound(Limit::Cutting, usual.max_cutting),
            max_line: self.count(Limit::Line, usual.max_line),
            max_bytes: bound(Limit::Bytes, usual.max_bytes),
            max_work: bound(Limit::Work, usual.max_work),
            max_memory: bound(Limit::Memory, usual.max_memory),
        }
    }

    pub(crate) fn three_ds(&self) -> three_ds::Limits {
        let usual = three_ds::Limits::default();
        three_ds::Limits {
            items: self.count(Limit::Items, usual.items),
            bytes: self.count(Limit::Bytes, usual.bytes),
        }
    }

    pub(crate) fn texture(&self) -> TextureLimits {
        let usual = TextureLimits::default();
        TextureLimits {
            pixels: self.get(Limit::Pixels).unwrap_or(usual.pixels),
            file_bytes: self.get(Limit::Bytes).unwrap_or(usual.file_bytes),
        }
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

    /// Each changes something, and nothing else does.
    #[test]
    fn what_is_set_is_used() {
        let used = |limits: ReadLimits| {
            format!("{:?}{:?}{:?}", limits.mgf(None), limits.three_ds(), limits.texture())
        };
        let usual = used(ReadLimits::default());
        for limit in Limit::ALL {
            let mut limits = ReadLimits::default();
            limits.set(limit, 12_345);
            let times = if limit == Limit::Bytes { 3 } else { 1 };
            assert_eq!(used(limits).matches("12345").count(), times, "{limit:?}");
            assert!(!usual.contains("12345"));
        }
    }
}
