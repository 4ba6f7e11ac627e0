//! Trees with eight children a node, from binary ones.

use super::binary::Binary;
use super::cost::{self, Costs, Kind};
use super::flat::{FlatNode, FlatTree};
use super::{GRAIN, Tree};
use crate::Aabb;
use crate::tree::node::{BlockKind, Child, LEAF, Node, WIDTH};
use crate::tree::parallel::{self, cut};

/// Subtrees of fewer items are not worth a thread.
const SERIAL: usize = 1 << 12;

/// The tree that costs least among those that leave out nodes of the binary one.
/// `item` is the number and the kind of each node that is an item.
pub(super) fn tree(binary: &Binary, item: impl Fn(u32) -> (u32, Kind) + Sync) -> Tree {
    let flat = FlatTree::new(binary, |node| item(node).1);
    let widener = Widener { binary, flat, item };
    let all = Part { node: 0, first: 0, count: binary.count() };
    let size = widener.size(all);
    let none = Node::new(&[]);
    let mut tree = Tree {
        nodes: parallel::map(size.nodes, GRAIN, |_| none),
        blocks: BlockKind::ALL.map(|kind| {
            let least = usize::from(kind == BlockKind::Triangles);
            parallel::map(size.blocks[kind as usize].max(least), GRAIN, |_| [u32::MAX; LEAF])
        }),
        shapes: vec![0; size.shapes],
        root: None,
        depth: size.depth,
    };
    let blocks = tree.blocks.each_mut().map(Vec::as_mut_slice);
    let (nodes, shapes) = (&mut tree.nodes[..], &mut tree.shapes[..]);
    let mut out = Out { nodes, blocks, shapes, used: Used::default() };
    tree.root = Some(widener.emit(all, &size, &mut out));
    tree
}

/// A subtree of the binary tree.
#[derive(Clone, Copy)]
struct Part {
    /// Its first node in depth-first order, if it has any.
    node: usize,
    first: usize,
    count: usize,
}

/// The numbers of nodes, blocks and items below a node.
#[derive(Default)]
struct Size {
    nodes: usize,
    /// The number of blocks by [`BlockKind`].
    blocks: [usize; 4],
    shapes: usize,
    depth: usize,
    /// The plans of the children, where each is worth a thread.
    children: Vec<Self>,
}

impl Size {
    fn add(&mut self, other: &Self) {
        self.nodes += other.nodes;
        add(&mut self.blocks, &other.blocks);
        self.shapes += other.shapes;
        self.depth = self.depth.max(other.depth);
    }
}

fn add(blocks: &mut [usize; 4], others: &[usize; 4]) {
    blocks.iter_mut().zip(others).for_each(|(count, other)| *count += other);
}

/// The part of the tree that lies before a subtree.
#[derive(Clone, Copy, Default)]
struct Used {
    nodes: usize,
    blocks: [usize; 4],
    shapes: usize,
}

/// Room for a subtree, and how much of the tree lies before it.
struct Out<'a> {
    nodes: &'a mut [Node],
    blocks: [&'a mut [[u32; LEAF]]; 4],
    shapes: &'a mut [u32],
    used: Used,
}

impl<'a> Out<'a> {
    fn cut(&mut self, size: &Size) -> Self {
        let used = self.used;
        self.used.nodes += size.nodes;
        add(&mut self.used.blocks, &size.blocks);
        self.used.shapes += size.shapes;
        Self {
            nodes: cut(&mut self.nodes, size.nodes),
            blocks: std::array::from_fn(|kind| cut(&mut self.blocks[kind], size.blocks[kind])),
            shapes: cut(&mut self.shapes, size.shapes),
            used,
        }
    }

    fn node(&mut self) -> (&'a mut Node, Child) {
        self.used.nodes += 1;
        (&mut cut(&mut self.nodes, 1)[0], Child::node(self.used.nodes - 1))
    }

    fn block(&mut self, kind: BlockKind, items: impl Iterator<Item = u32>) -> Child {
        let block = &mut cut(&mut self.blocks[kind as usize], 1)[0];
        block.iter_mut().zip(items).for_each(|(slot, item)| *slot = item);
        let used = &mut self.used.blocks[kind as usize];
        *used += 1;
        Child::block(kind, *used - 1)
    }

    fn shapes(&mut self, items: impl ExactSizeIterator<Item = u32>) -> Child {
        let (first, count) = (self.used.shapes, items.len());
        let shapes = cut(&mut self.shapes, count);
        shapes.iter_mut().zip(items).for_each(|(slot, item)| *slot = item);
        self.used.shapes += count;
        Child::shapes(first, count)
    }
}

struct Widener<'a, I> {
    binary: &'a Binary,
    flat: FlatTree,
    item: I,
}

