//! Visitors: they test the leaves that rays come to, one ray by itself or eight together.

use super::Tree;
use super::block::Block;
use super::intersector::TriangleIntersector;
use super::lanes::triangles::PacketTriangles;
use super::mask::ones;
use super::node::{Child, Content};
use super::shape_block::{Line, ShapeBlock};
use super::simd::{F32x8, PACKET, Simd};
use crate::Ray;
use std::array::from_fn;
use std::ops::{ControlFlow, Range};

/// A visitor: it does what a ray asks for in the leaves that the ray comes to.
pub(crate) trait Visitor: Sized {
    /// True if the nearer boxes are better opened first. Where any hit will do they are not: most
    /// rays start on a surface, and what is in the boxes around it they just left.
    const IN_ORDER: bool;

    /// True if all leaves are blocks of triangles: then none is asked what it is.
    const ONLY_TRIANGLES: bool;

    /// Boxes that begin beyond it are left out: all, once it has broken.
    fn limit(&self) -> f32;

    /// The ray, without regard to the limit.
    fn ray(&self) -> &Ray;

    /// A block of triangles.
    fn triangles<T: TriangleIntersector>(
        &mut self,
        block: &Block,
        intersector: &T,
    ) -> ControlFlow<()>;

    /// A block of triangles, for those rays of a packet that have a bit.
    fn packet<E: Simd>(
        rays: &mut Visitors<Self>,
        active: u32,
        block: &Block,
        triangles: &PacketTriangles<E>,
    );

    /// A block of shapes of another kind.
    fn block<B: ShapeBlock, E: Simd>(&mut self, block: &B, line: &Line<E>) -> ControlFlow<()>;

    /// A run of other shapes, as places in the order of the leaves.
    fn shapes(&mut self, places: Range<usize>) -> ControlFlow<()>;
}

/// The visitors of the rays of a packet.
pub(crate) struct Visitors<V> {
    pub(crate) each: [V; PACKET],
    /// The limits before the leaf.
    pub(crate) limits: [f32; PACKET],
    /// The farthest of them.
    pub(super) limit: f32,
}

impl<V: Visitor> Visitors<V> {
    #[inline(always)]
    pub(super) fn new(simd: impl Simd, each: [V; PACKET]) -> Self {
        let mut this = Self { each, limits: [0.0; PACKET], limit: 0.0 };
        this.see_limits(simd);
        this
    }

    /// All at once: what is written one by one and read together makes a processor wait.
    #[inline(always)]
    pub(super) fn see_limits(&mut self, simd: impl Simd) {
        let limits = simd.load(from_fn(|i| self.each[i].limit()));
        self.limits = limits.to_array();
        self.limit = limits.largest();
    }

    /// Tells something to those rays that have a bit, by their places.
    #[inline(always)]
    pub(crate) fn tell(
        &mut self,
        rays: u32,
        mut told: impl FnMut(usize, &mut V) -> ControlFlow<()>,
    ) {
        for i in ones(rays) {
            // One that breaks has no limit any more.
            let _ = told(i % PACKET, &mut self.each[i % PACKET]);
        }
    }

    /// Takes the rays that have a bit to a block, one by one.
    #[inline(always)]
    fn block(&mut self, active: u32, block: &impl ShapeBlock, simd: impl Simd) {
        self.tell(active, |_, visitor| {
            let line = Line::of(simd, visitor.ray());
            visitor.block(block, &line)
        });
    }

    /// Takes the rays that have a bit to a leaf.
    #[inline(always)]
    pub(super) fn visit<E: Simd>(
        &mut self,
        tree: &Tree,
        leaf: Child,
        triangles: &PacketTriangles<E>,
        active: u32,
    ) {
        match leaf.open() {
            Content::Node(_) => {}
            Content::Triangles(index) => {
                V::packet(self, active, &tree.triangles[index], triangles);
            }
            Content::Quads(index) => self.block(active, &tree.quads[index], triangles.simd),
            Content::Spheres(index) => self.block(active, &tree.spheres[index], triangles.simd),
            Content::Disks(index) => self.block(active, &tree.disks[index], triangles.simd),
            Content::Shapes(places) => {
                self.tell(active, |_, visitor| visitor.shapes(places.clone()));
            }
        }
        self.see_limits(triangles.simd);
    }
}
