//! A mesh as its chunks come, in any order, and how it is made whole.

use super::affine::Affine;
use super::chunk::Reader;
use super::mesh::fault;
use super::{Face, Mesh, ObjectFlags, WarningKind, Warnings};
use std::collections::BTreeSet;
use traylib_math::{Vec2, Vec3};

/// A mesh with nothing checked across chunks.
#[derive(Debug, Default)]
pub(super) struct RawMesh {
    name: String,
    flags: ObjectFlags,
    vertices: Vec<Vec3>,
    uvs: Vec<Vec2>,
    /// Corners and marks.
    faces: Vec<([u16; 3], u16)>,
    smoothing: Vec<u32>,
    groups: Vec<(String, Vec<u16>)>,
    axes: Option<[Vec3; 4]>,
    box_map: Vec<String>,
}

impl RawMesh {
    /// Reads a triangle object (4100).
    pub(super) fn decode(
        name: String,
        flags: ObjectFlags,
        mut reader: Reader<'_>,
        warnings: &mut Warnings,
    ) -> Self {
        let mut mesh = Self { name, flags, ..Self::default() };
        while let Some((id, mut body)) = reader.next_chunk(warnings) {
            match id {
                0x4110 => mesh.vertices = body.list(warnings, Reader::vec3),
                0x4120 => mesh.faces(body, warnings),
                0x4140 => mesh.uvs = body.list(warnings, Reader::vec2),
                0x4160 => mesh.axes = axes(body, warnings),
                _ => {}
            }
        }
        mesh
    }

    fn faces(&mut self, mut reader: Reader<'_>, warnings: &mut Warnings) {
        self.faces = reader.list(warnings, |entry| {
            Some(([entry.u16()?, entry.u16()?, entry.u16()?], entry.u16()?))
        });
        while let Some((id, mut body)) = reader.next_chunk(warnings) {
            match id {
                0x4130 => {
                    let name = body.string();
                    self.groups.push((name, body.list(warnings, Reader::u16)));
                }
                0x4150 => self.smoothing = masks(body, self.faces.len(), warnings),
                0x41a0 => self.box_map = (0..6).map(|_| body.string()).collect(),
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
        for (index, &(corners, flags)) in self.faces.iter().enumerate() {
            if let Some(kind) = fault(&self.vertices, corners) {
                warnings.add(kind);
                continue;
            }
            let smoothing = self.smoothing.get(index).copied().unwrap_or(0);
            faces.push(Face { corners, smoothing, material: materials[index], flags });
        }
        Mesh {
            name: self.name,
            flags: self.flags,
            uvs: finish_uvs(self.uvs, self.vertices.len(), warnings),
            vertices: self.vertices,
            dropped_faces: self.faces.len() - faces.len(),
            faces,
            axes: self.axes,
            box_map: self.box_map,
        }
    }

    fn face_materials(
        &self,
        find: impl Fn(&str) -> Option<usize>,
        warnings: &mut Warnings,
    ) -> Vec<Option<usize>> {
        let mut materials = vec![None; self.faces.len()];
        let mut changed = vec![false; self.faces.len()];
        let mut beyond = BTreeSet::new();
        for (name, members) in &self.groups {
            let material = find(name);
            if material.is_none() {
                warnings.add(WarningKind::UnknownMaterial);
            }
            for &member in members {
                let member = usize::from(member);
                match materials.get_mut(member) {
                    Some(slot) => {
                        changed[member] |= slot.is_some() && *slot != material;
                        *slot = material;
                    }
                    None => _ = beyond.insert(member),
                }
            }
        }
        let changed = changed.into_iter().filter(|&is| is).count();
        warnings.add_many(WarningKind::FaceInTwoGroups, changed);
        warnings.add_many(WarningKind::GroupBeyondFaces, beyond.len());
        materials
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

/// The local axes and origin (4160). Axes of no use are kept and warned about.
fn axes(mut reader: Reader<'_>, warnings: &mut Warnings) -> Option<[Vec3; 4]> {
    let numbers: [f32; 12] = reader.finite(warnings)?;
    let axes = [0, 3, 6, 9].map(|i| Vec3::from_slice(&numbers[i..i + 3]));
    let [x, y, z, origin] = axes;
    let affine = Affine::new([x, y, z], origin);
    if affine.is_singular() {
        warnings.add(WarningKind::MatrixSingular);
    } else if affine.determinant() < 0.0 {
        warnings.add(WarningKind::MatrixMirrored);
    }
    Some(axes)
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
