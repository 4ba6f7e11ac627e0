//! A mesh as it stands in a file: what is read is checked before it is a mesh.

use super::Mesh;
use crate::{Error, Vec2, Vec3};
use serde::{Deserialize, Serialize};

#[derive(Deserialize, Serialize)]
pub(super) struct Parts {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    #[serde(default)]
    normals: Vec<Vec3>,
    #[serde(default)]
    uvs: Vec<Vec2>,
}

impl From<Mesh> for Parts {
    fn from(mesh: Mesh) -> Self {
        let Mesh { positions, triangles, normals, uvs } = mesh;
        Self { positions, triangles, normals, uvs }
    }
}

impl TryFrom<Parts> for Mesh {
    type Error = Error;

    fn try_from(parts: Parts) -> Result<Self, Error> {
        let mut mesh = Self::new(parts.positions, parts.triangles)?;
        if !parts.normals.is_empty() {
            mesh = mesh.with_normals(parts.normals)?;
        }
        if !parts.uvs.is_empty() {
            mesh = mesh.with_uvs(parts.uvs)?;
        }
        Ok(mesh)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Mesh, Vec2, Vec3};

    #[test]
    fn a_mesh_is_read_as_it_was_written() {
        let corners = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
        let mesh = Mesh::new(corners, vec![[0, 1, 2]]).unwrap();
        let with_uvs = mesh.clone().with_uvs(vec![Vec2::ZERO, Vec2::X, Vec2::Y]).unwrap();
        let full = with_uvs.clone().with_normals(vec![Vec3::Z; 3]).unwrap();
        for mesh in [Mesh::default(), mesh, with_uvs, full] {
            let text = ron::to_string(&mesh).unwrap();
            assert_eq!(ron::from_str::<Mesh>(&text).unwrap(), mesh, "{text}");
        }
    }

    #[test]
    fn what_is_no_mesh_is_refused() {
        let positions = "positions: [(0, 0, 0), (1, 0, 0), (0, 1, 0)]";
        let read = |rest: &str| ron::from_str::<Mesh>(&format!("({positions}, {rest})"));
        assert_eq!(read("triangles: [(0, 1, 2)]").unwrap().triangle_count(), 1);
        for wrong in ["triangles: [(0, 1, 3)]", "triangles: [(0, 1, 2)], uvs: [(0, 0)]"] {
            assert!(read(wrong).is_err(), "{wrong}");
        }
    }
}
