//! The forms that shapes have in their own space, and what becomes of them in a place.

use super::panel::Panel;
use crate::import::model::meshes::{across, with_attributes};
use std::f64::consts::TAU;
use traylib_geometry::{Cone, Disk, Error, Facing, Mesh, Primitive, Sphere, Vec3};
use traylib_math::glam::{DAffine3, DVec3};
use traylib_scene::ObjectShape;

/// A form in its own space.
#[derive(Debug)]
pub(super) enum Form {
    /// From −1 to 1 in x and y, its front toward z.
    Rectangle,
    /// From −1 to 1 in x, y and z.
    Cube,
    /// About the origin with radius 1.
    Sphere,
    /// In x and y about the origin with radius 1, its front toward z.
    Disk,
    /// About the way from one end to the other.
    Cylinder { ends: [DVec3; 2], radius: f64 },
    /// Triangles, and whether their normals say which side is the front.
    Mesh { mesh: Mesh, has_own_normals: bool },
}

/// The sides of a cube: the corner where u and v are 0, and which ways these go. Across u and v
/// is inward.
const SIDES: [[[f64; 3]; 3]; 6] = [
    [[-1.0, -1.0, -1.0], [0.0, 0.0, 2.0], [2.0, 0.0, 0.0]],
    [[1.0, 1.0, 1.0], [-2.0, 0.0, 0.0], [0.0, 0.0, -2.0]],
    [[1.0, -1.0, 1.0], [0.0, 2.0, 0.0], [0.0, 0.0, -2.0]],
    [[-1.0, -1.0, 1.0], [0.0, 2.0, 0.0], [2.0, 0.0, 0.0]],
    [[-1.0, -1.0, -1.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]],
    [[-1.0, 1.0, -1.0], [0.0, -2.0, 0.0], [2.0, 0.0, 0.0]],
];

/// Corners of a disk that is stretched.
const CORNERS: u32 = 64;
/// The tolerance of lengths that should be the same, and of the cosines of right angles.
const ROUNDING: f64 = 1e-4;

