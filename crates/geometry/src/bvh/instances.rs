//! Trees placed in a larger one.

use super::Bvh;
use super::leaf::{Leaf, LeafKind, LeafVisitor};
use super::widened;
use crate::shape::ShapeKind;
use crate::tree::Tree;
use crate::tree::block::Block;
use crate::tree::build::Quality;
use crate::tree::intersector::TriangleIntersector;
use crate::tree::lanes::triangles::PacketTriangles;
use crate::tree::query::Query;
use crate::tree::shape_block::{Line, ShapeBlock};
use crate::tree::simd::Simd;
use crate::tree::visitor::Visitors;
use crate::{Aabb, Error, Hit, Ray, Vec3};
use std::ops::ControlFlow;
use std::sync::Arc;
use traylib_math::glam::{Affine3A, DAffine3};

/// A tree somewhere else, turned and stretched.
///
/// Rays are moved into it in single precision: see
/// [how far answers hold](crate#how-far-answers-hold) for axes that are nearly parallel.
#[derive(Clone, Debug)]
pub struct Instance<C = super::Triangles> {
    tree: Arc<Bvh<C>>,
    to_tree: Affine3A,
    bounds: Aabb,
}

impl<C: LeafKind> Instance<C> {
    /// The shapes of `tree`, moved by `placement`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] when the placement is not finite or cannot be undone.
    pub fn new(tree: Arc<Bvh<C>>, placement: Affine3A) -> Result<Self, Error> {
        let to_tree = undone(&placement);
        if !placement.is_finite() || !to_tree.is_finite() {
            return Err(Error::NotFinite);
        }
        let bounds = placed(&tree.bounds, &placement);
        Ok(Self { tree, to_tree, bounds })
    }
}

/// The inverse, rounded once: in single precision the digits that nearly parallel axes
/// differ in would be lost twice.
fn undone(placement: &Affine3A) -> Affine3A {
    let columns = placement.to_cols_array().map(f64::from);
    DAffine3::from_cols_array(&columns).inverse().as_affine3a()
}

/// The box around the corners of a box, moved.
fn placed(bounds: &Aabb, placement: &Affine3A) -> Aabb {
    if bounds.is_empty() {
        return Aabb::EMPTY;
    }
    let pick = |high: bool, axis: usize| if high { bounds.max[axis] } else { bounds.min[axis] };
    let corner = |i: u32| Vec3::new(pick(i & 1 != 0, 0), pick(i & 2 != 0, 1), pick(i & 4 != 0, 2));
    let around = Aabb::around((0..8).map(|i| placement.transform_point3(corner(i))));
    // Rays are moved into the tree, which rounds in the size of their origins.
    around.grown(around.min.abs().max(around.max.abs()) * (16.0 * f32::EPSILON))
}

/// The leaf kind of a [`Bvh`] of instances: copies of trees, each at a place of its own.
///
/// Shapes are numbered as though all copies were listed one after the other.
#[derive(Clone, Debug)]
pub struct Instances<C = super::Triangles> {
    instances: Vec<Instance<C>>,
    /// The number of the first shape of each instance, and that after the last.
    first: Vec<u32>,
}

impl<C: LeafKind> Bvh<Instances<C>> {
    /// A tree over instances of other trees. Those of empty trees are left out.
    ///
    /// # Errors
    /// [`Error::UnboundedShape`] when bounds are infinite or not numbers,
    /// [`Error::TooMany`] when the copies have 2³² shapes or more.
    pub fn of_instances(instances: Vec<Instance<C>>) -> Result<Self, Error> {
        let first = numbers(&instances)?;
        let is_filled = |i: &Instance<C>| !i.bounds.is_empty();
        if let Some(index) = instances.iter().position(|i| is_filled(i) && !i.bounds.is_finite()) {
            return Err(Error::UnboundedShape { index });
        }
        let filled = instances.iter().enumerate().filter(|(_, i)| is_filled(i));
        let items = filled.map(|(number, _)| number as u32).collect();
        let boxes: Vec<Aabb> = instances.iter().map(|i| widened(&i.bounds)).collect();
        let tree = Tree::new(boxes, items, |_| ShapeKind::Other, Quality::default());
        let bounds = instances.iter().map(|i| i.bounds).fold(Aabb::EMPTY, Aabb::union);
        Ok(Self { tree, primitives: Instances { instances, first }, bounds })
    }

