//! Eight boxes side by side, and what lies in them.

use crate::shape::ShapeKind;
use crate::{Aabb, Vec3};

/// Boxes in a node.
pub(crate) const WIDTH: usize = 8;

/// Shapes in a block, and the most shapes in a leaf.
pub(crate) const LEAF: usize = 4;

/// The kind of shapes that a block is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BlockKind {
    Triangles,
    Quads,
    Spheres,
    Disks,
}

impl BlockKind {
    /// The kind of block that a shape belongs into.
    #[inline]
    pub(crate) fn of(kind: ShapeKind) -> Option<Self> {
        match kind {
            ShapeKind::Triangle(_) => Some(Self::Triangles),
            ShapeKind::Quad(..) => Some(Self::Quads),
            ShapeKind::Sphere(..) => Some(Self::Spheres),
            ShapeKind::Disk(..) => Some(Self::Disks),
            ShapeKind::Other => None,
        }
    }

    pub(crate) const ALL: [Self; 4] = [Self::Triangles, Self::Quads, Self::Spheres, Self::Disks];
}

/// The child in a box: a node, a block of shapes of one kind, or a run of other shapes.
///
/// The two highest bits tell which; the two below them tell the kind of the block or how
/// many shapes there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(transparent)]
pub(crate) struct Child(u32);

/// A child, opened.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Content {
    /// The number of a node.
    Node(usize),
    /// The number of a block of triangles.
    Triangles(usize),
    /// The number of a block of quads.
    Quads(usize),
    /// The number of a block of spheres.
    Spheres(usize),
    /// The number of a block of disks.
    Disks(usize),
    /// A range of the list of shapes in leaf order.
    Shapes(std::ops::Range<usize>),
}

impl Child {
    /// Numbers of nodes, blocks and shapes are below this.
    pub(crate) const MAX: usize = 1 << 28;
    const LEAF: u32 = 1 << 31;
    const SHAPES: u32 = 1 << 30;
    /// The position, in bits, of the kind of a block or of the number of shapes, less one.
    const KIND_SHIFT: u32 = 28;
    /// The child in the empty boxes of a node: the first block of triangles, which every tree has,
    /// so that no input can lead a ray in circles.
    const NOTHING: Self = Self(Self::LEAF);

    pub(crate) fn node(index: usize) -> Self {
        debug_assert!(index < Self::MAX);
        Self(index as u32)
    }

    pub(crate) fn block(kind: BlockKind, index: usize) -> Self {
        debug_assert!(index < Self::MAX);
        Self(Self::LEAF | (kind as u32) << Self::KIND_SHIFT | index as u32)
    }

    /// Shapes `first` to `first + count − 1` in leaf order.
    pub(crate) fn shapes(first: usize, count: usize) -> Self {
        debug_assert!((1..=LEAF).contains(&count) && first < Self::MAX);
        Self(Self::LEAF | Self::SHAPES | ((count - 1) as u32) << Self::KIND_SHIFT | first as u32)
    }

    /// Tells whether it is no node.
    #[inline]
    pub(crate) fn is_leaf(self) -> bool {
        self.0 & Self::LEAF != 0
    }

    /// The number of the node or the block, or that of the first shape.
    #[inline]
    pub(crate) fn index(self) -> usize {
        (self.0 & (Self::MAX as u32 - 1)) as usize
    }

    /// Names for the boxes of a node, whatever lies in them. They are no children.
    #[inline(always)]
    pub(crate) fn slots(node: usize) -> [Self; WIDTH] {
        std::array::from_fn(|lane| Self((WIDTH * node + lane) as u32))
    }

    /// The node and the place in it for which a name of [`slots`](Self::slots) stands.
    #[inline(always)]
    pub(crate) fn slot(self) -> (usize, usize) {
        (self.0 as usize / WIDTH, self.0 as usize % WIDTH)
    }

    #[inline]
    pub(crate) fn open(self) -> Content {
        let (index, kind) = (self.index(), self.0 >> Self::KIND_SHIFT & 3);
        if !self.is_leaf() {
            Content::Node(index)
        } else if self.0 & Self::SHAPES == 0 {
            match BlockKind::ALL[kind as usize] {
                BlockKind::Triangles => Content::Triangles(index),
                BlockKind::Quads => Content::Quads(index),
                BlockKind::Spheres => Content::Spheres(index),
                BlockKind::Disks => Content::Disks(index),
            }
        } else {
            Content::Shapes(index..index + kind as usize + 1)
        }
    }
}

/// Up to eight boxes and what lies in them: 256 bytes, four lines of the cache.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct Node {
    /// Lowest and highest x of each box, then y, then z. An empty box is lowest
    /// at infinity.
    pub(crate) planes: [[f32; WIDTH]; 6],
    pub(crate) children: [Child; WIDTH],
    /// In which order rays of each octant open the boxes, the farthest first: the
    /// k-th box for octant i is in bits 3i to 3i + 2 of `order[k]`.
    pub(crate) order: [u32; WIDTH],
}

impl Node {
    /// A node of these boxes, of which there are at most eight.
    pub(crate) fn new(boxes: &[(Aabb, Child)]) -> Self {
        let lane = |i: usize| boxes.get(i).map_or(Aabb::EMPTY, |b| b.0);
        let plane = |plane: usize| {
            let axis = plane / 2;
            std::array::from_fn(|i| {
                if plane.is_multiple_of(2) { lane(i).min[axis] } else { lane(i).max[axis] }
            })
        };
        let child = |i: usize| boxes.get(i).map_or(Child::NOTHING, |b| b.1);
        Self {
            planes: std::array::from_fn(plane),
            children: std::array::from_fn(child),
            order: order(boxes),
        }
    }
}

/// See [`Node::order`]. Octants are numbered by the axes along which rays go
/// backward, 1, 2 and 4.
fn order(boxes: &[(Aabb, Child)]) -> [u32; WIDTH] {
    let mut centres = [Vec3::ZERO; WIDTH];
    for (centre, (bounds, _)) in centres.iter_mut().zip(boxes) {
        *centre = bounds.centre();
    }
    let mut packed = [0; WIDTH];
    for octant in 0..8 {
        let sign = |axis: usize| if octant >> axis & 1 == 0 { 1.0 } else { -1.0 };
        let toward = Vec3::new(sign(0), sign(1), sign(2));
        let mut depths = centres.map(|centre| centre.dot(toward));
        depths[boxes.len().min(WIDTH)..].fill(f32::INFINITY);
        for (lane, place) in places(&depths).into_iter().enumerate() {
            packed[place as usize % WIDTH] |= (lane as u32) << (3 * octant);
        }
    }
    packed
}

/// At which place each depth comes, the greatest first; of those that differ in the last
/// three bits only, the one with the lowest number.
fn places(depths: &[f32; WIDTH]) -> [u32; WIDTH] {
    let mut keys = depths.map(|depth| {
        let bits = depth.to_bits().cast_signed();
        bits ^ (bits >> 31 & i32::MAX)
    });
    for (key, number) in keys.iter_mut().zip((0..8).rev()) {
        *key = *key & !7 | number;
    }
    // Counted, not sorted: without a jump.
    let mut places = [0; WIDTH];
    for greater in keys {
        for (place, key) in places.iter_mut().zip(keys) {
            *place += u32::from(greater > key);
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_farthest_comes_first_and_of_equals_the_first() {
        let depths = [1.0, -2.0, 0.0, f32::INFINITY, 1.0, -3.0, 7.0, f32::INFINITY];
        assert_eq!(places(&depths), [3, 6, 5, 0, 4, 7, 2, 1]);
    }
}
