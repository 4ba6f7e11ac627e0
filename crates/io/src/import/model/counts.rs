//! Counts of what a file of meshes holds.

use super::{Format, ModelFile};
use crate::import::counter::Counter;
use crate::import::model_part::ModelSide;
use crate::import::placement::Placement;
use crate::load_options::LoadOptions;
use crate::source::Location;
use crate::{Error, MeshCounts, Warning};
use std::collections::BTreeSet;
use traylib_geometry::Aabb;
use traylib_materials::{Material, SurfaceModel};
use traylib_math::glam::Mat2;
use traylib_math::{Rgb, Vec2};
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
    counts.lights = file.unused_light().0;
    let mut bounds = Aabb::EMPTY;
    let used: BTreeSet<usize> = parts.iter().map(|part| part.material).collect();
    // Least u and v, and greatest.
    let mut uvs = Mat2::from_cols(Vec2::INFINITY, Vec2::NEG_INFINITY);
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
        for &uv in mesh.uvs() {
            uvs = Mat2::from_cols(uvs.x_axis.min(uv), uvs.y_axis.max(uv));
        }
        bounds = mesh.positions().iter().fold(bounds, |bounds, &point| bounds.extend(point));
    }
    let [low, high] = [bounds.min, bounds.max].map(|corner| corner.to_array());
    counts.bbox = [low[0], low[1], low[2], high[0], high[1], high[2]];
    counts.uv_box = if uvs.is_finite() { uvs.to_cols_array() } else { [0.0; 4] };
    counts.materials = used.len();
    counts.colours =
        used.into_iter().map(|number| diffuse(&file.materials[number].surface)).collect();
    Ok((counts, warnings))
}

/// The diffuse reflectance of a material; of a picture, its mean.
fn diffuse(material: &Material) -> [f32; 3] {
    let layer = material.maps.as_ref().and_then(|maps| maps.diffuse.as_ref());
    let own = match &material.model {
        SurfaceModel::Lambert(model) => model.reflectance(),
        SurfaceModel::Phong(model) => model.diffuse(),
        SurfaceModel::Mirror(model) => model.diffuse(),
        SurfaceModel::Sheet(model) => model.reflection().diffuse(),
        SurfaceModel::MaxPhong(_) | SurfaceModel::Dielectric(_) => Rgb::BLACK,
    };
    layer.map_or(own, |layer| layer.texture.mean()).to_array()
}
