//! Shapes, exact and in world space.

use crate::polygon;
use traylib_math::glam::DVec3;

/// A corner of a polygon.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vertex {
    /// The position, in metres.
    pub position: DVec3,
    /// The normal to shade with, of length one.
    pub normal: Option<DVec3>,
}

/// A shape. All numbers are finite, in single precision too, and all radii that
/// must be positive are.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A flat polygon, perhaps concave, perhaps with holes that are joined to
    /// its outline by seams walked both ways.
    Face {
        /// Counter-clockwise seen from the front.
        outline: Vec<Vertex>,
        /// Given apart from the outline, the other way round.
        holes: Vec<Vec<Vertex>>,
    },
    /// A sphere.
    Sphere {
        /// Its centre.
        centre: DVec3,
        /// Its radius.
        radius: f64,
        /// True if the front is inside.
        inward: bool,
    },
    /// A tube, open at both ends.
    Cylinder {
        /// Both ends of its axis, different.
        ends: [DVec3; 2],
        /// Its radius.
        radius: f64,
        /// True if the front is inside.
        inward: bool,
    },
    /// A truncated cone, open at both ends.
    Cone {
        /// Both ends of its axis, different.
        ends: [DVec3; 2],
        /// The radii there; one may be 0.
        radii: [f64; 2],
        /// True if the front is inside.
        inward: bool,
    },
    /// A flat ring.
    Ring {
        /// Its centre.
        centre: DVec3,
        /// The unit normal of its front.
        normal: DVec3,
        /// Inner radius, which may be 0, and outer radius.
        radii: [f64; 2],
    },
    /// A torus.
    Torus {
        /// Its centre.
        centre: DVec3,
        /// Its axis, of length one.
        normal: DVec3,
        /// From the centre to the middle of the tube.
        radius: f64,
        /// The radius of the tube, at most the other radius.
        tube_radius: f64,
        /// True if the front is inside of the tube.
        inward: bool,
    },
    /// A right prism with both end faces.
    Prism {
        /// One end face; counter-clockwise seen from the front, so from inside
        /// of the prism if that is `inward`. Normals are for the sides alone.
        outline: Vec<Vertex>,
        /// From this end face to the other.
        offset: DVec3,
        /// True if the fronts are inside.
        inward: bool,
    },
}

impl Shape {
    /// The keyword of the format that makes this shape.
    pub fn keyword(&self) -> &'static str {
        match self {
            Self::Face { holes, .. } if holes.is_empty() => "f",
            Self::Face { .. } => "fh",
            Self::Sphere { .. } => "sph",
            Self::Cylinder { .. } => "cyl",
            Self::Cone { .. } => "cone",
            Self::Ring { .. } => "ring",
            Self::Torus { .. } => "torus",
            Self::Prism { .. } => "prism",
        }
    }

    /// Returns the numbers of loops and of vertices that it keeps beside itself.
    pub(super) fn kept(&self) -> (usize, usize) {
        match self {
            Self::Face { outline, holes } => {
                (1 + holes.len(), outline.len() + holes.iter().map(Vec::len).sum::<usize>())
            }
            Self::Prism { outline, .. } => (1, outline.len()),
            Self::Sphere { .. }
            | Self::Cylinder { .. }
            | Self::Cone { .. }
            | Self::Ring { .. }
            | Self::Torus { .. } => (0, 0),
        }
    }

    /// The square of its polygons' numbers of vertices, those at the ends of seams
    /// twice.
    pub(super) fn cutting(&self) -> u64 {
        let ((loops, vertices), square) = (self.kept(), |count: usize| (count as u64).pow(2));
        match self {
            Self::Face { .. } => square(vertices + 2 * (loops - 1)),
            Self::Prism { .. } => 2 * square(vertices),
            Self::Sphere { .. }
            | Self::Cylinder { .. }
            | Self::Cone { .. }
            | Self::Ring { .. }
            | Self::Torus { .. } => 0,
        }
    }

    /// Tells whether every number is finite in single precision.
    pub(super) fn is_finite(&self) -> bool {
        let points = |points: &[DVec3]| points.iter().copied().all(is_point);
        match self {
            Self::Face { outline, holes } => corners(outline) && holes.iter().all(|h| corners(h)),
            Self::Sphere { centre, radius, .. } | Self::Torus { centre, radius, .. } => {
                is_point(*centre) && is_length(*radius)
            }
            Self::Cylinder { ends, radius, .. } => points(ends) && is_length(*radius),
            Self::Cone { ends, radii, .. } => points(ends) && radii.iter().all(|&r| is_length(r)),
            Self::Ring { centre, radii, .. } => is_point(*centre) && is_length(radii[1]),
            Self::Prism { outline, offset, .. } => corners(outline) && is_point(*offset),
        }
    }
}

fn corners(vertices: &[Vertex]) -> bool {
    vertices.iter().all(|vertex| is_point(vertex.position))
}

fn is_point(point: DVec3) -> bool {
    point.to_array().into_iter().all(is_length)
}

fn is_length(value: f64) -> bool {
    value.abs() <= f64::from(f32::MAX)
}

/// Twice the area of a loop times its unit normal, after Newell. It points to
/// where the loop goes counter-clockwise.
pub(super) fn newell(outline: &[Vertex]) -> DVec3 {
    polygon::newell(outline.iter().map(|vertex| vertex.position))
}
