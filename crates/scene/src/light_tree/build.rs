//! Building the tree from the top.

use super::LightTree;
use super::cluster::Cluster;
use super::node::{Link, Node};
use std::ops::Range;
use traylib_geometry::Aabb;

/// A path has a bit for each level.
const MAX_DEPTH: usize = u64::BITS as usize;

/// Intervals along each axis between which a split is looked for.
const BINS: usize = 16;

/// A tree over clusters of one lamp each; there must be one.
pub(super) fn tree(lamps: &[Cluster]) -> LightTree {
    let root = Node::new(&lamps[0], Link::Lamp(0));
    let mut builder = Builder {
        lamps,
        order: (0..lamps.len() as u32).collect(),
        tree: LightTree { nodes: vec![root], paths: vec![0; lamps.len()] },
    };
    builder.fill(0, 0..lamps.len(), 0, 0);
    builder.tree
}

struct Builder<'a> {
    lamps: &'a [Cluster],
    /// Lamps; every node owns a range.
    order: Vec<u32>,
    tree: LightTree,
}

impl Builder<'_> {
    /// Makes the node at `index` that of a range, and all below it. `path` leads
    /// there in `depth` turns.
    fn fill(&mut self, index: usize, range: Range<usize>, path: u64, depth: usize) -> Cluster {
        if range.len() == 1 {
            let lamp = self.order[range.start];
            self.tree.paths[lamp as usize] = path;
            let cluster = self.lamps[lamp as usize];
            self.tree.nodes[index] = Node::new(&cluster, Link::Lamp(lamp));
            return cluster;
        }
        let middle = self.split(range.clone(), depth);
        let pair = self.tree.nodes.len();
        // Kept free, so that the two lie side by side.
        self.tree.nodes.extend([self.tree.nodes[index]; 2]);
        let left = self.fill(pair, range.start..middle, path, depth + 1);
        let right = self.fill(pair + 1, middle..range.end, path | 1 << depth, depth + 1);
        let cluster = left.join(right);
        self.tree.nodes[index] = Node::new(&cluster, Link::Pair(pair as u32));
        cluster
    }

    /// Reorders a range of two or more lamps; returns where its second half
    /// begins. Lamps in one place are halved as they come, and so are all where
    /// levels run short: halving needs as many as the count has bits.
    fn split(&mut self, range: Range<usize>, depth: usize) -> usize {
        let levels_needed = range.len().next_power_of_two().ilog2() as usize;
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
        let along = |axis| cheapest_along(Grid::new(&centres, axis)?, lamps());
        let planes = (0..3).filter_map(along);
        planes.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, plane)| plane)
    }
}

/// Equal intervals between the least and the greatest centre along an axis.
#[derive(Clone, Copy)]
struct Grid {
    axis: usize,
    start: f32,
    bins_per_length: f32,
}

/// Between two intervals: what lies in `bin` or beyond goes right.
struct Plane {
    grid: Grid,
    bin: usize,
}

impl Grid {
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
        self.grid.bin(lamp) >= self.bin
    }
}

/// The plane of a grid with the least cost, and that cost. The first and the last
/// interval hold a lamp each, so neither side is empty.
fn cheapest_along<'a>(
    grid: Grid,
    lamps: impl Iterator<Item = &'a Cluster>,
) -> Option<(f64, Plane)> {
    let mut bins = [None; BINS];
    for lamp in lamps {
        let bin = &mut bins[grid.bin(lamp)];
        *bin = join(*bin, Some(*lamp));
    }
    let left = costs(bins.iter());
    let right = costs(bins.iter().rev());
    let cost = |bin: usize| left[bin - 1] + right[BINS - 1 - bin];
    let bin = (1..BINS).min_by(|&i, &j| cost(i).total_cmp(&cost(j)))?;
    Some((cost(bin), Plane { grid, bin }))
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
