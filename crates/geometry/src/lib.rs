//! Shapes, meshes and ray intersection: what does this ray hit?
//!
//! ```
//! use traylib_geometry::{Bvh, Mesh, Ray, Vec3};
//!
//! // Two triangles: the unit square in the plane z = 0.
//! let positions = vec![Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
//! let mesh = Mesh::new(positions, vec![[0, 1, 2], [0, 2, 3]])?;
//! let bvh = Bvh::build(&mesh)?;
//!
//! let ray = Ray::new(Vec3::new(0.25, 0.75, 2.0), Vec3::NEG_Z);
//! let hit = bvh.nearest(&ray).expect("the square lies below");
//! assert_eq!((hit.t, hit.primitive), (2.0, 1));
//! # Ok::<(), traylib_geometry::Error>(())
//! ```
//!
//! Lengths are metres by convention only: nothing in this crate compares a
//! length with a constant, so scaling everything by a power of two scales every
//! result exactly. A mesh whose triangles share their corners has no gaps that
//! a ray could slip through; where separate quads merely touch, about one ray in
//! ten million does. A ray that is not a number, has no direction or
//! starts at infinity hits nothing.
//!
//! A ray that leaves a surface starts at [`SurfaceSite::ray_origin`]; the one
//! that asks whether two surfaces see each other is
//! [`SurfaceSite::segment_to`].

// The kernels must become part of the functions that are compiled for an instruction
// set, or they could not use it.
#![allow(clippy::inline_always)]

mod aabb;
mod bvh;
mod error;
mod mesh;
mod point;
mod precise;
mod primitive;
mod ray;
mod shape;
mod tree;
mod watertight;

pub use aabb::Aabb;
pub use bvh::{Bvh, Contents, Instance, Instances, Options, Precision, Shapes, Triangles};
pub use error::Error;
pub use mesh::Mesh;
pub use point::SurfaceSite;
pub use primitive::{Primitive, SidedPrimitive};
pub use ray::{Hit, Ray};
pub use shape::{Cone, Disk, Facing, Quad, Shape, ShapeHit, Sides, Sphere, Triangle};
pub use traylib_math::{Vec2, Vec3, glam};
pub use tree::build::Quality;

#[cfg(test)]
mod testing;