impl Form {
    /// The shapes that it comes to in a place, with fronts and backs exchanged if it is turned.
    /// Of what is mirrored, spheres and meshes without normals of their own are inside out, as in
    /// Mitsuba 3.9.1, and all else is not.
    pub(super) fn shapes(
        &self,
        place: &DAffine3,
        is_turned: bool,
        is_textured: bool,
    ) -> Result<Vec<ObjectShape>, Error> {
        let is_mirrored = place.matrix3.determinant() < 0.0;
        match self {
            Self::Rectangle => {
                let sides = [[[-1.0, -1.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]];
                panels(&sides, place, is_turned != is_mirrored, is_textured)
            }
            Self::Cube => panels(&SIDES, place, is_turned == is_mirrored, is_textured),
            Self::Sphere => {
                let radius = place.transform_vector3(DVec3::X).length() as f32;
                let facing = facing(is_turned != is_mirrored);
                let sphere = Sphere::new(place.translation.as_vec3(), radius, facing)?;
                Ok(vec![ObjectShape::Primitive(Primitive::Sphere(sphere))])
            }
            Self::Disk => disk(place, is_turned).map(|shape| vec![shape]),
            Self::Cylinder { ends, radius } => {
                let radius = radius * place.transform_vector3(beside(ends)).length();
                let ends = ends.map(|end| place.transform_point3(end).as_vec3());
                let cone = Cone::new(ends, [radius as f32; 2], facing(is_turned))?;
                Ok(vec![ObjectShape::Primitive(Primitive::Cone(cone))])
            }
            Self::Mesh { mesh, has_own_normals } => {
                let is_inside_out = is_mirrored && !has_own_normals;
                let is_behind = is_turned != is_inside_out;
                // Corners are mirrored with the rest.
                let is_reversed = is_turned != (is_mirrored && *has_own_normals);
                let mesh = placed(mesh, place, is_reversed, is_behind)?;
                Ok(vec![ObjectShape::Mesh(mesh)])
            }
        }
    }

    /// Tells whether it keeps its form in a place.
    pub(super) fn fits(&self, place: &DAffine3) -> bool {
        let to = |v: DVec3| place.transform_vector3(v);
        match self {
            Self::Rectangle | Self::Cube | Self::Disk | Self::Mesh { .. } => true,
            Self::Sphere => is_even([to(DVec3::X), to(DVec3::Y), to(DVec3::Z)]),
            Self::Cylinder { ends, .. } => {
                let axis = (ends[1] - ends[0]).normalize_or_zero();
                let one = beside(ends);
                let [along, one, other] = [axis, one, axis.cross(one)].map(to);
                is_even([along.normalize_or_zero() * one.length(), one, other])
            }
        }
    }

    /// Tells whether it has texture coordinates here.
    pub(super) fn has_uvs(&self) -> bool {
        match self {
            Self::Rectangle | Self::Cube => true,
            Self::Sphere | Self::Disk | Self::Cylinder { .. } => false,
            Self::Mesh { mesh, .. } => !mesh.uvs().is_empty(),
        }
    }

    /// The triangles that it takes memory for.
    pub(super) fn triangles(&self) -> u64 {
        match self {
            Self::Mesh { mesh, .. } => mesh.triangle_count() as u64,
            Self::Rectangle | Self::Cube | Self::Sphere | Self::Disk | Self::Cylinder { .. } => 0,
        }
    }
}

/// Tells whether three vectors are as long as each other and at right angles.
fn is_even([x, y, z]: [DVec3; 3]) -> bool {
    let square = x.length_squared();
    let near = |v: DVec3| (v.length_squared() - square).abs() <= 2.0 * ROUNDING * square;
    let across = |a: DVec3, b: DVec3| a.dot(b).abs() <= ROUNDING * square;
    near(y) && near(z) && across(x, y) && across(y, z) && across(z, x)
}

/// A unit vector at right angles to an axis.
fn beside(ends: &[DVec3; 2]) -> DVec3 {
    (ends[1] - ends[0]).normalize_or(DVec3::Z).any_orthonormal_vector()
}

fn facing(is_inward: bool) -> Facing {
    if is_inward { Facing::Inward } else { Facing::Outward }
}

fn panels(
    sides: &[[[f64; 3]; 3]],
    place: &DAffine3,
    is_behind: bool,
    is_textured: bool,
) -> Result<Vec<ObjectShape>, Error> {
    let panel = |&[corner, u, v]: &[[f64; 3]; 3]| Panel {
        corner: place.transform_point3(DVec3::from(corner)),
        edge_u: place.transform_vector3(DVec3::from(u)),
        edge_v: place.transform_vector3(DVec3::from(v)),
    };
    sides.iter().map(|side| panel(side).shape(is_behind, is_textured)).collect()
}

/// A disk, or triangles where it is stretched.
fn disk(place: &DAffine3, is_turned: bool) -> Result<ObjectShape, Error> {
    let [x, y] = [DVec3::X, DVec3::Y].map(|axis| place.transform_vector3(axis));
    let normal = across(&place.matrix3) * if is_turned { DVec3::NEG_Z } else { DVec3::Z };
    if is_round(place) {
        let normal = normal.normalize_or_zero().as_vec3();
        let disk = Disk::new(place.translation.as_vec3(), normal, x.length() as f32)?;
        return Ok(ObjectShape::Primitive(Primitive::Disk(disk)));
    }
    let corner = |number: u32| {
        let (sine, cosine) = (TAU * f64::from(number) / f64::from(CORNERS)).sin_cos();
        (place.translation + x * cosine + y * sine).as_vec3()
    };
    let mut positions: Vec<Vec3> = (0..CORNERS).map(corner).collect();
    positions.push(place.translation.as_vec3());
    let is_behind = x.cross(y).dot(normal) < 0.0;
    let triangle = |number: u32| {
        let next = (number + 1) % CORNERS;
        if is_behind { [CORNERS, next, number] } else { [CORNERS, number, next] }
    };
    Ok(ObjectShape::Mesh(Mesh::new(positions, (0..CORNERS).map(triangle).collect())?))
}

/// Tells whether a disk stays round in a place.
pub(super) fn is_round(place: &DAffine3) -> bool {
    let [x, y] = [DVec3::X, DVec3::Y].map(|axis| place.transform_vector3(axis));
    is_even([x, y, x.cross(y).normalize_or_zero() * x.length()])
}

/// A mesh in a place: with its corners in reverse order, and its normals turned round.
fn placed(
    mesh: &Mesh,
    place: &DAffine3,
    is_reversed: bool,
    is_behind: bool,
) -> Result<Mesh, Error> {
    let positions = mesh.positions().iter();
    let positions = positions.map(|p| place.transform_point3(p.as_dvec3()).as_vec3()).collect();
    let corners = |&[a, b, c]: &[u32; 3]| if is_reversed { [a, c, b] } else { [a, b, c] };
    let triangles = mesh.triangles().iter().map(corners).collect();
    let across = across(&place.matrix3) * if is_behind { -1.0 } else { 1.0 };
    let normal = |n: &Vec3| (across * n.as_dvec3()).normalize_or_zero().as_vec3();
    with_attributes(
        Mesh::new(positions, triangles)?,
        mesh.normals().iter().map(normal).collect(),
        mesh.uvs().to_vec(),
    )
}