impl<I: Fn(u32) -> (u32, Kind) + Sync> Widener<'_, I> {
    /// Returns the size that a part has if it gets one place.
    fn size(&self, part: Part) -> Size {
        if self.is_leaf(part) {
            return match self.kind(part) {
                Kind::Block(kind) => {
                    let mut size = Size::default();
                    size.blocks[kind as usize] = 1;
                    size
                }
                Kind::Others | Kind::Mixed => Size { shapes: part.count, ..Size::default() },
            };
        }
        let parts = self.children(part);
        let mut size = Size { nodes: 1, ..Size::default() };
        if part.count < SERIAL {
            for &part in &parts {
                size.add(&self.size(part));
            }
        } else {
            size.children = parallel::map(parts.len(), 1, |i| self.size(parts[i]));
            let children = std::mem::take(&mut size.children);
            for child in &children {
                size.add(child);
            }
            size.children = children;
        }
        size.depth += 1;
        size
    }

    /// Writes a part that gets one place.
    fn emit(&self, part: Part, size: &Size, out: &mut Out) -> Child {
        if self.is_leaf(part) {
            return self.leaf(part, out);
        }
        let (node, child) = out.node();
        let parts = self.children(part);
        let mut boxes = [(Aabb::EMPTY, child); WIDTH];
        for (slot, &part) in boxes.iter_mut().zip(&parts) {
            slot.0 = self.bounds(part);
        }
        if size.children.is_empty() {
            for (slot, &part) in boxes.iter_mut().zip(&parts) {
                slot.1 = self.emit(part, size, out);
            }
        } else {
            let tasks = boxes.iter_mut().zip(&parts).zip(&size.children);
            let tasks = tasks.map(|((slot, &part), size)| (slot, part, size, out.cut(size)));
            parallel::run(tasks.collect(), |(slot, part, size, mut out)| {
                slot.1 = self.emit(part, size, &mut out);
            });
        }
        *node = Node::new(&boxes[..parts.len()]);
        child
    }

    fn leaf(&self, part: Part, out: &mut Out) -> Child {
        let items = self.flat.items[part.first..part.first + part.count].iter();
        let items = items.map(|&node| (self.item)(node).0);
        match self.kind(part) {
            Kind::Block(kind) => out.block(kind, items),
            Kind::Others | Kind::Mixed => out.shapes(items),
        }
    }

    /// The parts that get the eight places of a part that is not a leaf.
    fn children(&self, part: Part) -> Vec<Part> {
        let mut parts = Vec::with_capacity(WIDTH);
        self.split(part, WIDTH, &mut parts);
        parts
    }

    fn split(&self, part: Part, places: usize, parts: &mut Vec<Part>) {
        let first = self.shared(part, places).1;
        let [a, b] = self.halves(part);
        self.place(a, first, parts);
        self.place(b, places - first, parts);
    }

    /// Puts a part into as many of these places as are best.
    fn place(&self, part: Part, places: usize, parts: &mut Vec<Part>) {
        let Some(flat) = self.flat(part).filter(|_| places > 1) else {
            parts.push(part);
            return;
        };
        let (cost, fewer) = (self.shared(part, places).0, flat.costs[places - 2]);
        // Of what costs the same: whole leaves, but full nodes.
        if cost < fewer || (cost == fewer && !flat.is_leaf) {
            self.split(part, places, parts);
        } else {
            self.place(part, places - 1, parts);
        }
    }

    fn shared(&self, part: Part, places: usize) -> (f32, usize) {
        let [a, b] = self.halves(part).map(|half| self.costs(half));
        cost::shared(&a, &b, places)
    }

    fn flat(&self, part: Part) -> Option<&FlatNode> {
        (part.count > 1).then(|| &self.flat.nodes[part.node])
    }

    fn is_leaf(&self, part: Part) -> bool {
        self.flat(part).is_none_or(|node| node.is_leaf)
    }

    /// The two parts of one that has more than one item.
    fn halves(&self, part: Part) -> [Part; 2] {
        let Part { node, first, count } = part;
        let split = self.flat.nodes[node].split as usize;
        [
            Part { node: node + 1, first, count: split },
            Part { node: node + split, first: first + split, count: count - split },
        ]
    }

    fn costs(&self, part: Part) -> Costs {
        match self.flat(part) {
            Some(node) => node.costs,
            None => cost::of_item(self.binary.area(self.flat.items[part.first]), self.kind(part)),
        }
    }

    /// The node of the binary tree.
    fn bounds(&self, part: Part) -> Aabb {
        let node = self.flat(part).map_or(self.flat.items[part.first], |node| node.node);
        self.binary.bounds[node as usize].into()
    }

    /// Returns the kind of the first item, and in a leaf of all.
    fn kind(&self, part: Part) -> Kind {
        (self.item)(self.flat.items[part.first]).1
    }
}
