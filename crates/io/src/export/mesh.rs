//! Meshes as PLY files of bytes.

use super::exact;
use traylib_geometry::Mesh;
use traylib_math::Vec3;

/// Lengths of a normal to try: in double precision one of the first does, or none.
const TRIES: u32 = 200;

/// The bytes of a file that reads back as this mesh.
pub(super) fn encode(mesh: &Mesh) -> Vec<u8> {
    let (normals, uvs) = (mesh.normals(), mesh.uvs());
    let mut bytes = header(mesh).into_bytes();
    let mut push = |number: f32| bytes.extend(number.to_le_bytes());
    for (index, position) in mesh.positions().iter().enumerate() {
        position.to_array().into_iter().for_each(&mut push);
        if let Some(&normal) = normals.get(index) {
            source_of_normal(normal).to_array().into_iter().for_each(&mut push);
        }
        if let Some(uv) = uvs.get(index) {
            uv.to_array().into_iter().for_each(&mut push);
        }
    }
    for triangle in mesh.triangles() {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|corner| corner.to_le_bytes()));
    }
    bytes
}

fn header(mesh: &Mesh) -> String {
    let of_all = |names: &[&str]| -> String {
        names.iter().flat_map(|name| ["property float ", name, "\n"]).collect()
    };
    let normals =
        if mesh.normals().is_empty() { String::new() } else { of_all(&["nx", "ny", "nz"]) };
    let uvs = if mesh.uvs().is_empty() { String::new() } else { of_all(&["s", "t"]) };
    format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\n{}{normals}{uvs}element face {}\n\
         property list uchar uint vertex_indices\nend_header\n",
        mesh.positions().len(),
        of_all(&["x", "y", "z"]),
        mesh.triangles().len(),
    )
}

/// Readers make normals unit vectors in double precision.
fn source_of_normal(normal: Vec3) -> Vec3 {
    let make = |v: Vec3| Some(v.as_dvec3().normalize_or_zero().as_vec3());
    exact::vector(normal, 1.0, TRIES, make)
}
