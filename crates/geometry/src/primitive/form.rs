//! The form of a shape, on which images in mirrors depend: flat, a ball, or bent otherwise.

use crate::{Aabb, Sphere, Vec3};

/// The form of a shape, with what is known of one that is flat, a ball, or bent otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// It lies in a plane.
    Flat {
        /// The unit normal of its front.
        normal: Vec3,
        /// The outline in the plane.
        outline: Outline,
    },
    /// It is a whole sphere.
    Ball(Sphere),
    /// It is bent otherwise, and lies within this box.
    Bent(Aabb),
}

/// The outline of a flat shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outline {
    /// A triangle with these corners.
    Triangle([Vec3; 3]),
    /// A parallelogram.
    Parallelogram {
        /// One of its corners.
        corner: Vec3,
        /// The edges from there, to the corners beside it.
        edges: [Vec3; 2],
    },
    /// A circle; what lies within may have holes.
    Circle {
        /// Its centre.
        centre: Vec3,
        /// Its radius in metres.
        radius: f32,
    },
}

impl Outline {
    /// The corners in order around it; a circle has none.
    pub fn corners(&self) -> Vec<Vec3> {
        match *self {
            Self::Triangle(corners) => corners.to_vec(),
            Self::Parallelogram { corner, edges: [u, v] } => {
                vec![corner, corner + u, corner + u + v, corner + v]
            }
            Self::Circle { .. } => Vec::new(),
        }
    }
}
