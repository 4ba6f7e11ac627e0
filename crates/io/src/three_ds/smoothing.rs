//! Vertex normals from smoothing groups.
//!
//! Two faces join smoothly at a vertex when their masks share a bit. The normal
//! at a corner is the mean of the unit normals of all faces around the same
//! vertex index that join with its face, each weighted by its angle there. A
//! face of mask 0 is flat.

use super::wide::{self, Wide};
use super::{Face, Mesh, WarningKind, Warnings};
use std::collections::HashMap;
use traylib_math::Vec3;

/// Masks told apart around one vertex. 32 groups make real files use few; a
/// file made to waste time could use one a face.
const MAX_MASKS: usize = 64;

/// The sum of weighted normals around one vertex for each mask.
type Sums = Vec<(u32, Wide)>;

/// Unit normals at the three corners of every face; `None` if the whole mesh is
/// flat.
pub fn corner_normals(mesh: &Mesh, warnings: &mut Warnings) -> Option<Vec<[Vec3; 3]>> {
    if mesh.faces.iter().all(|face| face.smoothing == 0) {
        return None;
    }
    let smooth = vertex_normals(&mesh.vertices, &mesh.faces, warnings);
    let normals = |face: &Face| {
        let flat = face_normal(&mesh.vertices, face);
        face.corners.map(|corner| {
            let found = smooth.get(&(corner, face.smoothing)).copied();
            // A normal on the far side of its face would turn light inside out.
            let usable = found.filter(|&normal| wide::dot(normal, flat) > 0.0);
            wide::narrow(usable.unwrap_or(flat))
        })
    };
    Some(mesh.faces.iter().map(normals).collect())
}

/// The smooth unit normal for every vertex and mask that meet.
fn vertex_normals(
    vertices: &[Vec3],
    faces: &[Face],
    warnings: &mut Warnings,
) -> HashMap<(u16, u32), Wide> {
    let mut normals = HashMap::new();
    for (vertex, sums) in sums_by_mask(vertices, faces) {
        if sums.len() > MAX_MASKS {
            warnings.add(WarningKind::TooManySmoothingMasks);
            continue;
        }
        for &(mask, _) in &sums {
            let joined = sums.iter().filter(|(other, _)| other & mask != 0);
            let sum = joined.fold([0.0; 3], |sum, &(_, part)| wide::add(sum, part));
            normals.extend(wide::unit(sum).map(|normal| ((vertex, mask), normal)));
        }
    }
    normals
}

/// For each vertex of smooth faces, in order, the sums by mask.
fn sums_by_mask(vertices: &[Vec3], faces: &[Face]) -> Vec<(u16, Sums)> {
    let mut corners: Vec<(u16, u32, usize, usize)> = Vec::new();
    for (index, face) in faces.iter().enumerate().filter(|(_, face)| face.smoothing != 0) {
        for (place, &corner) in face.corners.iter().enumerate() {
            corners.push((corner, face.smoothing, index, place));
        }
    }
    corners.sort_unstable();
    let same_vertex = corners.chunk_by(|a, b| a.0 == b.0);
    let sums = same_vertex.map(|around| {
        let same_mask = around.chunk_by(|a, b| a.1 == b.1);
        let sum = same_mask.map(|joined| {
            let parts = joined
                .iter()
                .map(|&(.., index, place)| weighted_normal(vertices, &faces[index], place));
            (joined[0].1, parts.fold([0.0; 3], wide::add))
        });
        (around[0].0, sum.collect())
    });
    sums.collect()
}

/// The unit normal of a face times its angle at one corner.
fn weighted_normal(vertices: &[Vec3], face: &Face, place: usize) -> Wide {
    let corner = |i: usize| vertices[usize::from(face.corners[(place + i) % 3])];
    let (here, next, last) = (corner(0), corner(1), corner(2));
    let angle = wide::angle(wide::difference(here, next), wide::difference(here, last));
    wide::times(face_normal(vertices, face), angle)
}

