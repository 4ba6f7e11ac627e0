//! Shapes and materials of MGF files.

mod material;
mod place;
mod triangles;

use super::{Content, Format, ModelFile};
use crate::import::counter::Counter;
use crate::import::imported_material::ImportedMaterial;
use crate::import::model_part::{ModelPart, ModelSide};
use crate::import::placement::Placement;
use crate::load_options::LoadOptions;
use crate::mgf::{self, Shape, Surface};
use crate::{Error, Warning};
use std::path::Path;
use traylib_geometry::{self as geometry, Cone, Disk, Facing, Primitive, Sides, Sphere};
use traylib_math::Vec3;
use traylib_math::glam::DVec3;
use traylib_scene::ObjectShape;
use triangles::MeshBuilders;

pub(super) fn read(
    path: &Path,
    options: LoadOptions<'_>,
    counter: &mut Counter,
) -> Result<(ModelFile, Vec<Warning>), Error> {
    let bounds = options.limits.mgf(options.root);
    let document = mgf::decode(&[path.to_path_buf()], &bounds)?;
    let material = |material| material::imported(material, counter);
    let materials = document.materials.iter().map(material).collect::<Result<_, _>>();
    let materials =
        materials.map_err(|cause| Error::Material { file: path.display().to_string(), cause })?;
    let warnings = document.warnings.iter().map(Warning::from).collect();
    let content = Content::Mgf(document.surfaces);
    Ok((ModelFile { materials, format: Format::Mgf, content }, warnings))
}

/// Round shapes one by one, then for each material what is flat.
pub(super) fn parts(
    surfaces: &[Surface],
    materials: &[ImportedMaterial],
    placement: &Placement,
    counter: &mut Counter,
) -> Result<Vec<ModelPart>, geometry::Error> {
    let mut parts = Vec::new();
    let mut triangles = MeshBuilders::default();
    for surface in surfaces {
        let material = surface.material;
        let shape = place::placed(&surface.shape, placement);
        for &side in sides(&shape, &materials[material]) {
            let turned = (side == ModelSide::Back).then(|| place::turned(&shape));
            let shape = turned.as_ref().unwrap_or(&shape);
            match primitive(shape) {
                Some(Ok(primitive)) => {
                    let shape = ObjectShape::Primitive(primitive);
                    parts.push(ModelPart { shape, material, side });
                }
                Some(Err(_)) => counter.add("surface dropped: single precision cannot hold it"),
                None => triangles.add(shape, material, side),
            }
        }
    }
    triangles.finish(&mut parts)?;
    Ok(parts)
}

/// Both sides of a lamp emit if both are there to be seen.
fn sides(shape: &Shape, material: &ImportedMaterial) -> &'static [ModelSide] {
    let closed = matches!(shape, Shape::Sphere { .. } | Shape::Torus { .. } | Shape::Prism { .. });
    if closed || material.emission.is_black() || material.sides == Sides::Front {
        &[ModelSide::Whole]
    } else {
        &[ModelSide::Front, ModelSide::Back]
    }
}

/// The exact shape; `None` for those that are cut into triangles.
fn primitive(shape: &Shape) -> Option<Result<Primitive, geometry::Error>> {
    Some(match *shape {
        Shape::Sphere { centre, radius, inward } => {
            Sphere::new(narrow(centre), radius as f32, facing(inward)).map(Primitive::Sphere)
        }
        Shape::Cylinder { ends, radius, inward } => cone(ends, [radius; 2], inward),
        Shape::Cone { ends, radii, inward } => cone(ends, radii, inward),
        Shape::Ring { centre, normal, radii: [inner, outer] } => {
            let [inner, outer] = [inner, outer].map(|radius| radius as f32);
            Disk::ring(narrow(centre), narrow(normal), inner, outer).map(Primitive::Disk)
        }
        Shape::Torus { .. } | Shape::Face { .. } | Shape::Prism { .. } => return None,
    })
}

fn cone(ends: [DVec3; 2], radii: [f64; 2], inward: bool) -> Result<Primitive, geometry::Error> {
    let radii = radii.map(|radius| radius as f32);
    Cone::new(ends.map(narrow), radii, facing(inward)).map(Primitive::Cone)
}

fn facing(inward: bool) -> Facing {
    if inward { Facing::Inward } else { Facing::Outward }
}

fn narrow(v: DVec3) -> Vec3 {
    v.as_vec3()
}
