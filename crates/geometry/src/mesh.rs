//! Indexed triangle meshes.

use crate::{Error, Triangle, Vec2, Vec3};

/// Triangles that share their corners; from the front, corners go
/// counter-clockwise.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// Empty, or one a position.
    normals: Vec<Vec3>,
    /// Empty, or one a position.
    uvs: Vec<Vec2>,
}

impl Mesh {
    /// A mesh of triangles given by three indices into `positions` each.
    ///
    /// Triangles without area are kept, so that numbers stay what the caller
    /// knows; [`triangle`](Self::triangle) has nothing to say about them.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::MissingPosition`], [`Error::TooMany`].
    pub fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, Error> {
        if !positions.iter().all(|p| p.is_finite()) {
            return Err(Error::NotFinite);
        }
        if u32::try_from(triangles.len()).is_err() {
            return Err(Error::TooMany);
        }
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&i| i as usize >= positions.len()) {
                return Err(Error::MissingPosition { triangle, index });
            }
        }
        Ok(Self { positions, triangles, normals: Vec::new(), uvs: Vec::new() })
    }

    /// The mesh with a shading normal (of any length) for each position.
    ///
    /// # Errors
    /// [`Error::WrongCount`], [`Error::NotFinite`].
    pub fn with_normals(self, normals: Vec<Vec3>) -> Result<Self, Error> {
        self.check(normals.len(), normals.iter().all(|n| n.is_finite()))?;
        Ok(Self { normals, ..self })
    }

    /// The mesh with texture coordinates for each position.
    ///
    /// # Errors
    /// [`Error::WrongCount`], [`Error::NotFinite`].
    pub fn with_uvs(self, uvs: Vec<Vec2>) -> Result<Self, Error> {
        self.check(uvs.len(), uvs.iter().all(|uv| uv.is_finite()))?;
        Ok(Self { uvs, ..self })
    }

    fn check(&self, given: usize, finite: bool) -> Result<(), Error> {
        let positions = self.positions.len();
        if given != positions {
            return Err(Error::WrongCount { positions, given });
        }
        if finite { Ok(()) } else { Err(Error::NotFinite) }
    }

    /// Whether there is anything to interpolate, normals or texture coordinates.
    pub fn has_attributes(&self) -> bool {
        !(self.normals.is_empty() && self.uvs.is_empty())
    }

    /// Where the corners are.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// The corners of each triangle, as indices into the positions.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// How many triangles there are, those without area included.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Triangle `index`; `None` if there is none or it has no area.
    pub fn triangle(&self, index: usize) -> Option<Triangle> {
        let [a, b, c] = self.corners(index, &self.positions)?;
        Triangle::new(a, b, c).ok()
    }

    /// The unit shading normal of triangle `index` at barycentric coordinates
    /// `u`, `v` (of its second and third corner).
    ///
    /// `None` without normals or where they cancel.
    pub fn shading_normal(&self, index: usize, u: f32, v: f32) -> Option<Vec3> {
        let [a, b, c] = self.corners(index, &self.normals)?;
        ((1.0 - u - v) * a + u * b + v * c).try_normalize()
    }

    /// The texture coordinates of triangle `index` at barycentric coordinates
    /// `u`, `v`; `None` without any.
    pub fn uv(&self, index: usize, u: f32, v: f32) -> Option<Vec2> {
        let [a, b, c] = self.corners(index, &self.uvs)?;
        Some((1.0 - u - v) * a + u * b + v * c)
    }

    /// How triangle `index` moves with its texture coordinates.
    pub fn tangents(&self, index: usize) -> Option<(Vec3, Vec3)> {
        let [a, b, c] = self.corners(index, &self.positions)?;
        let [ta, tb, tc] = self.corners(index, &self.uvs)?;
        let (p, q, s, t) = (b - a, c - a, tb - ta, tc - ta);
        let d = s.x * t.y - s.y * t.x;
        let (u, v) = ((p * t.y - q * s.y) / d, (q * s.x - p * t.x) / d);
        (u.is_finite() && v.is_finite()).then_some((u, v))
    }

    /// What belongs to the corners of a triangle.
    fn corners<T: Copy>(&self, index: usize, values: &[T]) -> Option<[T; 3]> {
        let &[a, b, c] = self.triangles.get(index)?;
        let value = |i: u32| values.get(i as usize).copied();
        Some([value(a)?, value(b)?, value(c)?])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> Mesh {
        Mesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2], [0, 1, 1]]).unwrap()
    }

    #[test]
    fn a_triangle_without_area_keeps_its_number_only() {
        let mesh = triangle();
        assert_eq!(mesh.triangle_count(), 2);
        assert_eq!(mesh.triangle(0).unwrap().normal(), Vec3::Z);
        assert!(mesh.triangle(1).is_none() && mesh.triangle(2).is_none());
    }

    #[test]
    fn attributes_are_interpolated() {
        let mesh = triangle().with_normals(vec![Vec3::Z, Vec3::X * 2.0, Vec3::NEG_Z]).unwrap();
        assert_eq!(mesh.uv(0, 0.5, 0.25), None);
        assert_eq!(mesh.shading_normal(0, 1.0, 0.0), Some(Vec3::X));
        assert_eq!(mesh.shading_normal(0, 0.0, 0.5), None);
        let mesh = mesh.with_uvs(vec![Vec2::ZERO, Vec2::X, Vec2::Y]).unwrap();
        assert_eq!(mesh.uv(0, 0.5, 0.25), Some(Vec2::new(0.5, 0.25)));
    }

    #[test]
    fn broken_meshes_are_refused() {
        let missing = Mesh::new(vec![Vec3::ZERO; 3], vec![[0, 1, 2], [0, 3, 1]]);
        assert_eq!(missing, Err(Error::MissingPosition { triangle: 1, index: 3 }));
        assert_eq!(Mesh::new(vec![Vec3::NAN], vec![]), Err(Error::NotFinite));
        let short = triangle().with_uvs(vec![Vec2::ZERO; 2]);
        assert_eq!(short, Err(Error::WrongCount { positions: 3, given: 2 }));
        assert_eq!(triangle().with_normals(vec![Vec3::NAN; 3]), Err(Error::NotFinite));
    }
}
