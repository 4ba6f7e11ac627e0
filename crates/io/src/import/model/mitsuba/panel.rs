//! Parallelograms with texture coordinates, as rectangles and the sides of cubes are.

use crate::import::model::meshes::with_attributes;
use traylib_geometry::{Error, Mesh, Primitive, Quad, Vec2};
use traylib_math::glam::DVec3;
use traylib_scene::ObjectShape;

/// A parallelogram: u goes along one edge, v along the other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Panel {
    pub(super) corner: DVec3,
    pub(super) edge_u: DVec3,
    pub(super) edge_v: DVec3,
}

impl Panel {
    /// The shape whose front is where `edge_u` × `edge_v` points, or behind it. A quad's front
    /// goes with its texture coordinates; where there are pictures, two triangles do otherwise.
    pub(super) fn shape(&self, is_behind: bool, is_textured: bool) -> Result<ObjectShape, Error> {
        let Self { corner, edge_u, edge_v } = *self;
        if is_behind && is_textured {
            return self.triangles();
        }
        let (u, v) = if is_behind { (edge_v, edge_u) } else { (edge_u, edge_v) };
        let quad = Quad::new(corner.as_vec3(), u.as_vec3(), v.as_vec3())?;
        Ok(ObjectShape::Primitive(Primitive::Quad(quad)))
    }

    /// Both halves, with their fronts behind.
    fn triangles(&self) -> Result<ObjectShape, Error> {
        let Self { corner, edge_u, edge_v } = *self;
        let positions = [corner, corner + edge_u, corner + edge_u + edge_v, corner + edge_v];
        let positions = positions.map(narrow).to_vec();
        let uvs = vec![Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
        let mesh = Mesh::new(positions, vec![[0, 2, 1], [0, 3, 2]])?;
        Ok(ObjectShape::Mesh(with_attributes(mesh, Vec::new(), uvs)?))
    }
}

fn narrow(position: DVec3) -> traylib_geometry::Vec3 {
    position.as_vec3()
}
