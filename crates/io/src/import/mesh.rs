//! Meshes from 3DS files.

mod skipped;

use super::placement::Placement;
use crate::Warning;
use crate::source::Location;
use crate::three_ds::{self, smoothing::corner_normals};
use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;
use traylib_geometry::{self as geometry, Sides};
use traylib_materials::{self as materials, Lambert, Phong, SurfaceModel};
use traylib_math::{Rgb, Vec3};

/// The files read so far: each is read, and warned about, once.
#[derive(Default)]
pub(super) struct MeshFiles {
    files: Vec<(Location, Rc<MeshFile>)>,
    warnings: Vec<Warning>,
}

impl MeshFiles {
    /// A file; why it cannot be used, else.
    pub(super) fn load(&mut self, location: &Location) -> Result<Rc<MeshFile>, String> {
        if let Some((_, file)) = self.files.iter().find(|(known, _)| known == location) {
            return Ok(Rc::clone(file));
        }
        let describe = |cause: String| format!("{location} cannot be used: {cause}");
        let bytes = location.read().map_err(|e| describe(e.to_string()))?;
        let document = three_ds::decode(&bytes).map_err(|e| describe(e.to_string()))?;
        if document.meshes.iter().all(|mesh| mesh.faces.is_empty()) {
            return Err(describe("it has no mesh with a face that can be drawn".to_string()));
        }
        let (file, warnings) = MeshFile::new(document).map_err(|e| describe(e.to_string()))?;
        let named = |(what, count)| Warning { file: location.to_string(), what, count };
        self.warnings.extend(warnings.into_iter().map(named));
        self.files.push((location.clone(), Rc::new(file)));
        Ok(Rc::clone(&self.files[self.files.len() - 1].1))
    }

    pub(super) fn into_warnings(self) -> Vec<Warning> {
        self.warnings
    }
}

/// A file with what does not depend on where its meshes go.
pub(super) struct MeshFile {
    meshes: Vec<three_ds::Mesh>,
    /// For each mesh, the unit normals of its faces' corners.
    normals: Vec<Option<Vec<[Vec3; 3]>>>,
    /// For each material and, last, for faces without one.
    looks: Vec<(SurfaceModel, Sides)>,
}

impl MeshFile {
    /// Also what there is to warn of, with counts.
    fn new(document: three_ds::Document) -> Result<(Self, Vec<(String, u32)>), materials::Error> {
        let skipped = skipped::skipped(&document);
        let three_ds::Document { meshes, materials, mut warnings, .. } = document;
        let normals = meshes.iter().map(|mesh| corner_normals(mesh, &mut warnings)).collect();
        let mut scaled = 0;
        let fallback = three_ds::Material::default();
        let mut looks = Vec::new();
        for material in materials.iter().chain([&fallback]) {
            let (model, was_scaled) = surface_model(material)?;
            scaled += u32::from(was_scaled);
            let sides = if material.two_sided { Sides::Both } else { Sides::Front };
            looks.push((model, sides));
        }
        let mut messages: Vec<(String, u32)> =
            warnings.iter().map(|(kind, count)| (kind.to_string(), count)).collect();
        messages.extend(skipped);
        if scaled > 0 {
            messages.push(("material reflecting more than arrives, scaled down".into(), scaled));
        }
        Ok((Self { meshes, normals, looks }, messages))
    }

    /// The file's meshes where they go, split by material.
    pub(super) fn parts(
        &self,
        placement: &Placement,
    ) -> Result<Vec<(geometry::Mesh, SurfaceModel, Sides)>, geometry::Error> {
        let mut parts = Vec::new();
        for (mesh, normals) in self.meshes.iter().zip(&self.normals) {
            for (look, faces) in self.faces_by_look(mesh) {
                let mut welder = Welder::new(mesh, normals.as_deref(), placement);
                let triangles = faces.into_iter().map(|face| welder.triangle(face)).collect();
                let (model, sides) = self.looks[look];
                parts.push((welder.finish(triangles)?, model, sides));
            }
        }
        Ok(parts)
    }

    fn faces_by_look(&self, mesh: &three_ds::Mesh) -> BTreeMap<usize, Vec<usize>> {
        let without = self.looks.len() - 1;
        let mut looks: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (index, face) in mesh.faces.iter().enumerate() {
            looks.entry(face.material.unwrap_or(without)).or_default().push(index);
        }
        looks
    }
}

/// Collects the vertices of some faces. A vertex with several normals becomes
/// several.
struct Welder<'a> {
    mesh: &'a three_ds::Mesh,
    corner_normals: Option<&'a [[Vec3; 3]]>,
    placement: &'a Placement,
    numbers: HashMap<(u16, Option<[u32; 3]>), u32>,
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    uvs: Vec<geometry::Vec2>,
}

impl<'a> Welder<'a> {
    fn new(
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

    fn triangle(&mut self, face: usize) -> [u32; 3] {
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

    fn finish(self, triangles: Vec<[u32; 3]>) -> Result<geometry::Mesh, geometry::Error> {
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

/// The model nearest to a 3DS material, and whether it had to be scaled down.
///
/// Colours are taken as coded by the sRGB curve. kd = d, ks = s·k (metal: d·k)
/// and n = 2^(10·g), for diffuse d, specular s, strength k and glossiness g:
/// the exponent as in the viewer of lib3ds. Where kd + ks exceeds one both are
/// divided by the largest band of the sum.
fn surface_model(material: &three_ds::Material) -> Result<(SurfaceModel, bool), materials::Error> {
    let diffuse = linear(material.diffuse);
    let tint = match material.shading {
        three_ds::Shading::Metal => diffuse,
        _ => linear(material.specular),
    };
    let specular = tint * material.shininess_strength;
    if specular.is_black() {
        return Ok((SurfaceModel::Lambert(Lambert::new(diffuse)?), false));
    }
    let sum = (diffuse + specular).max_band();
    let divisor = sum.max(1.0);
    let exponent = (10.0 * material.shininess).exp2();
    let model = Phong::new(diffuse / divisor, specular / divisor, exponent)?;
    Ok((SurfaceModel::Phong(model), sum > 1.0))
}

fn linear(coded: Rgb) -> Rgb {
    Rgb::from(coded.to_array().map(crate::srgb::decode))
}

#[cfg(test)]
mod tests;
