//! Bounding volume hierarchies: which of many shapes does a ray meet?

mod instances;
mod leaf;
mod shapes;
mod triangles;
mod watertight;

pub use instances::{Instance, Instances};
pub use leaf::LeafKind;
pub use shapes::Shapes;
pub use triangles::Triangles;

use crate::tree::Tree;
use crate::tree::build::Quality;
use crate::tree::query::{All, Any, Nearest, Query};
use crate::{Aabb, Error, Hit, Ray, Vec3};
use leaf::{BatchQuery, LeafVisitor};

/// Shapes in a tree of boxes: the [`Triangles`] of a mesh, [`Shapes`] of any kind,
/// or [`Instances`] of other trees.
///
/// A ray passes boxes that it misses, or that begin beyond the nearest hit so far.
/// Boxes are a little wider than the shapes and box tests err towards a hit, by
/// more than intersections round, so the tree loses no hit at the
/// [distances](crate#how-far-answers-hold) it is made for. The same shapes give the
/// same tree on any number of threads, and the answers depend on the shapes alone:
/// of several hits at the same t, the one with the lowest number is the nearest.
#[derive(Clone, Debug)]
pub struct Bvh<C = Triangles> {
    tree: Tree,
    primitives: C,
    bounds: Aabb,
}

/// The options with which a tree is built and asked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Options {
    /// The time that building the tree may take, for which rays take less.
    pub quality: Quality,
    /// The precision in which rays are tested against triangles.
    pub precision: Precision,
}

/// The precision in which rays are tested against the triangles of a mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Precision {
    /// In double precision: t is right to the last bits of an `f32` whatever the triangle's
    /// form, and no ray slips through between two triangles that share an edge or a corner.
    #[default]
    Watertight,
    /// In single precision: which side of an edge a ray passes is right to some 10⁻⁷ of its
    /// length, and t is rounded as a sum of the corners', which is coarser on long thin
    /// triangles. A ray that leaves a triangle almost along it may meet it again, or a larger
    /// neighbour in its plane: [`SurfaceSite`](crate::SurfaceSite) rules that out for
    /// `Watertight` alone.
    Fast,
}

impl<C: LeafKind> Bvh<C> {
    /// The first hit with 0 < t < `ray.t_max`.
    #[inline]
    pub fn nearest(&self, ray: &Ray) -> Option<Hit> {
        let mut query = Nearest::new(ray);
        self.ask(ray, &mut query);
        query.found()
    }

    /// Tells whether there is any hit with 0 < t < `ray.t_max`.
    #[inline]
    pub fn any_hit(&self, ray: &Ray) -> bool {
        let mut query = Any::new(ray);
        self.ask(ray, &mut query);
        query.found
    }

    /// All hits with 0 < t < `ray.t_max`, the nearest first, of which [`nearest`](Self::nearest)
    /// is one: of each shape the first. Where two triangles share an edge that the ray meets
    /// there may be one for each.
    pub fn all_hits(&self, ray: &Ray) -> Vec<Hit> {
        let mut query = All { limit: ray.t_max, found: Vec::new() };
        self.ask(ray, &mut query);
        query.found.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive)));
        query.found
    }

    /// [`nearest`](Self::nearest) for each ray of a list, in less time than one by one:
    /// while one ray waits for memory or for a result, others go on. Rays of a camera are best
    /// listed row by row: eight neighbours are taken through the tree together.
    ///
    /// Answers as many rays as both lists have room for.
    pub fn nearest_each(&self, rays: &[Ray], hits: &mut [Option<Hit>]) {
        hits.fill(None);
        let rays = &rays[..rays.len().min(hits.len())];
        self.ask_each(rays, Nearest::new, |index, query| hits[index] = query.found());
    }

    /// [`any_hit`](Self::any_hit) for each ray of a list, in less time than one by one.
    ///
    /// Answers as many rays as both lists have room for.
    pub fn any_hit_each(&self, rays: &[Ray], hits: &mut [bool]) {
        hits.fill(false);
        let rays = &rays[..rays.len().min(hits.len())];
        self.ask_each(rays, Any::new, |index, query| hits[index] = query.found);
    }

    /// A box around all shapes; empty without shapes.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Bytes that the tree takes, without the caller's own shapes.
    pub fn memory(&self) -> usize {
        self.tree.memory
    }

    #[inline]
    fn ask<Q: Query>(&self, ray: &Ray, query: &mut Q) {
        self.tree.walk(ray, &mut self.leaves(ray, query));
    }

    #[inline]
    fn ask_each<Q: Query>(
        &self,
        rays: &[Ray],
        question: impl Fn(&Ray) -> Q,
        answer: impl FnMut(usize, &Q),
    ) {
        let begin = |ray| self.leaves(ray, question(ray));
        self.tree.walk_each(&mut BatchQuery { rays, begin, answer });
    }

    /// The leaves as a ray meets them that asks this.
    #[inline(always)]
    fn leaves<'a, Q>(&'a self, ray: &'a Ray, query: Q) -> LeafVisitor<'a, C, Q> {
        LeafVisitor { primitives: &self.primitives, order: &self.tree.order, ray, query }
    }
}

/// The box with room for the rounding of intersections, which is a few units in
/// the last place of the shape's size however near the ray starts, and for shapes met in
/// single precision by rays that all but graze more than ten times as much.
fn widened(bounds: &Aabb) -> Aabb {
    let margin = bounds.extent().max_element() * (64.0 * f32::EPSILON);
    bounds.grown(Vec3::splat(margin))
}

/// The most shapes that a tree can number.
fn check_count(count: usize) -> Result<(), Error> {
    if count > crate::tree::MOST { Err(Error::TooMany) } else { Ok(()) }
}

#[cfg(test)]
mod tests;
