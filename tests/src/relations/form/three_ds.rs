//! 3D Studio's format.

use crate::relations::scene::Mesh;
use traylib_math::Vec3;

/// One mesh without a material.
pub(super) fn mesh(mesh: &Mesh) -> Vec<u8> {
    let object = object("only", mesh, None);
    file(&object)
}

/// A whole file with these chunks in its section of meshes and materials.
pub(super) fn file(editor: &[u8]) -> Vec<u8> {
    chunk(0x4d4d, &[chunk(0x0002, &3_u32.to_le_bytes()), chunk(0x3d3d, editor)].concat())
}

/// A mesh by name, all of its faces of the material of this name.
pub(super) fn object(name: &str, mesh: &Mesh, material: Option<&str>) -> Vec<u8> {
    let mut vertices = count(mesh.positions.len());
    vertices.extend(mesh.positions.iter().flat_map(|&position| floats(position)));
    let mut faces = count(mesh.triangles.len());
    for triangle in &mesh.triangles {
        faces.extend(triangle.iter().flat_map(|&corner| (corner as u16).to_le_bytes()));
        faces.extend(7_u16.to_le_bytes());
    }
    if let Some(material) = material {
        let mut group = text(material);
        group.extend(count(mesh.triangles.len()));
        group.extend((0..mesh.triangles.len()).flat_map(|face| (face as u16).to_le_bytes()));
        faces.extend(chunk(0x4130, &group));
    }
    let mut parts = chunk(0x4110, &vertices);
    if let Some(uvs) = &mesh.uvs {
        let mut places = count(uvs.len());
        for uv in uvs {
            places.extend([uv.x, uv.y].iter().flat_map(|f| f.to_le_bytes()));
        }
        parts.extend(chunk(0x4140, &places));
    }
    parts.extend(chunk(0x4120, &faces));
    let mut object = text(name);
    object.extend(chunk(0x4100, &parts));
    chunk(0x4000, &object)
}

/// A number, the length of all, the content.
pub(super) fn chunk(id: u16, content: &[u8]) -> Vec<u8> {
    let mut bytes = id.to_le_bytes().to_vec();
    bytes.extend((content.len() as u32 + 6).to_le_bytes());
    bytes.extend(content);
    bytes
}

pub(super) fn text(text: &str) -> Vec<u8> {
    [text.as_bytes(), b"\0"].concat()
}

pub(super) fn floats(v: Vec3) -> Vec<u8> {
    v.to_array().iter().flat_map(|f| f.to_le_bytes()).collect()
}

fn count(count: usize) -> Vec<u8> {
    (count as u16).to_le_bytes().to_vec()
}