    /// The instance and the shape within it that a [`Hit::primitive`] stands for.
    pub fn locate(&self, primitive: u32) -> Option<(usize, u32)> {
        let first = &self.primitives.first;
        let instance = first.partition_point(|&f| f <= primitive).checked_sub(1)?;
        (instance + 1 < first.len()).then(|| (instance, primitive - first[instance]))
    }
}

/// Running sums of how many shapes there are.
fn numbers<C: LeafKind>(instances: &[Instance<C>]) -> Result<Vec<u32>, Error> {
    let mut first = vec![0_u32];
    for instance in instances {
        let sum = first.last().and_then(|f| f.checked_add(instance.tree.primitives.count()));
        first.push(sum.ok_or(Error::TooMany)?);
    }
    Ok(first)
}

/// A question to one of many trees, whose shapes are numbered from `first`.
struct Within<'a, Q> {
    query: &'a mut Q,
    first: u32,
    done: bool,
    /// The ray outside of it.
    ray: &'a Ray,
    bounds: &'a Aabb,
}

impl<Q> Within<'_, Q> {
    /// No hit lies before its box. Where axes are nearly parallel, moving the ray rounds by
    /// much, and a hit before its box would be found or not, as the box is opened or left out
    /// for another hit.
    #[inline]
    fn not_before_box(&self, t: f32) -> f32 {
        t.max(enters(self.ray, self.bounds) * NOT_BEFORE)
    }
}

/// A little before a box, by what t rounds; yet after where trees have it begin.
const NOT_BEFORE: f32 = 1.0 - 8.0 * f32::EPSILON;

/// The least t in a box, as trees compute it, whether or not the ray meets the box.
#[inline]
fn enters(ray: &Ray, bounds: &Aabb) -> f32 {
    let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
    let planes = [bounds.min.to_array(), bounds.max.to_array()];
    let enter = |axis: usize| {
        let slope = direction[axis].recip();
        (planes[usize::from(slope < 0.0)][axis] - origin[axis]) * slope
    };
    // A ray within a plane is not before it: 0 · ∞ is no number, and loses.
    enter(0).max(enter(1)).max(enter(2))
}

impl<Q: Query> Query for Within<'_, Q> {
    const IN_ORDER: bool = Q::IN_ORDER;

    #[inline]
    fn limit(&self) -> f32 {
        self.query.limit()
    }

    #[inline]
    fn offer(&mut self, hit: Hit) -> ControlFlow<()> {
        let t = self.not_before_box(hit.t);
        if t >= self.query.limit() {
            return ControlFlow::Continue(());
        }
        let asked = self.query.offer(Hit { t, primitive: self.first + hit.primitive, ..hit });
        self.done = asked.is_break();
        asked
    }
}

impl<C: LeafKind> Leaf for Instances<C> {
    fn count(&self) -> u32 {
        self.first.last().copied().unwrap_or(0)
    }

    /// There are no blocks but those within.
    #[inline]
    fn triangles<T: TriangleIntersector, Q: Query>(
        &self,
        _: &Block,
        _: &T,
        _: &Ray,
        _: &mut Q,
    ) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// As above.
    #[inline]
    fn packet<E: Simd, Q: Query>(
        &self,
        _: &mut Visitors<LeafVisitor<'_, Self, Q>>,
        _: u32,
        _: &Block,
        _: &PacketTriangles<E>,
    ) {
    }

    /// As above.
    #[inline]
    fn block<E: Simd, Q: Query>(
        &self,
        _: &impl ShapeBlock,
        _: &Line<E>,
        _: &mut Q,
    ) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    #[inline]
    fn shape<Q: Query>(&self, number: u32, ray: &Ray, query: &mut Q) -> ControlFlow<()> {
        let Instance { tree, to_tree, bounds } = &self.instances[number as usize];
        // Its direction is not made unit: t is the same within and without.
        let inner = Ray {
            origin: to_tree.transform_point3(ray.origin),
            direction: to_tree.transform_vector3(ray.direction),
            t_max: ray.t_max,
        };
        let first = self.first[number as usize];
        let mut within = Within { query, first, done: false, ray, bounds };
        tree.ask(&inner, &mut within);
        if within.done { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}
