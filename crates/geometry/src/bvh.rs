//! Bounding volume hierarchies: which of many shapes does a ray meet?

mod build;
mod node;
mod walk;

use crate::{Aabb, Error, Hit, Ray, Shape};
use node::{Child, Node};
use std::ops::ControlFlow;
use walk::Order;

/// Shapes in a tree of boxes.
///
/// Built with the surface-area heuristic, four boxes a node; the same shapes
/// give the same tree. A ray passes boxes that it misses, or that begin beyond
/// the nearest hit so far. Boxes are a little wider than the shapes and box
/// tests err towards a hit, by more than intersections round, so the tree loses
/// no hit.
#[derive(Clone, Debug)]
pub struct Bvh<S> {
    shapes: Vec<S>,
    nodes: Vec<Node>,
    /// Shapes in the order the leaves list them.
    order: Vec<u32>,
    root: Option<Child>,
    /// Levels of nodes.
    depth: usize,
    bounds: Aabb,
}

impl<S: Shape> Bvh<S> {
    /// A tree over the shapes, of which there may be none.
    ///
    /// # Errors
    /// [`Error::UnboundedShape`] when bounds are infinite or not numbers,
    /// [`Error::TooMany`] for more than 2²⁸ shapes.
    pub fn build(shapes: Vec<S>) -> Result<Self, Error> {
        if shapes.len() > Child::MAX_SHAPES {
            return Err(Error::TooMany);
        }
        let bounds: Vec<Aabb> = shapes.iter().map(S::bounds).collect();
        if let Some(index) = bounds.iter().position(|b| !b.is_finite() || b.is_empty()) {
            return Err(Error::UnboundedShape { index });
        }
        let build::Tree { nodes, order, root, depth } = build::tree(&bounds);
        let bounds = bounds.into_iter().fold(Aabb::EMPTY, Aabb::union);
        Ok(Self { shapes, nodes, order, root, depth, bounds })
    }

    /// The first hit with 0 < t < `ray.t_max`.
    pub fn nearest(&self, ray: &Ray) -> Option<Hit> {
        let mut nearest = None;
        self.walk(ray, Order::NearestFirst, |ray, shapes| {
            for &primitive in shapes {
                if let Some(hit) = self.shapes[primitive as usize].intersect(ray) {
                    ray.t_max = hit.t;
                    nearest = Some(Hit { t: hit.t, primitive, u: hit.u, v: hit.v });
                }
            }
            ControlFlow::Continue(())
        });
        nearest
    }

    /// Whether there is any hit with 0 < t < `ray.t_max`.
    pub fn any_hit(&self, ray: &Ray) -> bool {
        let mut found = false;
        self.walk(ray, Order::Any, |ray, shapes| {
            found = shapes.iter().any(|&i| self.shapes[i as usize].intersect(ray).is_some());
            if found { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        found
    }

    /// The shapes in the caller's order, which [`Hit::primitive`] counts in.
    pub fn shapes(&self) -> &[S] {
        &self.shapes
    }

    /// The box around all shapes; empty without shapes.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }
}

#[cfg(test)]
mod tests;
