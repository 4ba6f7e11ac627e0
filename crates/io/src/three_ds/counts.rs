//! The contents of a document, in figures.

use super::{Affine, Document, Mesh, pose};
use serde::Serialize;
use std::collections::BTreeSet;
use traylib_math::{Rgb, Vec3};

/// The contents of a document, counted, to be compared with what another program finds in the same
/// file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Counts {
    /// Version of the file.
    pub version: Option<u32>,
    /// Version of its mesh section.
    pub mesh_version: Option<u32>,
    /// Displayed size of a unit.
    pub master_scale: Option<f32>,
    /// Ambient light.
    pub ambient: Option<[f32; 3]>,
    /// Meshes, with those that nothing can be drawn of.
    pub meshes: usize,
    /// Their vertices.
    pub vertices: usize,
    /// Their faces, with those that cannot be drawn.
    pub faces: usize,
    /// Their texture coordinates.
    pub texcoords: usize,
    /// Materials.
    pub materials: usize,
    /// Lights of both kinds.
    pub lights: usize,
    /// Spot lights among them.
    pub spot_lights: usize,
    /// Cameras.
    pub cameras: usize,
    /// Nodes of the keyframer, of all kinds.
    pub keyframer_nodes: usize,
    /// Names of the files of all maps and masks, each once, sorted by bytes.
    pub texture_files: Vec<String>,
    /// Least and greatest x, y and z of the vertices as stored, without those
    /// that are infinite or not a number.
    pub bbox_stored_vertices: Option<[f32; 6]>,
    /// The pose of the keyframer at frame 0; `None` if it moves no mesh.
    pub pose_at_frame_0: Option<PoseCounts>,
}

/// The pose of the keyframer at frame 0, counted.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PoseCounts {
    /// Nodes that move a mesh.
    pub mesh_nodes: usize,
    /// Meshes that no node moves.
    pub meshes_without_node: usize,
    /// The greatest shift of a vertex along x, y or z.
    pub max_shift_of_a_vertex: f32,
    /// The box as in `bbox_stored_vertices`, of the meshes that nodes move, where they are then.
    pub bbox_frame0: Option<[f32; 6]>,
}

impl Counts {
    /// Counts what a document has.
    pub fn of(document: &Document) -> Self {
        let sum = |count: fn(&Mesh) -> usize| document.meshes.iter().map(count).sum();
        Self {
            version: document.version,
            mesh_version: document.mesh_version,
            master_scale: document.master_scale,
            ambient: document.ambient.map(Rgb::to_array),
            meshes: document.meshes.len(),
            vertices: sum(|mesh| mesh.vertices.len()),
            faces: sum(|mesh| mesh.faces.len() + mesh.dropped_faces),
            texcoords: sum(|mesh| mesh.uvs.len()),
            materials: document.materials.len(),
            lights: document.lights.len(),
            spot_lights: document.lights.iter().filter(|light| light.spot.is_some()).count(),
            cameras: document.cameras.len(),
            keyframer_nodes: document.keyframer.as_ref().map_or(0, |k| k.nodes.len()),
            texture_files: texture_files(document),
            bbox_stored_vertices: bounds(document.meshes.iter().flat_map(finite_vertices)),
            pose_at_frame_0: pose_counts(document),
        }
    }
}

fn texture_files(document: &Document) -> Vec<String> {
    let maps = document.materials.iter().flat_map(|m| m.maps.iter().chain(&m.masks));
    let names: BTreeSet<&String> = maps.map(|(_, map)| &map.file).collect();
    names.into_iter().filter(|name| !name.is_empty()).cloned().collect()
}

fn finite_vertices(mesh: &Mesh) -> impl Iterator<Item = Vec3> {
    mesh.vertices.iter().copied().filter(|vertex| vertex.is_finite())
}

fn bounds(vertices: impl Iterator<Item = Vec3>) -> Option<[f32; 6]> {
    let (low, high) = vertices
        .map(|vertex| (vertex, vertex))
        .reduce(|(low, high), (a, b)| (low.min(a), high.max(b)))?;
    Some([low.x, low.y, low.z, high.x, high.y, high.z])
}

fn pose_counts(document: &Document) -> Option<PoseCounts> {
    let placed = pose::at_start(document);
    let moved: Vec<_> = placed.iter().filter(|placed| placed.node.is_some()).collect();
    let vertices = |placed: &&pose::Placed| {
        let place: Affine = placed.place;
        finite_vertices(&document.meshes[placed.mesh]).map(move |v| (v, place.point(v)))
    };
    let shifts = moved.iter().flat_map(vertices).map(|(from, to)| (to - from).abs().max_element());
    (!moved.is_empty()).then(|| PoseCounts {
        mesh_nodes: moved.len(),
        meshes_without_node: placed.len() - moved.len(),
        max_shift_of_a_vertex: shifts.fold(0.0, f32::max),
        bbox_frame0: bounds(moved.iter().flat_map(vertices).map(|(_, to)| to)),
    })
}
