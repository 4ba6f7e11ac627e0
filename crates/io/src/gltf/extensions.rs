//! Extensions of the format, by their names.

use super::json::Root;
use super::{Error, WarningKind};
use crate::suggest::shown;
use crate::warning_counts::WarningCounts;

/// Extensions that are read.
const READ: [&str; 6] = [
    "EXT_mesh_gpu_instancing",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_unlit",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
];

/// The prefixes of extensions without which a file can be shown all the same.
const OF_SURFACES: [&str; 5] =
    ["KHR_materials_", "KHR_technique", "KHR_texture_", "EXT_texture_", "MSFT_texture_"];

/// Refuses a file that needs an extension without which shapes are not known, and warns of those
/// that are not read.
pub(super) fn check(root: &Root, warnings: &mut WarningCounts<WarningKind>) -> Result<(), Error> {
    let is_known = |name: &str| READ.contains(&name);
    let is_of_surfaces = |name: &str| OF_SURFACES.iter().any(|prefix| name.starts_with(prefix));
    let needed = |name: &&String| !is_known(name) && !is_of_surfaces(name);
    if let Some(name) = root.extensions_required.iter().find(needed) {
        return Err(Error::Extension(shown(name)));
    }
    for name in root.extensions_used.iter().filter(|name| !is_known(name)) {
        warnings.add(WarningKind::Extension(shown(name)));
    }
    Ok(())
}
