//! Rays from one point that go almost the same way, as those of a camera do: they open
//! boxes and meet triangles together.

mod boxes;

use super::Tree;
use super::batch::Batch;
use super::interleave::{InFlight, Queue, interleave};
use super::intersector::ChildIntersector;
use super::lanes::rays::{Rays, packet};
use super::lanes::triangles::PacketTriangles;
use super::node::{Child, Content};
use super::prefetch::Prefetcher;
use super::simd::{ALL, PACKET, Simd};
use super::stack::Stack;
use super::visitor::{Visitor, Visitors};
use crate::Ray;
use boxes::PacketBoxes;
use std::array::from_fn;
use std::iter::Enumerate;
use std::ops::Range;
use std::slice::Chunks;

/// The number of packets at once that is best where the tree fits into the cache of a core.
const FEW: usize = 2;

/// Takes all packets among the rays to their leaves. The places of the rays that are left.
#[inline(always)]
pub(crate) fn walk_packets<'a, L: ChildIntersector, E: Simd, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    intersector: impl Fn(&'a Ray) -> L,
    simd: E,
    batch: &mut B,
) -> Vec<Range<usize>> {
    let chunks = batch.rays().chunks(PACKET).enumerate();
    let mut packets = Packets { tree, root, intersector, simd, chunks, left: Vec::new() };
    interleave(tree, FEW, batch, &mut packets);
    packets.left
}

/// Packets that wait.
struct Packets<'a, 't, F, E> {
    tree: &'t Tree,
    root: Child,
    intersector: F,
    simd: E,
    chunks: Enumerate<Chunks<'a, Ray>>,
    /// The places of rays that make no packet.
    left: Vec<Range<usize>>,
}

/// A packet in flight.
struct Packet<L, E: Simd, V> {
    /// The number of its first ray.
    first: usize,
    current: Child,
    /// One bit for each ray that goes there.
    active: u32,
    /// All rays before boxes, each before a box, and each before triangles.
    all: L,
    boxes: PacketBoxes<E>,
    triangles: PacketTriangles<E>,
    visitors: Visitors<V>,
}

impl<'a, L, E, B, F> Queue<B, Packet<L, E, B::Visitor>> for Packets<'a, '_, F, E>
where
    L: ChildIntersector,
    E: Simd,
    B: Batch<'a>,
    F: Fn(&'a Ray) -> L,
{
    type Item = (usize, &'a [Ray; PACKET]);

    /// The next packet and the number of its first ray.
    #[inline(always)]
    fn next(&mut self) -> Option<Self::Item> {
        for (chunk, rays) in &mut self.chunks {
            if let Some(rays) = packet(self.simd, rays) {
                return Some((PACKET * chunk, rays));
            }
            let places = PACKET * chunk..PACKET * chunk + rays.len();
            match self.left.last_mut().filter(|last| last.end == places.start) {
                Some(last) => last.end = places.end,
                None => self.left.push(places),
            }
        }
        None
    }

    #[inline(always)]
    fn begin(&self, (first, rays): Self::Item, batch: &B) -> Packet<L, E, B::Visitor> {
        let (ray, rays) = (&rays[0], Rays::of(self.simd, rays));
        let boxes = PacketBoxes::of(&rays);
        let [near, far] = boxes.widest();
        Packet {
            first,
            current: self.root,
            active: ALL,
            all: (self.intersector)(ray).with_reciprocals(near, far),
            boxes,
            triangles: PacketTriangles::of(&rays, self.tree.extents),
            visitors: Visitors::new(self.simd, from_fn(|i| batch.begin(first + i))),
        }
    }

    /// Part by part: to move a whole packet takes longer.
    #[inline(always)]
    fn begin_anew(
        &self,
        (first, rays): Self::Item,
        batch: &B,
        packet: &mut Packet<L, E, B::Visitor>,
    ) {
        let (ray, rays) = (&rays[0], Rays::of(self.simd, rays));
        packet.boxes = PacketBoxes::of(&rays);
        let [near, far] = packet.boxes.widest();
        packet.all = (self.intersector)(ray).with_reciprocals(near, far);
        packet.triangles = PacketTriangles::of(&rays, self.tree.extents);
        for (i, visitor) in packet.visitors.each.iter_mut().enumerate() {
            *visitor = batch.begin(first + i);
        }
        packet.visitors.see_limits(self.simd);
        (packet.first, packet.current, packet.active) = (first, self.root, ALL);
    }
}

impl<'a, L: ChildIntersector, E: Simd, B: Batch<'a>> InFlight<B> for Packet<L, E, B::Visitor> {
    #[inline(always)]
    fn step(&mut self, tree: &Tree, prefetcher: &Prefetcher, stack: &mut Stack) -> bool {
        let Self { boxes, all, visitors, .. } = self;
        if let Content::Node(index) = self.current.open() {
            all.open(
                &tree.nodes[index],
                &Child::slots(index),
                visitors.limit,
                B::Visitor::IN_ORDER,
                stack,
            );
        } else {
            visitors.visit(tree, self.current, &self.triangles, self.active);
        }
        while let Some((index, lane)) = stack.pop(visitors.limit).map(Child::slot) {
            let node = &tree.nodes[index];
            self.active = boxes.meet(node, lane, &visitors.limits);
            if self.active != 0 {
                self.current = node.children[lane];
                prefetcher.ask(self.current);
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn end(&self, batch: &mut B) {
        for (i, visitor) in self.visitors.each.iter().enumerate() {
            batch.end(self.first + i, visitor);
        }
    }
}
