//! Formats of models, and what files of each do not say.

use super::super::frame;
use super::super::imported_object::ImportedObject;
use std::path::Path;
use traylib_geometry::{Aabb, Vec3};

/// A format of files that bring shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::import) enum Format {
    /// Materials and Geometry Format.
    Mgf,
    /// 3D Studio.
    ThreeDs,
    /// Wavefront.
    Obj,
    /// Stanford's polygons.
    Ply,
    /// Khronos' format, as text or binary.
    Gltf,
    /// Mitsuba's scenes.
    Mitsuba,
}

impl Format {
    /// Returns the format that a file's name says, if it is one of these.
    pub(in crate::import) fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        Some(match ending.as_str() {
            "mgf" => Self::Mgf,
            "3ds" => Self::ThreeDs,
            "obj" => Self::Obj,
            "ply" => Self::Ply,
            "gltf" | "glb" => Self::Gltf,
            "xml" => Self::Mitsuba,
            _ => return None,
        })
    }

    /// Factor on what its materials emit where nobody says one: that of 3D Studio is no
    /// light.
    pub(in crate::import) fn usual_glow(self) -> f32 {
        match self {
            Self::Mgf | Self::Obj | Self::Ply | Self::Gltf | Self::Mitsuba => 1.0,
            Self::ThreeDs => 0.0,
        }
    }

    /// Tells whether what it emits has a unit, so that an exposure can be told from it.
    pub(in crate::import) fn is_physical(self) -> bool {
        match self {
            Self::Mgf => true,
            Self::ThreeDs | Self::Obj | Self::Ply | Self::Gltf | Self::Mitsuba => false,
        }
    }

    /// The exposure of its pictures, if what it emits is meant to be shown as it is.
    pub(in crate::import) fn exposure(self) -> Option<f32> {
        match self {
            Self::Mitsuba => Some(1.0),
            Self::Mgf | Self::ThreeDs | Self::Obj | Self::Ply | Self::Gltf => None,
        }
    }

    /// The direction that is up in a file of this format.
    pub(in crate::import) fn up(self, items: &[ImportedObject], bounds: &Aabb) -> Vec3 {
        match self {
            Self::Mgf => frame::up(items, bounds),
            Self::ThreeDs => Vec3::Z,
            Self::Obj | Self::Ply | Self::Gltf | Self::Mitsuba => Vec3::Y,
        }
    }

    /// Returns advice for a surface of one side that lets light through.
    pub(in crate::import) fn remedy(self) -> &'static str {
        match self {
            Self::Mgf => {
                "give it `sides 2`, or use the file in a scene file, its object with `sides: Both`"
            }
            Self::ThreeDs => {
                "make it 2-sided, or use the file in a scene file, its object with `sides: Both`"
            }
            Self::Gltf => {
                "make it `doubleSided`, or use the file in a scene file, its object with \
                 `sides: Both`"
            }
            Self::Mitsuba => {
                "put it into a `twosided`, or use the file in a scene file, its object with \
                 `sides: Both`"
            }
            Self::Obj | Self::Ply => "use the file in a scene file, its object with `sides: Both`",
        }
    }
}
