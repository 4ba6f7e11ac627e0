//! Shapes cut into triangles, a mesh for each material.

use super::narrow;
use crate::import::model_part::{ModelPart, ModelSide};
use crate::mgf::tessellate::{self, DEFAULT_DIVISIONS};
use crate::mgf::{Shape, Vertex};
use std::collections::{BTreeMap, HashMap};
use traylib_geometry::{self as geometry, Mesh};
use traylib_math::Vec3;
use traylib_scene::ObjectShape;

/// Parts of a quarter circle, for shapes that are not rendered as they are: a torus
/// has 40 × 40 quads. Corners lie on the shape and have its normals.
const DIVISIONS: u32 = 2 * DEFAULT_DIVISIONS;

/// The properties by which triangles are kept together: material, side, and whether they have
/// normals.
type Key = (usize, ModelSide, bool);

#[derive(Default)]
pub(super) struct MeshBuilders {
    meshes: BTreeMap<Key, Builder>,
}

impl MeshBuilders {
    pub(super) fn add(&mut self, shape: &Shape, material: usize, side: ModelSide) {
        for corners in tessellate::triangles(shape, DIVISIONS) {
            let smooth = corners[0].normal.is_some();
            self.meshes.entry((material, side, smooth)).or_default().add(&corners);
        }
    }

    pub(super) fn finish(self, parts: &mut Vec<ModelPart>) -> Result<(), geometry::Error> {
        for ((material, side, _), builder) in self.meshes {
            let shape = ObjectShape::Mesh(builder.finish()?);
            parts.push(ModelPart { shape, material, side });
        }
        Ok(())
    }
}

/// A mesh whose corners are shared where they agree.
#[derive(Default)]
struct Builder {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    numbers: HashMap<[u32; 6], u32>,
}

impl Builder {
    fn add(&mut self, corners: &[Vertex; 3]) {
        let triangle = corners.map(|corner| self.corner(&corner));
        self.triangles.push(triangle);
    }

    fn corner(&mut self, vertex: &Vertex) -> u32 {
        let position = narrow(vertex.position);
        let normal = vertex.normal.map(narrow);
        let [x, y, z] = position.to_array().map(f32::to_bits);
        let [u, v, w] = normal.unwrap_or_default().to_array().map(f32::to_bits);
        *self.numbers.entry([x, y, z, u, v, w]).or_insert_with(|| {
            self.positions.push(position);
            self.normals.extend(normal);
            self.positions.len() as u32 - 1
        })
    }

    fn finish(self) -> Result<Mesh, geometry::Error> {
        let mesh = Mesh::new(self.positions, self.triangles)?;
        if self.normals.is_empty() { Ok(mesh) } else { mesh.with_normals(self.normals) }
    }
}
