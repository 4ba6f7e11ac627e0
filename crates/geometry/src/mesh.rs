//! Indexed triangle meshes.

#[cfg(feature = "serde")]
mod parts;

use crate::precise::difference;
use crate::{Error, SidedTriangle, Sides, SurfaceSite, Triangle, Vec2, Vec3};

/// Triangles that share their corners; from the front, corners go
/// counter-clockwise.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "parts::Parts", into = "parts::Parts"))]
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

    /// Tells whether there is anything to interpolate, normals or texture coordinates.
    pub fn has_attributes(&self) -> bool {
        !(self.normals.is_empty() && self.uvs.is_empty())
    }

    /// Returns the positions of the corners.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// A shading normal of any length for each position, or none at all.
    pub fn normals(&self) -> &[Vec3] {
        &self.normals
    }

    /// Texture coordinates for each position, or none at all.
    pub fn uvs(&self) -> &[Vec2] {
        &self.uvs
    }

    /// The corners of each triangle, as indices into the positions.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Returns the number of triangles, those without area included.
    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Triangle `index`; `None` if there is none or it has no area.
    pub fn triangle(&self, index: usize) -> Option<Triangle> {
        let [a, b, c] = self.corners(index, &self.positions)?;
        Triangle::new(a, b, c).ok()
    }

    /// The mesh without the triangles that have no area, so that it has a
    /// [`triangle`](Self::triangle) for each number.
    #[must_use]
    pub fn without_degenerate(mut self) -> Self {
        let has_area = |corners: &[u32; 3]| {
            Triangle::has_area(corners.map(|corner| self.positions[corner as usize]))
        };
        self.triangles.retain(has_area);
        self
    }

    /// Moves triangle `index`, which must exist, and leaves its neighbours where they are:
    /// it gets corners of its own.
    pub fn move_triangle(&mut self, index: usize, corners: [Vec3; 3]) {
        let before = self.triangles[index];
        let first = self.positions.len() as u32;
        self.positions.extend(corners);
        append(&mut self.normals, before);
        append(&mut self.uvs, before);
        self.triangles[index] = [first, first + 1, first + 2];
    }

    /// The corners of triangle `index`, which must exist, as a tree keeps them.
    pub fn sided_triangle(&self, index: usize, sides: Sides) -> SidedTriangle {
        SidedTriangle { corners: self.corner_positions(index), sides }
    }

    /// The area of triangle `index`, which must exist, in square metres.
    pub fn triangle_area(&self, index: usize) -> f32 {
        Triangle::area_of(self.corner_positions(index))
    }

    /// The point of triangle `index`, which must exist, at barycentric coordinates `u`,
    /// `v`; as [`Primitive::site`](crate::Primitive::site) has it. `None` without area.
    #[inline]
    pub fn site(&self, index: usize, u: f32, v: f32) -> Option<SurfaceSite> {
        let corners = self.corner_positions(index);
        Some(Triangle::site_between(corners, Triangle::normal_of(corners)?, u, v))
    }

    /// The corners of triangle `index`, which must exist.
    #[inline]
    pub(crate) fn corner_positions(&self, index: usize) -> [Vec3; 3] {
        self.triangles[index].map(|corner| self.positions[corner as usize])
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

    /// The derivatives of a point of triangle `index` with respect to its
    /// texture coordinates u and v, in metres: which ways a texture lies on it.
    ///
    /// `None` without texture coordinates, or where those of the corners lie on
    /// a line and the derivatives are infinite or undefined.
    pub fn tangents(&self, index: usize) -> Option<[Vec3; 2]> {
        let [a, b, c] = self.corners(index, &self.positions)?;
        let (ab, ac) = (difference(b, a), difference(c, a));
        let [a, b, c] = self.corners(index, &self.uvs)?.map(Vec2::as_dvec2);
        let (to_b, to_c) = (b - a, c - a);
        // The corners are linear in u and v: a system of two equations.
        let determinant = to_b.perp_dot(to_c);
        let along_u = ((ab * to_c.y - ac * to_b.y) / determinant).as_vec3();
        let along_v = ((ac * to_b.x - ab * to_c.x) / determinant).as_vec3();
        (along_u.is_finite() && along_v.is_finite()).then_some([along_u, along_v])
    }

    /// Returns the values at the corners of a triangle.
    fn corners<T: Copy>(&self, index: usize, values: &[T]) -> Option<[T; 3]> {
        let &[a, b, c] = self.triangles.get(index)?;
        let value = |i: u32| values.get(i as usize).copied();
        Some([value(a)?, value(b)?, value(c)?])
    }
}

/// Repeats the values of these corners, where there are values.
fn append<T: Copy>(values: &mut Vec<T>, corners: [u32; 3]) {
    if !values.is_empty() {
        values.extend(corners.map(|corner| values[corner as usize]));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

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

    /// Steps along both tangents lead where the texture coordinates do.
    #[test]
    fn tangents_follow_the_texture_coordinates() {
        let mut random = Random::new(1);
        for _ in 0..1000 {
            let corners = [random.point(), random.point(), random.point()];
            let uvs = [random.square(), random.square(), random.square()];
            let [ab, ac] = [uvs[1] - uvs[0], uvs[2] - uvs[0]];
            let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap();
            let mesh = mesh.with_uvs(uvs.to_vec()).unwrap();
            let [along_u, along_v] = mesh.tangents(0).unwrap();
            for (step, end) in [(ab, corners[1]), (ac, corners[2])] {
                let (u, v) = (step.x * along_u, step.y * along_v);
                // Some six roundings of either part.
                let rounding = 1e-6 * (u.length() + v.length() + 1.0);
                assert!((corners[0] + u + v).distance(end) < rounding, "{mesh:?}");
            }
        }
    }

    #[test]
    fn tangents_need_texture_coordinates_with_an_area() {
        assert_eq!(triangle().tangents(0), None);
        let with = |uvs: [Vec2; 3]| triangle().with_uvs(uvs.to_vec()).unwrap();
        let stretched = with([Vec2::ONE, Vec2::new(3.0, 1.0), Vec2::new(1.0, 0.5)]);
        assert_eq!(stretched.tangents(0), Some([0.5 * Vec3::X, -2.0 * Vec3::Y]));
        assert_eq!(stretched.tangents(1), None);
        assert_eq!(stretched.tangents(2), None);
        assert_eq!(with([Vec2::ZERO, Vec2::ONE, 0.1 * Vec2::ONE]).tangents(0), None);
        assert_eq!(with([Vec2::ONE; 3]).tangents(0), None);
        let tiny = 1e-45 * Vec2::ONE;
        assert_eq!(with([Vec2::ZERO, tiny * Vec2::X, tiny * Vec2::Y]).tangents(0), None);
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
