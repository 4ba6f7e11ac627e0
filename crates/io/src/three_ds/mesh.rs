//! Meshes of a 3DS file.

use super::chunk::Reader;
use super::wide;
use super::{WarningKind, Warnings};
use traylib_math::{Vec2, Vec3};

/// A triangle of a [`Mesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    /// Three different vertices, counter-clockwise seen from the front. Each
    /// exists and is finite.
    pub corners: [u16; 3],
    /// Smoothing groups as bits: an edge is smooth where two faces share one.
    /// 0 is flat.
    pub smoothing: u32,
    /// Index into the document's materials.
    pub material: Option<usize>,
}

/// A named mesh, in world space.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Name of the object.
    pub name: String,
    /// Positions. Those no face uses may be infinite or not a number.
    pub vertices: Vec<Vec3>,
    /// Texture coordinates, one per vertex or none at all; v grows upward.
    pub uvs: Vec<Vec2>,
    /// The faces that can be drawn.
    pub faces: Vec<Face>,
}

/// A mesh as it comes, with nothing checked across chunks: they may be in any
/// order.
#[derive(Debug, Default)]
pub(super) struct RawMesh {
    name: String,
    vertices: Vec<Vec3>,
    uvs: Vec<Vec2>,
    faces: Vec<[u16; 3]>,
    smoothing: Vec<u32>,
    groups: Vec<(String, Vec<u16>)>,
}

impl RawMesh {
    /// Reads a triangle object (4100).
    pub(super) fn decode(name: String, mut reader: Reader<'_>, warnings: &mut Warnings) -> Self {
        let mut mesh = Self { name, ..Self::default() };
        while let Some((id, mut body)) = reader.next_chunk(warnings) {
            match id {
                0x4110 => mesh.vertices = body.list(warnings, vec3),
                0x4120 => mesh.faces(body, warnings),
                0x4140 => mesh.uvs = body.list(warnings, vec2),
                _ => {}
            }
        }
        mesh
    }

    fn faces(&mut self, mut reader: Reader<'_>, warnings: &mut Warnings) {
        self.faces = reader.list(warnings, |entry| {
            let corners = [entry.u16()?, entry.u16()?, entry.u16()?];
            // Which edges to draw, and the like.
            let _flags = entry.u16()?;
            Some(corners)
        });
        while let Some((id, mut body)) = reader.next_chunk(warnings) {
            match id {
                0x4130 => {
                    let name = body.string();
                    self.groups.push((name, body.list(warnings, Reader::u16)));
                }
                0x4150 => self.smoothing = masks(body, self.faces.len(), warnings),
                0x41a0 => warnings.add(WarningKind::MapSkipped),
                _ => {}
            }
        }
    }

    /// The mesh with its materials resolved by `find` and only the faces that
    /// can be drawn.
    pub(super) fn finish(
        self,
        find: impl Fn(&str) -> Option<usize>,
        warnings: &mut Warnings,
    ) -> Mesh {
        let materials = self.face_materials(find, warnings);
        let mut faces = Vec::new();
        for (index, &corners) in self.faces.iter().enumerate() {
            if let Some(kind) = self.fault(corners) {
                warnings.add(kind);
                continue;
            }
            let smoothing = self.smoothing.get(index).copied().unwrap_or(0);
            faces.push(Face { corners, smoothing, material: materials[index] });
        }
        let uvs = finish_uvs(self.uvs, self.vertices.len(), warnings);
        Mesh { name: self.name, vertices: self.vertices, uvs, faces }
    }

    fn face_materials(
        &self,
        find: impl Fn(&str) -> Option<usize>,
        warnings: &mut Warnings,
    ) -> Vec<Option<usize>> {
        let mut materials = vec![None; self.faces.len()];
        for (name, members) in &self.groups {
            let material = find(name);
            if material.is_none() {
                warnings.add(WarningKind::UnknownMaterial);
            }
            for &member in members {
                match materials.get_mut(usize::from(member)) {
                    Some(slot) => {
                        if slot.is_some() {
                            warnings.add(WarningKind::FaceInTwoGroups);
                        }
                        *slot = material;
                    }
                    None => warnings.add(WarningKind::GroupBeyondFaces),
                }
            }
        }
        materials
    }

    /// Why a face cannot be drawn.
    fn fault(&self, corners: [u16; 3]) -> Option<WarningKind> {
        let vertex = |corner: u16| self.vertices.get(usize::from(corner)).copied();
        let [Some(a), Some(b), Some(c)] = corners.map(vertex) else {
            return Some(WarningKind::FaceWithoutVertex);
        };
        if !(a.is_finite() && b.is_finite() && c.is_finite()) {
            return Some(WarningKind::FaceNotFinite);
        }
        let normal = wide::cross(wide::difference(a, b), wide::difference(a, c));
        let flat = wide::unit(normal).is_none();
        flat.then_some(WarningKind::FaceWithoutArea)
    }
}

/// One mask per face (4150), without a length in front.
fn masks(mut reader: Reader<'_>, faces: usize, warnings: &mut Warnings) -> Vec<u32> {
    let masks: Vec<u32> = (0..faces).map_while(|_| reader.u32()).collect();
    if masks.len() < faces {
        warnings.add(WarningKind::ListCut);
    }
    masks
}

fn finish_uvs(mut uvs: Vec<Vec2>, vertices: usize, warnings: &mut Warnings) -> Vec<Vec2> {
    if uvs.is_empty() {
        return uvs;
    }
    if uvs.len() != vertices {
        warnings.add(WarningKind::UvCount);
        uvs.resize(vertices, Vec2::ZERO);
    }
    for uv in uvs.iter_mut().filter(|uv| !uv.is_finite()) {
        warnings.add(WarningKind::UvNotFinite);
        *uv = Vec2::ZERO;
    }
    uvs
}

fn vec3(reader: &mut Reader<'_>) -> Option<Vec3> {
    Some(Vec3::new(reader.f32()?, reader.f32()?, reader.f32()?))
}

fn vec2(reader: &mut Reader<'_>) -> Option<Vec2> {
    Some(Vec2::new(reader.f32()?, reader.f32()?))
}
