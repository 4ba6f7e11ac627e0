//! Vertices and triangles on their way to a mesh.

use super::meshes::with_attributes;
use crate::import::counter::Counter;
use traylib_geometry::{self as geometry, Mesh, Vec2, Vec3};
use traylib_math::glam::DVec3;

/// The arrays of a mesh: normals and texture coordinates are there for each position, or not
/// at all.
#[derive(Debug, Default)]
pub(super) struct Arrays {
    pub(super) positions: Vec<Vec3>,
    pub(super) normals: Vec<Vec3>,
    pub(super) uvs: Vec<Vec2>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Arrays {
    /// Puts two sets into one; of attributes that one of them has alone, zero for the other.
    pub(super) fn joined(mut self, other: Self) -> Self {
        let first = self.positions.len() as u32;
        let counts = [self.positions.len(), other.positions.len()];
        join(&mut self.normals, other.normals, Vec3::ZERO, counts);
        join(&mut self.uvs, other.uvs, Vec2::ZERO, counts);
        self.positions.extend(other.positions);
        let moved = |triangle: [u32; 3]| triangle.map(|corner| corner + first);
        self.triangles.extend(other.triangles.into_iter().map(moved));
        self
    }

    /// Makes the mesh, of which every normal is on the front of its triangle: a surface would be
    /// black where it is not.
    ///
    /// # Errors
    /// A number that is infinite or none, or an index of nothing.
    pub(super) fn finish(mut self, counter: &mut Counter) -> Result<Mesh, geometry::Error> {
        let has_all = |triangle: &[u32; 3]| {
            triangle.iter().all(|&corner| (corner as usize) < self.positions.len())
        };
        if !self.normals.is_empty() && self.triangles.iter().all(has_all) {
            self.turn_normals(counter);
            self.flatten_odd_corners(counter);
        }
        let mesh = Mesh::new(self.positions, self.triangles)?;
        with_attributes(mesh, self.normals, self.uvs)
    }

    /// Returns the normal of a triangle, of any length; `None` without area.
    fn front(&self, triangle: &[u32; 3]) -> Option<DVec3> {
        let [a, b, c] = triangle.map(|corner| self.positions[corner as usize].as_dvec3());
        let front = (b - a).cross(c - a);
        (front != DVec3::ZERO).then_some(front)
    }

    fn is_on(&self, front: DVec3, corner: u32) -> bool {
        self.normals[corner as usize].as_dvec3().dot(front) > 0.0
    }

    /// Some writers turn one way and mean the other: where most triangles disagree with all
    /// of their normals, it is all normals that are turned.
    fn turn_normals(&mut self, counter: &mut Counter) {
        let is_behind = |triangle: &&[u32; 3]| {
            let behind = |front: DVec3| {
                let on_back =
                    |&corner: &u32| self.normals[corner as usize].as_dvec3().dot(front) < 0.0;
                triangle.iter().all(on_back)
            };
            self.front(triangle).is_some_and(behind)
        };
        let behind = self.triangles.iter().filter(is_behind).count();
        if 2 * behind > self.triangles.len() {
            for normal in &mut self.normals {
                *normal = -*normal;
            }
            counter.add("mesh whose normals point to the backs of its faces: normals turned");
        }
    }

    /// Corners with a normal behind their triangle, or with none, get that of the triangle.
    fn flatten_odd_corners(&mut self, counter: &mut Counter) {
        let mut odd = 0_usize;
        for index in 0..self.triangles.len() {
            let triangle = self.triangles[index];
            let Some(front) = self.front(&triangle) else { continue };
            for (place, &corner) in triangle.iter().enumerate() {
                if self.is_on(front, corner) {
                    continue;
                }
                odd += usize::from(self.normals[corner as usize] != Vec3::ZERO);
                self.triangles[index][place] = self.positions.len() as u32;
                self.positions.push(self.positions[corner as usize]);
                self.normals.push(front.normalize_or_zero().as_vec3());
                if let Some(&uv) = self.uvs.get(corner as usize) {
                    self.uvs.push(uv);
                }
            }
        }
        let odd = u32::try_from(odd).unwrap_or(u32::MAX);
        counter.add_many("normal on the back of its face: that of the face taken", odd);
    }
}

/// Puts values behind others, with zeros for so many that have none.
fn join<T: Copy>(own: &mut Vec<T>, added: Vec<T>, zero: T, [first, more]: [usize; 2]) {
    if own.is_empty() && added.is_empty() {
        return;
    }
    own.resize(first, zero);
    own.extend(added);
    own.resize(first + more, zero);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn finished(normals: [Vec3; 4]) -> (Mesh, usize) {
        let positions = vec![Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
        let triangles = vec![[0, 1, 2], [0, 2, 3]];
        let mut counter = Counter::default();
        let arrays =
            Arrays { positions, normals: normals.to_vec(), triangles, ..Arrays::default() };
        let mesh = arrays.finish(&mut counter).unwrap();
        (mesh, counter.into_warnings("x").count())
    }

    #[test]
    fn normals_are_on_the_front_of_their_faces() {
        let (mesh, warnings) = finished([Vec3::Z; 4]);
        assert_eq!((mesh.positions().len(), warnings), (4, 0));
        let (mesh, warnings) = finished([Vec3::NEG_Z; 4]);
        assert_eq!((mesh.normals(), warnings), (&[Vec3::Z; 4][..], 1));
        let (mesh, warnings) = finished([Vec3::Z, Vec3::Z, Vec3::NEG_Z, Vec3::ZERO]);
        // Corner 2 twice, of either triangle, and corner 3.
        assert_eq!((mesh.positions().len(), warnings), (7, 1));
        assert!(mesh.triangles().iter().flatten().all(|&c| mesh.normals()[c as usize] == Vec3::Z));
    }
}
