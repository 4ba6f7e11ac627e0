//! Four boxes side by side, and the test of a ray against them.

use crate::{Aabb, Ray};
use traylib_math::glam::Vec4;

/// Boxes in a node.
pub(super) const WIDTH: usize = 4;

/// What lies in a box: a node, or up to eight shapes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Child(u32);

/// A child, opened.
pub(super) enum Content {
    Node(usize),
    /// A range of the list of shapes in leaf order.
    Shapes(std::ops::Range<usize>),
}

impl Child {
    pub(super) const MAX_SHAPES: usize = 1 << 28;
    pub(super) const MAX_LEAF: usize = 8;
    const LEAF: u32 = 1 << 31;
    /// What the empty boxes of a node hold: it is never reached, and would do
    /// no harm.
    const NOTHING: Self = Self(Self::LEAF);

    pub(super) fn node(index: usize) -> Self {
        Self(index as u32)
    }

    pub(super) fn leaf(first: usize, count: usize) -> Self {
        debug_assert!((1..=Self::MAX_LEAF).contains(&count));
        Self(Self::LEAF | ((count - 1) as u32) << 28 | first as u32)
    }

    #[inline]
    pub(super) fn open(self) -> Content {
        if self.0 & Self::LEAF == 0 {
            return Content::Node(self.0 as usize);
        }
        let first = (self.0 & (Self::MAX_SHAPES as u32 - 1)) as usize;
        Content::Shapes(first..first + (self.0 >> 28 & 7) as usize + 1)
    }
}

/// Up to four boxes and what lies in them.
#[derive(Clone, Debug)]
pub(super) struct Node {
    /// Lowest and highest x of each box, then y, then z.
    planes: [Vec4; 6],
    pub(super) children: [Child; WIDTH],
}

impl Node {
    pub(super) fn new(boxes: &[(Aabb, Child)]) -> Self {
        let lane = |i: usize| boxes.get(i).map_or(Aabb::EMPTY, |b| b.0);
        let boxes_of =
            |f: &dyn Fn(Aabb) -> f32| Vec4::from_array(std::array::from_fn(|i| f(lane(i))));
        let planes = std::array::from_fn(|plane| {
            let axis = plane / 2;
            boxes_of(&|b| if plane % 2 == 0 { b.min[axis] } else { b.max[axis] })
        });
        let child = |i: usize| boxes.get(i).map_or(Child::NOTHING, |b| b.1);
        Self { planes, children: std::array::from_fn(child) }
    }
}

/// A ray prepared for box tests.
///
/// The distances to near planes are made smaller and those to far planes larger
/// by a few roundings, which covers both the rounding here and, since errors of
/// an intersection grow with its distance too, that of the shapes.
pub(super) struct BoxRay {
    origin: [Vec4; 3],
    near: [Vec4; 3],
    far: [Vec4; 3],
    /// Whether the higher plane is the nearer one.
    backward: [bool; 3],
}

impl BoxRay {
    #[inline]
    pub(super) fn new(ray: &Ray) -> Self {
        const MARGIN: f32 = 4.0 * f32::EPSILON;
        let reciprocal = ray.direction.recip();
        let splat = |v: crate::Vec3| v.to_array().map(Vec4::splat);
        Self {
            origin: splat(ray.origin),
            near: splat(reciprocal * (1.0 - MARGIN)),
            far: splat(reciprocal * (1.0 + MARGIN)),
            // The reciprocal of −0 is negative: sign and order agree.
            backward: reciprocal.to_array().map(|r| r < 0.0),
        }
    }

    /// Where the ray enters each box, and one bit for each box that it meets
    /// before `t_max`.
    ///
    /// A ray parallel to a plane and in it gets 0 · ∞ here, whose outcome
    /// differs between machines and does not matter: boxes are wider than what
    /// they hold.
    #[inline]
    pub(super) fn meet(&self, node: &Node, t_max: f32) -> (Vec4, u32) {
        let mut enter = Vec4::ZERO;
        let mut leave = Vec4::splat(t_max);
        for axis in 0..3 {
            let low = 2 * axis;
            let backward = usize::from(self.backward[axis]);
            let near = node.planes[low + backward];
            let far = node.planes[low + 1 - backward];
            enter = ((near - self.origin[axis]) * self.near[axis]).max(enter);
            leave = ((far - self.origin[axis]) * self.far[axis]).min(leave);
        }
        (enter, enter.cmple(leave).bitmask())
    }
}
