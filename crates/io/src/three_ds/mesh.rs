//! Meshes of a 3DS file.

use super::affine::Affine;
use super::wide;
use super::{ObjectFlags, WarningKind};
use traylib_math::{Vec2, Vec3};

/// A triangle of a [`Mesh`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Face {
    /// Three different vertices, counter-clockwise seen from the front. Each
    /// exists and is finite.
    pub corners: [u16; 3],
    /// Smoothing groups as bits: an edge is smooth where two faces share one.
    /// 0 is flat.
    pub smoothing: u32,
    /// Index into the document's materials.
    pub material: Option<usize>,
    /// Marks as stored: bit 0 shows the edge from the third corner to the first,
    /// 1 from the second to the third, 2 from the first to the second; 3 and 4
    /// say that u and v cross the seam of a mapping.
    pub flags: u16,
}

/// A named mesh, in world space.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Name of the object.
    pub name: String,
    /// Marks of the object.
    pub flags: ObjectFlags,
    /// Positions. Those no face uses may be infinite or not a number.
    pub vertices: Vec<Vec3>,
    /// Texture coordinates, one per vertex or none at all; v grows upward.
    pub uvs: Vec<Vec2>,
    /// The faces that can be drawn.
    pub faces: Vec<Face>,
    /// Faces of the file that cannot be drawn and are left out.
    pub dropped_faces: usize,
    /// The object's own x, y and z axes and its origin, in world space. They
    /// have been applied to the vertices already.
    pub axes: Option<[Vec3; 4]>,
    /// Materials of the six sides of a box around the mesh, where it is mapped
    /// so.
    pub box_map: Vec<String>,
}

impl Mesh {
    /// From the object's own coordinates to the world's; nothing is changed
    /// where the file does not say, or says what cannot be undone.
    pub fn local_to_world(&self) -> Affine {
        let stored = self.axes.map(|[x, y, z, origin]| Affine::new([x, y, z], origin));
        stored.filter(|affine| !affine.is_singular()).unwrap_or(Affine::IDENTITY)
    }

    /// The mesh put elsewhere. Where left becomes right, faces are turned over
    /// to keep their fronts outside.
    #[must_use]
    pub fn placed(&self, place: &Affine) -> Self {
        let vertices: Vec<Vec3> = self.vertices.iter().map(|&v| place.point(v)).collect();
        let mirrored = place.determinant() < 0.0;
        let turned = |face: &Face| {
            let [a, b, c] = face.corners;
            Face { corners: if mirrored { [a, c, b] } else { [a, b, c] }, ..*face }
        };
        let drawn = |face: &Face| fault(&vertices, face.corners).is_none();
        let faces: Vec<Face> = self.faces.iter().map(turned).filter(drawn).collect();
        let dropped_faces = self.dropped_faces + self.faces.len() - faces.len();
        let axes = self.axes.map(|[x, y, z, origin]| {
            let [x, y, z] = [x, y, z].map(|axis| place.point(axis + origin) - place.point(origin));
            [x, y, z, place.point(origin)]
        });
        let (name, uvs, box_map) = (self.name.clone(), self.uvs.clone(), self.box_map.clone());
        Self { name, flags: self.flags, vertices, uvs, faces, dropped_faces, axes, box_map }
    }
}

/// Returns the reason why a face cannot be drawn, if there is one.
pub(super) fn fault(vertices: &[Vec3], corners: [u16; 3]) -> Option<WarningKind> {
    let vertex = |corner: u16| vertices.get(usize::from(corner)).copied();
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

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> Mesh {
        let vertices = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
        let faces = vec![Face { corners: [0, 1, 2], smoothing: 5, ..Face::default() }];
        Mesh { vertices, faces, ..Mesh::default() }
    }

    #[test]
    fn a_mirrored_mesh_keeps_its_front() {
        let mirrored = triangle().placed(&Affine::scaling(Vec3::new(-1.0, 1.0, 1.0)));
        assert_eq!(mirrored.vertices, [Vec3::ZERO, Vec3::NEG_X, Vec3::Y]);
        let expected = Face { corners: [0, 2, 1], smoothing: 5, ..Face::default() };
        assert_eq!(mirrored.faces, [expected]);
    }

    #[test]
    fn the_axes_go_along() {
        let origin = Vec3::new(3.0, 0.0, 0.0);
        let mesh = Mesh { axes: Some([Vec3::X, Vec3::Y, Vec3::Z, origin]), ..triangle() };
        let place = Affine::new([Vec3::Y, Vec3::NEG_X, Vec3::Z * 2.0], Vec3::Z);
        let placed = mesh.placed(&place);
        let place_of_origin = Vec3::new(0.0, 3.0, 1.0);
        let expected = [Vec3::Y, Vec3::NEG_X, Vec3::Z * 2.0, place_of_origin];
        assert_eq!(placed.axes, Some(expected));
    }

    #[test]
    fn what_collapses_or_leaves_the_numbers_is_dropped() {
        for scale in [0.0, f32::MAX] {
            let mut mesh = triangle();
            mesh.vertices[1] *= 4.0;
            let placed = mesh.placed(&Affine::scaling(Vec3::splat(scale)));
            assert_eq!((placed.faces.len(), placed.dropped_faces), (0, 1), "{scale}");
        }
    }

    #[test]
    fn axes_that_cannot_be_undone_are_not_used() {
        let flat = Mesh { axes: Some([Vec3::X, Vec3::X, Vec3::Z, Vec3::ONE]), ..triangle() };
        assert_eq!(flat.local_to_world(), Affine::IDENTITY);
        assert_eq!(triangle().local_to_world(), Affine::IDENTITY);
    }
}
