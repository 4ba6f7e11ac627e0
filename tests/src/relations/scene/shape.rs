//! Forms in space.

use traylib_geometry::Aabb;
use traylib_math::{Vec2, Vec3};

/// Every shape that a scene can hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Its front is the side from which the corners go counter-clockwise.
    Triangle([Vec3; 3]),
    /// A corner and two edges from there, the front along their cross product.
    Quad([Vec3; 3]),
    /// Centre, normal and radius.
    Disk {
        /// Its middle.
        centre: Vec3,
        /// The direction of its front.
        normal: Vec3,
        /// Inner radius, zero of a whole disk.
        inner: f32,
        /// Its radius.
        radius: f32,
    },
    /// A tube that may narrow, open at both ends.
    Cone {
        /// Both ends of its axis.
        ends: [Vec3; 2],
        /// The radii there, one of which may be zero.
        radii: [f32; 2],
        /// True if the front is inside.
        inward: bool,
    },
    /// A ball, or a hollow one.
    Sphere {
        /// Its middle.
        centre: Vec3,
        /// Its radius.
        radius: f32,
        /// True if the front is inside.
        inward: bool,
    },
    /// A block along the axes, its fronts outside: least and greatest corner.
    Box([Vec3; 2]),
    /// Triangles that share corners.
    Mesh(Mesh),
}

/// Triangles that share corners.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Corners.
    pub positions: Vec<Vec3>,
    /// Three of them each.
    pub triangles: Vec<[u32; 3]>,
    /// Unit normals of the corners. A mesh has these or texture coordinates.
    pub normals: Option<Vec<Vec3>>,
    /// Texture coordinates of the corners.
    pub uvs: Option<Vec<Vec2>>,
}

impl Mesh {
    /// Flat triangles without pictures.
    pub fn flat(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Self {
        Self { positions, triangles, normals: None, uvs: None }
    }

    /// Adds the triangles of another mesh, which has normals if this one has.
    pub fn join(&mut self, other: &Self) {
        let first = self.positions.len() as u32;
        self.positions.extend(&other.positions);
        self.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(|i| i + first)));
        if let (Some(normals), Some(others)) = (&mut self.normals, &other.normals) {
            normals.extend(others);
        }
    }

    /// The corners of each triangle.
    pub fn corners(&self) -> impl Iterator<Item = [Vec3; 3]> {
        let place = |index: u32| self.positions[index as usize];
        self.triangles.iter().map(move |triangle| triangle.map(place))
    }
}

impl Shape {
    /// A box that holds it.
    pub fn bounds(&self) -> Aabb {
        let points = |points: &[Vec3]| {
            points.iter().fold(Aabb::EMPTY, |bounds, &point| bounds.extend(point))
        };
        let around = |centre: Vec3, reach: f32| Aabb { min: centre - reach, max: centre + reach };
        match self {
            Self::Triangle(corners) => points(corners),
            &Self::Quad([corner, u, v]) => {
                points(&[corner, corner + u, corner + v, corner + u + v])
            }
            &Self::Disk { centre, radius, .. } | &Self::Sphere { centre, radius, .. } => {
                around(centre, radius)
            }
            &Self::Cone { ends: [a, b], radii: [ra, rb], .. } => around(a, ra).union(around(b, rb)),
            &Self::Box([min, max]) => Aabb { min, max },
            Self::Mesh(mesh) => points(&mesh.positions),
        }
    }

    /// Tells whether it has quads or texture coordinates for pictures to lie on.
    pub fn shows_pictures(&self) -> bool {
        match self {
            Self::Quad(_) | Self::Box(_) => true,
            Self::Mesh(mesh) => mesh.uvs.is_some(),
            Self::Triangle(_) | Self::Disk { .. } | Self::Cone { .. } | Self::Sphere { .. } => {
                false
            }
        }
    }

    /// Tells whether it is convex and closed, its front outside.
    pub fn is_solid(&self) -> bool {
        match self {
            Self::Sphere { inward, .. } => !inward,
            Self::Box(_) => true,
            Self::Triangle(_)
            | Self::Quad(_)
            | Self::Disk { .. }
            | Self::Cone { .. }
            | Self::Mesh(_) => false,
        }
    }
}

/// The quads of a box, their fronts outside, as pictures lie on them: seen from
/// outside, with y up, u goes to the right and v up on the walls; top and bottom go
/// on from the wall at the largest z.
pub fn sides_of_box(shape: &Shape) -> Vec<Shape> {
    let &Shape::Box([min, max]) = shape else { return Vec::new() };
    let [x, y, z] = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| axis * (max - min));
    let [right, top] = [min.with_x(max.x), min.with_y(max.y).with_z(max.z)];
    let [front, right_front] = [min.with_z(max.z), max.with_y(min.y)];
    [(min, z, y), (right_front, -z, y), (min, x, z), (top, x, -z), (right, -x, y), (front, x, y)]
        .map(|(corner, u, v)| Shape::Quad([corner, u, v]))
        .into()
}
