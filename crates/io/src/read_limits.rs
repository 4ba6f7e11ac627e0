//! Bounds that a caller has set, as each reader takes them.

use crate::polygon_limits::PolygonLimits;
use crate::{Limit, TextureLimits, gltf, mgf, mitsuba, three_ds};
use std::path::{Path, PathBuf};

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

    /// Bounds on OBJ and PLY files.
    pub(crate) fn polygons(&self) -> PolygonLimits {
        let usual = PolygonLimits::default();
        PolygonLimits {
            bytes: self.count(Limit::Bytes, usual.bytes),
            corners: self.count(Limit::Corners, usual.corners),
            cutting: self.get(Limit::Cutting).unwrap_or(usual.cutting),
        }
    }

    pub(crate) fn gltf(&self) -> gltf::Limits {
        let usual = gltf::Limits::default();
        gltf::Limits {
            bytes: self.count(Limit::Bytes, usual.bytes),
            triangles: self.get(Limit::Surfaces).unwrap_or(usual.triangles),
            items: self.count(Limit::Items, usual.items),
        }
    }

    pub(crate) fn mitsuba(&self) -> mitsuba::Limits {
        let usual = mitsuba::Limits::default();
        mitsuba::Limits {
            bytes: self.count(Limit::Bytes, usual.bytes),
            elements: self.count(Limit::Items, usual.elements),
            depth: self.count(Limit::Depth, usual.depth),
            triangles: self.get(Limit::Surfaces).unwrap_or(usual.triangles),
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

    /// Each changes something, and nothing else does.
    #[test]
    fn what_is_set_is_used() {
        let used = |limits: ReadLimits| {
            let meshes =
                format!("{:?}{:?}{:?}", limits.three_ds(), limits.polygons(), limits.mitsuba());
            format!("{:?}{meshes}{:?}{:?}", limits.mgf(None), limits.gltf(), limits.texture())
        };
        let usual = used(ReadLimits::default());
        for limit in Limit::ALL {
            let mut limits = ReadLimits::default();
            limits.set(limit, 12_345);
            let times = match limit {
                Limit::Bytes => 6,
                Limit::Surfaces | Limit::Items => 3,
                Limit::Corners | Limit::Cutting | Limit::Depth => 2,
                Limit::Memory | Limit::Work | Limit::Line | Limit::Transforms | Limit::Pixels => 1,
            };
            assert_eq!(used(limits).matches("12345").count(), times, "{limit:?}");
            assert!(!usual.contains("12345"));
        }
    }
}
