//! Faces into meshes.

use crate::import::placement::Placement;
use crate::three_ds;
use std::collections::HashMap;
use traylib_geometry as geometry;
use traylib_math::Vec3;

/// Collects the vertices of some faces. A vertex with several normals becomes
/// several.
pub(super) struct Welder<'a> {
    mesh: &'a three_ds::Mesh,
    corner_normals: Option<&'a [[Vec3; 3]]>,
    placement: &'a Placement,
    numbers: HashMap<(u16, Option<[u32; 3]>), u32>,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    uvs: Vec<geometry::Vec2>,
}

impl<'a> Welder<'a> {
    pub(super) fn new(
        mesh: &'a three_ds::Mesh,
        corner_normals: Option<&'a [[Vec3; 3]]>,
        placement: &'a Placement,
    ) -> Self {
        Self {
            mesh,
            corner_normals,
            placement,
            numbers: HashMap::new(),
            positions: Vec::new(),
            normals: Vec::new(),
            uvs: Vec::new(),
        }
    }

    pub(super) fn triangle(&mut self, face: usize) -> [u32; 3] {
        let corners = self.mesh.faces[face].corners;
        let normals = self.corner_normals.map(|normals| normals[face]);
        [0, 1, 2].map(|place| self.vertex(corners[place], normals.map(|n| n[place])))
    }

    fn vertex(&mut self, vertex: u16, normal: Option<Vec3>) -> u32 {
        let key = (vertex, normal.map(|n| n.to_array().map(f32::to_bits)));
        if let Some(&number) = self.numbers.get(&key) {
            return number;
        }
        let number = self.positions.len() as u32;
        let index = usize::from(vertex);
        self.positions.push(self.placement.point(self.mesh.vertices[index]));
        self.normals.extend(normal.map(|n| self.placement.direction(n)));
        self.uvs.extend(self.mesh.uvs.get(index));
        self.numbers.insert(key, number);
        number
    }

    pub(super) fn finish(
        self,
        triangles: Vec<[u32; 3]>,
    ) -> Result<geometry::Mesh, geometry::Error> {
        let mut mesh = geometry::Mesh::new(self.positions, triangles)?;
        if !self.normals.is_empty() {
            mesh = mesh.with_normals(self.normals)?;
        }
        if !self.uvs.is_empty() {
            mesh = mesh.with_uvs(self.uvs)?;
        }
        Ok(mesh)
    }
}
