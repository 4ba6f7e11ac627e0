//! Walking all of a tree.

use crate::Aabb;
use crate::tree::build::{MAX_DEPTH, Tree};
use crate::tree::node::{Child, Content, LEAF, Node, WIDTH};

/// Checks what must hold for every tree; returns the numbers of its items.
pub(super) fn check(tree: &Tree, boxes: &[Aabb], is_triangle: impl Fn(u32) -> bool) -> Vec<u32> {
    let mut audit = Audit { tree, boxes, items: Vec::new(), met: [0; 3], depth: 0 };
    if let Some(root) = tree.root {
        audit.visit(root, 1, &is_triangle);
    }
    let Audit { mut items, met, depth, .. } = audit;
    assert_eq!(met[0], tree.nodes.len());
    assert_eq!(met[1].max(1), tree.blocks.len());
    assert_eq!(met[2], tree.shapes.len());
    assert_eq!(depth, tree.depth);
    assert!(depth <= MAX_DEPTH);
    items.sort_unstable();
    items
}

struct Audit<'a> {
    tree: &'a Tree,
    boxes: &'a [Aabb],
    items: Vec<u32>,
    /// Nodes, blocks and shapes so far: each must come in its turn.
    met: [usize; 3],
    depth: usize,
}

impl Audit<'_> {
    /// Returns the union of all boxes below.
    fn visit(&mut self, child: Child, level: usize, is_triangle: &impl Fn(u32) -> bool) -> Aabb {
        let items: Vec<u32> = match child.open() {
            Content::Node(index) => return self.node(index, level, is_triangle),
            Content::Block(index) => {
                assert_eq!(index, self.met[1]);
                self.met[1] += 1;
                let block = self.tree.blocks[index];
                let used = block.iter().take_while(|&&i| i < u32::MAX).count();
                assert!(block[used..].iter().all(|&i| i == u32::MAX));
                assert!(block[..used].iter().all(|&i| is_triangle(i)));
                block[..used].to_vec()
            }
            Content::Shapes(range) => {
                assert_eq!(range.start, self.met[2]);
                self.met[2] = range.end;
                let items = &self.tree.shapes[range];
                assert!(!items.iter().any(|&i| is_triangle(i)));
                items.to_vec()
            }
        };
        assert!((1..=LEAF).contains(&items.len()));
        self.items.extend(&items);
        items.iter().fold(Aabb::EMPTY, |all, &i| all.union(self.boxes[i as usize]))
    }

    fn node(&mut self, index: usize, level: usize, is_triangle: &impl Fn(u32) -> bool) -> Aabb {
        assert_eq!(index, self.met[0]);
        self.met[0] += 1;
        self.depth = self.depth.max(level);
        let node = &self.tree.nodes[index];
        let mut all = Aabb::EMPTY;
        let used = lanes(node).count();
        assert!((2..=WIDTH).contains(&used));
        for (i, (bounds, child)) in lanes(node).enumerate() {
            assert_eq!(bounds, self.visit(child, level + 1, is_triangle), "box {i} of {index}");
            all = all.union(bounds);
        }
        assert!(node.planes[0][used..].iter().all(|&x| x == f32::INFINITY));
        all
    }
}

/// The boxes of a node that are not empty.
pub(super) fn lanes(node: &Node) -> impl Iterator<Item = (Aabb, Child)> {
    let [x, x1, y, y1, z, z1] = node.planes;
    let lane =
        move |i: usize| Aabb { min: [x[i], y[i], z[i]].into(), max: [x1[i], y1[i], z1[i]].into() };
    let used = x.iter().take_while(|&&x| x < f32::INFINITY).count();
    (0..used).map(move |i| (lane(i), node.children[i]))
}
