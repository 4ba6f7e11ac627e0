//! Meshes, the places where they stand, lights and a camera: what OBJ, PLY and glTF come to.

use crate::import::imported_material::ImportedMaterial;
use crate::import::model_camera::ModelCamera;
use crate::import::model_part::{ModelPart, ModelSide};
use crate::import::one_sided::is_closed_mesh;
use crate::import::placement::Placement;
use traylib_geometry::{self as geometry, Mesh, Sides, Vec3};
use traylib_math::glam::{DAffine3, DMat3};
use traylib_scene::{ObjectShape, PointLight, SpotCone};

/// A mesh with one material, in its own space.
#[derive(Debug)]
pub(super) struct Piece {
    pub(super) mesh: Mesh,
    pub(super) material: usize,
}

/// A piece in one place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instance {
    pub(super) piece: usize,
    pub(super) place: DAffine3,
}

/// The contents of a file before they are placed.
#[derive(Debug, Default)]
pub(super) struct Content {
    pub(super) pieces: Vec<Piece>,
    pub(super) instances: Vec<Instance>,
    pub(super) lights: Vec<PointLight>,
    pub(super) camera: Option<ModelCamera>,
}

impl Content {
    /// Takes pieces that stand as they are.
    pub(super) fn of_pieces(pieces: Vec<Piece>) -> Self {
        let standing = |piece| Instance { piece, place: DAffine3::IDENTITY };
        let instances = (0..pieces.len()).map(standing).collect();
        Self { pieces, instances, ..Self::default() }
    }

    /// Puts every instance where it goes. What is open, has two sides and shines does so from
    /// both: formats without a word on sides do not say which one is the front.
    pub(super) fn parts(
        &self,
        materials: &[ImportedMaterial],
        placement: &Placement,
    ) -> Result<Vec<ModelPart>, geometry::Error> {
        let mut parts = Vec::with_capacity(self.instances.len());
        for instance in &self.instances {
            let Piece { mesh, material } = &self.pieces[instance.piece];
            let material = *material;
            let mesh = placed(mesh, &instance.place, placement)?;
            let ImportedMaterial { sides, emission, .. } = &materials[material];
            let shines_twice = *sides == Sides::Both && !emission.is_black();
            if shines_twice && !is_closed_mesh(&mesh) {
                let back = ObjectShape::Mesh(turned(&mesh)?);
                parts.push(ModelPart { shape: back, material, side: ModelSide::Back });
                let front = ObjectShape::Mesh(mesh);
                parts.push(ModelPart { shape: front, material, side: ModelSide::Front });
            } else {
                let shape = ObjectShape::Mesh(mesh);
                parts.push(ModelPart { shape, material, side: ModelSide::Whole });
            }
        }
        Ok(parts)
    }

    /// Lets go of its shapes.
    pub(super) fn forget_shapes(&mut self) {
        (self.pieces, self.instances) = (Vec::new(), Vec::new());
    }

    /// Puts its lights where they go; in W/sr they are as strong at any scale.
    pub(super) fn lights(&self, placement: &Placement) -> Vec<PointLight> {
        let placed = |light: &PointLight| {
            let position = placement.point(light.position);
            let cone =
                light.cone.map(|cone| SpotCone { axis: placement.direction(cone.axis), ..cone });
            PointLight { position, cone, ..*light }
        };
        self.lights.iter().map(placed).collect()
    }
}

/// Puts a mesh at a place of its file, and that where the file goes.
fn placed(mesh: &Mesh, place: &DAffine3, placement: &Placement) -> Result<Mesh, geometry::Error> {
    let point = |p: &Vec3| placement.wide_point(place.transform_point3(p.as_dvec3())).as_vec3();
    let positions = mesh.positions().iter().map(point).collect();
    let is_mirrored = place.matrix3.determinant() < 0.0;
    let corners = |&[a, b, c]: &[u32; 3]| if is_mirrored { [a, c, b] } else { [a, b, c] };
    let triangles = mesh.triangles().iter().map(corners).collect();
    let across = across(&place.matrix3);
    let normal = |n: &Vec3| placement.wide_direction(across * n.as_dvec3()).as_vec3();
    with_attributes(
        Mesh::new(positions, triangles)?,
        mesh.normals().iter().map(normal).collect(),
        mesh.uvs().to_vec(),
    )
}

/// Returns what turns normals with a surface: the cofactors, which are the inverse transposed but
/// for a positive factor, and exist where that does not.
pub(super) fn across(matrix: &DMat3) -> DMat3 {
    let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    let sign = if matrix.determinant() < 0.0 { -1.0 } else { 1.0 };
    DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y)) * sign
}

/// Turns a surface, so that it is seen from behind.
fn turned(mesh: &Mesh) -> Result<Mesh, geometry::Error> {
    let triangles = mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]).collect();
    with_attributes(
        Mesh::new(mesh.positions().to_vec(), triangles)?,
        mesh.normals().iter().map(|&normal| -normal).collect(),
        mesh.uvs().to_vec(),
    )
}

/// Gives a mesh normals and texture coordinates where there are any.
pub(super) fn with_attributes(
    mesh: Mesh,
    normals: Vec<Vec3>,
    uvs: Vec<geometry::Vec2>,
) -> Result<Mesh, geometry::Error> {
    let mesh = if normals.is_empty() { mesh } else { mesh.with_normals(normals)? };
    if uvs.is_empty() { Ok(mesh) } else { mesh.with_uvs(uvs) }
}
