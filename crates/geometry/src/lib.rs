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
//! [`Hit::primitive`] counts in the order in which the caller listed shapes, `t` is in units
//! of the direction's length, and a hit counts when 0 < t < [`Ray::t_max`].
//! [`Bvh::any_hit`] only says whether there is one, [`Bvh::all_hits`] lists them all.
//!
//! # Shapes of several kinds
//!
//! Spheres, quads, disks, cones and triangles go into one tree, and so does whatever
//! is a [`Shape`]: a box around it, and where a ray meets it.
//!
//! ```
//! use traylib_geometry::{Bvh, Facing, Quad, Ray, Shape, Sphere, Vec3};
//!
//! let shapes: Vec<Box<dyn Shape>> = vec![
//!     Box::new(Quad::new(Vec3::new(-2.0, 0.0, -2.0), 4.0 * Vec3::Z, 4.0 * Vec3::X)?),
//!     Box::new(Sphere::new(Vec3::Y, 1.0, Facing::Outward)?),
//! ];
//! let bvh = Bvh::of_shapes(shapes)?;
//! let hit = bvh.nearest(&Ray::new(Vec3::new(0.0, 5.0, 0.0), Vec3::NEG_Y));
//! assert_eq!(hit.map(|hit| hit.primitive), Some(1));
//! # Ok::<(), traylib_geometry::Error>(())
//! ```
//!
//! Where kinds are few, [`Primitive`] or an enum of your own costs less than a box
//! for each.
//!
//! # Instances
//!
//! A tree can stand in many places and is stored once. Hits are numbered as though
//! all copies were listed one after the other; [`Bvh::locate`] takes that apart.
//!
//! ```
//! use std::sync::Arc;
//! use traylib_geometry::glam::Affine3A;
//! use traylib_geometry::{Bvh, Instance, Mesh, Ray, Vec3};
//!
//! let mesh = Mesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]])?;
//! let tree = Arc::new(Bvh::build(&mesh)?);
//! let place = |x: f32| Affine3A::from_translation(Vec3::new(x, 0.0, 0.0));
//! let copy = |x| Instance::new(tree.clone(), place(x));
//! let bvh = Bvh::of_instances(vec![copy(0.0)?, copy(2.0)?])?;
//!
//! let hit = bvh.nearest(&Ray::new(Vec3::new(2.25, 0.25, 1.0), Vec3::NEG_Z));
//! assert_eq!(hit.and_then(|hit| bvh.locate(hit.primitive)), Some((1, 0)));
//! # Ok::<(), traylib_geometry::Error>(())
//! ```
//!
//! # Many rays
//!
//! [`Bvh::nearest_each`] and [`Bvh::any_hit_each`] give the same answers as asking one
//! by one. They keep several rays under way, so that one goes on while another waits
//! for memory or for a result. This gains most where a tree is larger than the caches:
//! some 10 to 50 rays more in a hundred with a thousand or seventy thousand triangles, up
//! to twice as many with a million. They start no threads: a [`Bvh`] can be asked by
//! any number of threads at once, each with rays of its own.
//!
//! # Precision
//!
//! With [`Precision::Watertight`], the default, no ray slips through between triangles
//! that share corners. Whether and where a ray meets a triangle is decided in double
//! precision, so `t` is right to the last bits of an `f32` however thin the triangle is.
//! [`Precision::Fast`] does all of it in single precision, which is coarser on long thin
//! ones and now and then misses a silhouette by some 10⁻⁷ of its distance; it casts some 5 to
//! 20 rays more in a hundred. Where
//! surfaces merely touch and share no corners, as separate quads do, about one ray in
//! ten million passes between them.
//!
//! Lengths are metres by convention only: nothing in this crate compares a
//! length with a constant, so scaling everything by a power of two scales every
//! result exactly.
//!
//! # How far answers hold
//!
//! [`Bvh::nearest`] is the first of [`Bvh::all_hits`], [`Bvh::any_hit`] says whether there is
//! one, and shapes asked one by one have the same hits, all to the bit: for rays that start up to
//! 10¹³ times the size of a shape away from it, even if it is 10⁵ times as long as
//! thick. From further away double precision no longer tells a shape from what is beside it.
//!
//! These hits are those of the exact ray and shapes, but for outlines that it passes
//! within 16 units in the last place of a shape's coordinates (f32) or of the way to it
//! (f64). In an [`Instance`] a ray is moved in single precision, which rounds by some 3·10⁻⁷ of
//! the coordinates of its origin and of the placement, times κ: how much more a placement
//! stretches one direction than another. With κ = 10⁵ that is some hundredth of them. No hit is
//! told before the box of its instance, so with any κ all questions agree.
//!
//! # What is never hit, and what never hits
//!
//! A ray whose origin or direction is infinite or not a number, whose direction is
//! zero or has no coordinate that is a normal number, or whose `t_max` is not above zero
//! hits nothing; an infinite `t_max` is a ray without end. A triangle without area keeps
//! its number and is never hit. Positions, shapes and placements that are not finite are
//! refused as an [`Error`]. Nothing panics.
//!
//! # The same answers everywhere
//!
//! A tree is the same on any number of threads. AVX2 or SSE4.1 are used where the
//! machine that runs the program has them, with no need to compile for it; all
//! instruction sets, and plain code, give the same bits. Answers do not depend on
//! the tree either: of several hits at the same `t` the one with the lowest number is
//! the nearest.
//!
//! # Memory and features
//!
//! A tree over a mesh takes some 60 to 80 bytes a triangle ([`Bvh::memory`]): 61 in
//! rooms of 60 932 and of 890 768 triangles, 77 in one of 1124. It holds the corners
//! of its triangles, so the mesh is not needed for asking.
//!
//! The feature `rayon`, on by default, lets trees be built by as many threads as
//! rayon's pool has. With `serde`, meshes, rays, hits, boxes and options can be written to
//! files and read. Without either there is nothing beneath this crate but
//! `traylib-math` and what that needs: `glam`, `rand_core` and `rand_pcg`.
//!
//! # Leaving a surface
//!
//! A ray that leaves a surface starts at [`SurfaceSite::ray_origin`]; the one
//! that asks whether two surfaces see each other is
//! [`SurfaceSite::segment_to`]. Both keep away from it by a bound on rounding rather
//! than by some small length.

// The kernels must become part of the functions that are compiled for an instruction
// set, or they could not use it.
#![allow(clippy::inline_always)]

mod aabb;
mod bvh;
mod error;
mod f32_filter;
mod mesh;
mod normals;
mod point;
mod precise;
mod primitive;
mod ray;
mod shape;
mod shape_hit;
mod tree;
mod watertight;

pub use aabb::Aabb;
pub use bvh::{Bvh, Instance, Instances, LeafKind, Options, Precision, Shapes, Triangles};
pub use error::Error;
pub use mesh::Mesh;
pub use normals::Normals;
pub use point::SurfaceSite;
pub use primitive::{Form, Outline, Primitive, SidedPrimitive};
pub use ray::{Hit, Ray};
pub use shape::*;
pub use shape_hit::ShapeHit;
pub use traylib_math::{Vec2, Vec3, glam};
pub use tree::build::Quality;

#[cfg(test)]
mod testing;

/// The examples of the package are run as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