/// Faces without area have been left out before.
fn face_normal(vertices: &[Vec3], face: &Face) -> Wide {
    let [a, b, c] = face.corners.map(|corner| vertices[usize::from(corner)]);
    let normal = wide::cross(wide::difference(a, b), wide::difference(a, c));
    wide::unit(normal).unwrap_or([0.0, 0.0, 1.0])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three triangles around the corner of a cube, with these masks.
    fn corner_of_a_cube(masks: [u32; 3]) -> Mesh {
        let vertices = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
        let corners = [[0, 1, 2], [0, 2, 3], [0, 3, 1]];
        let face = |(corners, smoothing)| Face { corners, smoothing, ..Face::default() };
        let faces = corners.into_iter().zip(masks).map(face).collect();
        Mesh { vertices, faces, ..Mesh::default() }
    }

    fn normals(masks: [u32; 3]) -> Option<Vec<[Vec3; 3]>> {
        corner_normals(&corner_of_a_cube(masks), &mut Warnings::default())
    }

    fn close(a: Vec3, b: Vec3) -> bool {
        (a - b).length() < 1e-6
    }

    #[test]
    fn without_groups_all_is_flat() {
        assert_eq!(normals([0; 3]), None);
    }

    #[test]
    fn one_group_smooths_the_corner() {
        let normals = normals([4; 3]).unwrap();
        assert!(normals.iter().all(|face| close(face[0], Vec3::ONE.normalize())));
        // Along the edge to y only two faces meet, at equal angles.
        assert!(close(normals[0][2], Vec3::new(1.0, 0.0, 1.0).normalize()));
        assert!(close(normals[1][1], normals[0][2]));
    }

    #[test]
    fn groups_join_only_where_they_share_a_bit() {
        let normals = normals([1, 3, 0]).unwrap();
        let pair = Vec3::new(1.0, 0.0, 1.0).normalize();
        assert!(close(normals[0][0], pair) && close(normals[1][0], pair));
        assert_eq!(normals[2], [Vec3::Y; 3]);
        let separate = corner_normals(&corner_of_a_cube([1, 2, 4]), &mut Warnings::default());
        assert_eq!(separate.unwrap(), [[Vec3::Z; 3], [Vec3::X; 3], [Vec3::Y; 3]]);
    }

    #[test]
    fn scaling_by_a_power_of_two_changes_no_bit() {
        let mesh = corner_of_a_cube([1, 1, 1]);
        let mut scaled = mesh.clone();
        scaled.vertices.iter_mut().for_each(|vertex| *vertex *= 2.0_f32.powi(-40));
        let mut warnings = Warnings::default();
        assert_eq!(corner_normals(&mesh, &mut warnings), corner_normals(&scaled, &mut warnings));
    }

    #[test]
    fn a_normal_never_points_behind_its_face() {
        // Two faces back to back cancel; each keeps its own normal.
        let vertices = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
        let face = |corners| Face { corners, smoothing: 1, ..Face::default() };
        let faces = vec![face([0, 1, 2]), face([0, 2, 1])];
        let mesh = Mesh { vertices, faces, ..Mesh::default() };
        let normals = corner_normals(&mesh, &mut Warnings::default()).unwrap();
        assert_eq!(normals, [[Vec3::Z; 3], [Vec3::NEG_Z; 3]]);
    }

    #[test]
    fn too_many_masks_are_left_flat() {
        let faces = (0..300)
            .map(|i| Face {
                corners: [0, i + 1, i + 2],
                smoothing: 1 + u32::from(i),
                ..Face::default()
            })
            .collect();
        let fan = |i: u16| Vec3::new((f32::from(i) * 0.01).cos(), (f32::from(i) * 0.01).sin(), 0.0);
        let vertices = std::iter::once(Vec3::Z).chain((0..302).map(fan)).collect();
        let mesh = Mesh { vertices, faces, ..Mesh::default() };
        let mut warnings = Warnings::default();
        assert!(corner_normals(&mesh, &mut warnings).is_some());
        assert_eq!(warnings.count(&WarningKind::TooManySmoothingMasks), 1);
    }
}
