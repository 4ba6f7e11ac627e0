//! Building the tree from the top.

use super::cluster::Cluster;
use super::node::{Link, Node};
use super::{LightTree, TURN_BITS};
use std::ops::Range;
use traylib_geometry::Aabb;

/// Each halving of a range has a bit of a path.
const MAX_DEPTH: u32 = u64::BITS;

/// Intervals along each axis between which a split is looked for.
const BINS: usize = 16;

/// A tree over clusters of one lamp each. Without any it has no node, and nothing to choose.
pub(super) fn tree(lamps: &[Cluster]) -> LightTree {
    let mut builder = Builder {
        lamps,
        order: (0..lamps.len() as u32).collect(),
        tree: LightTree { root: Link::Lamp(0), nodes: Vec::new(), paths: vec![0; lamps.len()] },
    };
    if lamps.is_empty() {
        return builder.tree;
    }
    let (_, root) = builder.child(0..lamps.len(), 0, 0);
    LightTree { root, ..builder.tree }
}

struct Builder<'a> {
    lamps: &'a [Cluster],
    /// Lamps; every child owns a range.
    order: Vec<u32>,
    tree: LightTree,
}

impl Builder<'_> {
    /// Adds the node of a range after all below it; returns all its lamps and where it is.
    /// `path` leads there in `level` turns.
    fn add(&mut self, range: Range<usize>, path: u64, level: u32) -> (Cluster, Link) {
        let parts = self.parts(range, level);
        let turns = (0..).map(|turn| path | turn << (TURN_BITS * level));
        let children: Vec<_> = parts
            .into_iter()
            .zip(turns)
            .map(|(part, path)| self.child(part, path, level + 1))
            .collect();
        let all = children[1..].iter().fold(children[0].0, |all, child| all.join(child.0));
        self.tree.nodes.push(Node::new(&children));
        (all, Link::Node(self.tree.nodes.len() as u32 - 1))
    }

    /// Returns the link that stands for a range: one lamp, or a node at this level.
    fn child(&mut self, range: Range<usize>, path: u64, level: u32) -> (Cluster, Link) {
        if range.len() > 1 {
            return self.add(range, path, level);
        }
        let lamp = self.order[range.start];
        self.tree.paths[lamp as usize] = path;
        (self.lamps[lamp as usize], Link::Lamp(lamp))
    }

    /// As many parts of a range as a node has children at most: its halves, and theirs.
    fn parts(&mut self, range: Range<usize>, level: u32) -> Vec<Range<usize>> {
        let mut parts = vec![range];
        for halving in 0..TURN_BITS {
            let depth = TURN_BITS * level + halving;
            parts = parts.into_iter().flat_map(|part| self.halves(part, depth)).collect();
        }
        parts
    }

    /// The halves of a range of two or more lamps; else the range.
    fn halves(&mut self, range: Range<usize>, depth: u32) -> Vec<Range<usize>> {
        if range.len() == 1 {
            return vec![range];
        }
        let middle = self.split(range.clone(), depth);
        vec![range.start..middle, middle..range.end]
    }

    /// Reorders a range of two or more lamps; returns where its second half
    /// begins. Lamps in one place are halved as they come, and so are all where
    /// levels run short: halving needs as many as the count has bits.
    fn split(&mut self, range: Range<usize>, depth: u32) -> usize {
        let levels_needed = range.len().next_power_of_two().ilog2();
        let plane = (depth + levels_needed < MAX_DEPTH).then(|| self.best_plane(&range)).flatten();
        let Some(plane) = plane else { return range.start + range.len() / 2 };
        let lamps = self.lamps;
        let is_right = |lamp: &u32| plane.is_right(&lamps[*lamp as usize]);
        let slots = &mut self.order[range.clone()];
        // Stable: lamps keep the order they were added in.
        slots.sort_by_key(is_right);
        range.start + slots.partition_point(|lamp| !is_right(lamp))
    }

    /// The plane that leaves the least cost on both sides together.
    fn best_plane(&self, range: &Range<usize>) -> Option<Plane> {
        let lamps = || self.order[range.clone()].iter().map(|&lamp| &self.lamps[lamp as usize]);
        let centres = Aabb::around(lamps().map(|lamp| lamp.bounds.centre()));
        let along = |axis| cheapest_along(AxisBins::new(&centres, axis)?, lamps());
        let planes = (0..3).filter_map(along);
        planes.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, plane)| plane)
    }
}

/// Equal intervals between the least and the greatest centre along an axis.
#[derive(Clone, Copy)]
struct AxisBins {
    axis: usize,
    start: f32,
    bins_per_length: f32,
}

/// Between two intervals: what lies in `bin` or beyond goes right.
struct Plane {
    axis: AxisBins,
    bin: usize,
}

impl AxisBins {
    /// `None` if all centres are in one place.
    fn new(centres: &Aabb, axis: usize) -> Option<Self> {
        let length = centres.extent()[axis];
        let bins_per_length = BINS as f32 / length;
        let start = centres.min[axis];
        (length > 0.0 && bins_per_length.is_normal()).then_some(Self {
            axis,
            start,
            bins_per_length,
        })
    }

    fn bin(&self, lamp: &Cluster) -> usize {
        let from_start = lamp.bounds.centre()[self.axis] - self.start;
        ((from_start * self.bins_per_length) as usize).min(BINS - 1)
    }
}

impl Plane {
    fn is_right(&self, lamp: &Cluster) -> bool {
        self.axis.bin(lamp) >= self.bin
    }
}

/// The plane across an axis with the least cost, and that cost. The first and the last
/// interval hold a lamp each, so neither side is empty.
fn cheapest_along<'a>(
    axis: AxisBins,
    lamps: impl Iterator<Item = &'a Cluster>,
) -> Option<(f64, Plane)> {
    let mut bins = [None; BINS];
    for lamp in lamps {
        let bin = &mut bins[axis.bin(lamp)];
        *bin = join(*bin, Some(*lamp));
    }
    let left = costs(bins.iter());
    let right = costs(bins.iter().rev());
    let cost = |bin: usize| left[bin - 1] + right[BINS - 1 - bin];
    let bin = (1..BINS).min_by(|&i, &j| cost(i).total_cmp(&cost(j)))?;
    Some((cost(bin), Plane { axis, bin }))
}

/// The cost of the first interval, the first two, and so on.
fn costs<'a>(bins: impl Iterator<Item = &'a Option<Cluster>>) -> [f64; BINS] {
    let mut all = None;
    let mut costs = [0.0; BINS];
    for (cost, bin) in costs.iter_mut().zip(bins) {
        all = join(all, *bin);
        *cost = all.map_or(0.0, |all| all.cost());
    }
    costs
}

fn join(a: Option<Cluster>, b: Option<Cluster>) -> Option<Cluster> {
    a.zip(b).map(|(a, b)| a.join(b)).or(a).or(b)
}
