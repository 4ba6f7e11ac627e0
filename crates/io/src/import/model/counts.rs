//! Counts of what a file of meshes holds.

use super::{Format, ModelFile};
use crate::import::counter::Counter;
use crate::import::model_part::ModelSide;
use crate::import::placement::Placement;
use crate::load_options::LoadOptions;
use crate::source::Location;
use crate::{Error, MeshCounts, Warning};
use traylib_geometry::Aabb;
use traylib_scene::ObjectShape;

/// Tells whether [`of`] counts files of this name: those that come to meshes.
pub(in crate::import) fn is_counted(path: &std::path::Path) -> bool {
    match Format::of(path) {
        Some(Format::Obj | Format::Ply | Format::Gltf) => true,
        Some(Format::Mgf | Format::ThreeDs | Format::Mitsuba) | None => false,
    }
}

/// Reads a file and counts what is in it, every place of a mesh anew; with what there is to
/// warn of.
pub(in crate::import) fn of(
    location: &Location,
    options: LoadOptions<'_>,
) -> Result<(MeshCounts, Vec<Warning>), Error> {
    let (file, warnings) = ModelFile::read(location, options)?;
    let failed = |cause: traylib_geometry::Error| Error::Model {
        file: location.to_string(),
        cause: cause.into(),
    };
    let parts = file.parts(&Placement::NONE, &mut Counter::default()).map_err(failed)?;
    let mut counts =
        MeshCounts { cameras: usize::from(file.camera().is_some()), ..MeshCounts::default() };
    counts.materials = file.materials.len();
    counts.lights = file.unused_light().0;
    let mut bounds = Aabb::EMPTY;
    // The back of a lamp is its front once more.
    for part in parts.iter().filter(|part| part.side != ModelSide::Back) {
        let ObjectShape::Mesh(mesh) = &part.shape else { continue };
        counts.meshes += 1;
        counts.triangles += mesh.triangle_count();
        counts.vertices += mesh.positions().len();
        counts.normals += mesh.normals().len();
        counts.texcoords += mesh.uvs().len();
        let triangles = (0..mesh.triangle_count()).filter_map(|index| mesh.triangle(index));
        counts.area += triangles.map(|triangle| f64::from(triangle.area())).sum::<f64>();
        bounds = mesh.positions().iter().fold(bounds, |bounds, &point| bounds.extend(point));
    }
    let [low, high] = [bounds.min, bounds.max].map(|corner| corner.to_array());
    counts.bbox = [low[0], low[1], low[2], high[0], high[1], high[2]];
    Ok((counts, warnings))
}
