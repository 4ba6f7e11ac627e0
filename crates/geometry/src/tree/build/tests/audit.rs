//! Walking all of a tree.

use crate::Aabb;
use crate::tree::build::{MAX_DEPTH, Tree};
use crate::tree::node::{BlockKind, Child, Content, LEAF, Node, WIDTH};

/// The block that an item belongs into.
type Kind = Option<BlockKind>;

/// Checks what must hold for every tree; returns the numbers of its items.
pub(super) fn check(tree: &Tree, boxes: &[Aabb], kind: impl Fn(u32) -> Kind) -> Vec<u32> {
    let (items, blocks) = (Vec::new(), [0; 4]);
    let mut audit = Audit { tree, boxes, items, nodes: 0, blocks, shapes: 0, depth: 0 };
    if let Some(root) = tree.root {
        audit.visit(root, 1, &kind);
    }
    let Audit { mut items, nodes, blocks: [triangles, quads, spheres, disks], .. } = audit;
    assert_eq!(nodes, tree.nodes.len());
    let blocks = [triangles.max(1), quads, spheres, disks];
    assert_eq!(blocks, tree.blocks.each_ref().map(Vec::len));
    let Audit { shapes, depth, .. } = audit;
    assert_eq!(shapes, tree.shapes.len());
    assert_eq!(depth, tree.depth);
    assert!(depth <= MAX_DEPTH);
    items.sort_unstable();
    items
}

struct Audit<'a> {
    tree: &'a Tree,
    boxes: &'a [Aabb],
    items: Vec<u32>,
    /// So many so far, as also of blocks and shapes: each must come in its turn.
    nodes: usize,
    /// The number of blocks by [`BlockKind`].
    blocks: [usize; 4],
    shapes: usize,
    depth: usize,
}

impl Audit<'_> {
    /// Returns the union of all boxes below.
    fn visit(&mut self, child: Child, level: usize, kind: &impl Fn(u32) -> Kind) -> Aabb {
        let items: Vec<u32> = match child.open() {
            Content::Node(index) => return self.node(index, level, kind),
            Content::Triangles(index) => self.block(BlockKind::Triangles, index, kind),
            Content::Quads(index) => self.block(BlockKind::Quads, index, kind),
            Content::Spheres(index) => self.block(BlockKind::Spheres, index, kind),
            Content::Disks(index) => self.block(BlockKind::Disks, index, kind),
            Content::Shapes(range) => {
                assert_eq!(range.start, self.shapes);
                self.shapes = range.end;
                let items = &self.tree.shapes[range];
                assert!(items.iter().all(|&i| kind(i).is_none()));
                items.to_vec()
            }
        };
        assert!((1..=LEAF).contains(&items.len()));
        self.items.extend(&items);
        items.iter().fold(Aabb::EMPTY, |all, &i| all.union(self.boxes[i as usize]))
    }

    fn block(&mut self, of: BlockKind, index: usize, kind: &impl Fn(u32) -> Kind) -> Vec<u32> {
        assert_eq!(index, self.blocks[of as usize]);
        self.blocks[of as usize] += 1;
        let block = self.tree.blocks[of as usize][index];
        let used = block.iter().take_while(|&&i| i < u32::MAX).count();
        assert!(block[used..].iter().all(|&i| i == u32::MAX));
        assert!(block[..used].iter().all(|&i| kind(i) == Some(of)));
        block[..used].to_vec()
    }

    fn node(&mut self, index: usize, level: usize, kind: &impl Fn(u32) -> Kind) -> Aabb {
        assert_eq!(index, self.nodes);
        self.nodes += 1;
        self.depth = self.depth.max(level);
        let node = &self.tree.nodes[index];
        let mut all = Aabb::EMPTY;
        let used = boxes(node).count();
        assert!((2..=WIDTH).contains(&used));
        for (i, (bounds, child)) in boxes(node).enumerate() {
            assert_eq!(bounds, self.visit(child, level + 1, kind), "box {i} of {index}");
            all = all.union(bounds);
        }
        assert!(node.planes[0][used..].iter().all(|&x| x == f32::INFINITY));
        all
    }
}

/// The boxes of a node that are not empty.
pub(super) fn boxes(node: &Node) -> impl Iterator<Item = (Aabb, Child)> {
    let [x, x1, y, y1, z, z1] = node.planes;
    let bounds =
        move |i: usize| Aabb { min: [x[i], y[i], z[i]].into(), max: [x1[i], y1[i], z1[i]].into() };
    let used = x.iter().take_while(|&&x| x < f32::INFINITY).count();
    (0..used).map(move |i| (bounds(i), node.children[i]))
}
