//! Materials as files of shapes have them.

use traylib_geometry::Sides;
use traylib_materials::Material;
use traylib_math::Rgb;

/// A material of a file.
#[derive(Clone, Debug)]
pub(super) struct ImportedMaterial {
    /// The name in the file; may be empty, or that of others too.
    pub(super) name: String,
    pub(super) surface: Material,
    pub(super) sides: Sides,
    /// Radiance that it emits by itself. 3D Studio's has no unit.
    pub(super) emission: Rgb,
}
