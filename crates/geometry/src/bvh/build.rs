//! Building the tree.

use super::node::{Child, Node, WIDTH};
use crate::{Aabb, Vec3};
use std::ops::Range;

/// No tree has more levels than this; [`Child::MAX_SHAPES`] shapes need 28.
pub(super) const MAX_DEPTH: usize = 48;

/// Up to this many shapes are not split further. Leaves of four save a mesh of
/// 20 000 triangles a tenth and cost a box with a dozen shapes twice the time.
const LEAF: usize = 2;

/// Bins along each axis in which places to split are looked for.
const BINS: usize = 16;

pub(super) struct Tree {
    pub(super) nodes: Vec<Node>,
    pub(super) order: Vec<u32>,
    pub(super) root: Option<Child>,
    /// Levels of nodes.
    pub(super) depth: usize,
}

/// A tree over shapes with these bounds, which must be finite.
pub(super) fn tree(bounds: &[Aabb]) -> Tree {
    let wide: Vec<Aabb> = bounds.iter().map(widened).collect();
    let order = (0..bounds.len() as u32).collect();
    let mut builder = Builder { bounds: &wide, order, nodes: Vec::new(), depth: 0 };
    let root = (!bounds.is_empty()).then(|| builder.child(0..bounds.len(), 0));
    Tree { nodes: builder.nodes, order: builder.order, root, depth: builder.depth }
}

/// The box with room for the rounding of intersections, which is a few units in
/// the last place of the shape's size however near the ray starts.
fn widened(bounds: &Aabb) -> Aabb {
    let margin = bounds.extent().max_element() * (8.0 * f32::EPSILON);
    bounds.grown(Vec3::splat(margin))
}

struct Builder<'a> {
    bounds: &'a [Aabb],
    /// Shapes; every node and leaf owns a range.
    order: Vec<u32>,
    nodes: Vec<Node>,
    depth: usize,
}

impl Builder<'_> {
    /// The leaf or node over a range, `depth` nodes below the root.
    fn child(&mut self, range: Range<usize>, depth: usize) -> Child {
        if range.len() <= LEAF {
            return Child::leaf(range.start, range.len());
        }
        self.depth = self.depth.max(depth + 1);
        let index = self.nodes.len();
        // Kept free, so that nodes lie in the order they are reached.
        self.nodes.push(Node::new(&[]));
        let parts = self.parts(range, depth);
        let boxes: Vec<(Aabb, Child)> =
            parts.into_iter().map(|(part, bounds)| (bounds, self.child(part, depth + 1))).collect();
        self.nodes[index] = Node::new(&boxes);
        Child::node(index)
    }

    /// The range in up to four parts: the one that costs most is split as long
    /// as there is room.
    fn parts(&mut self, range: Range<usize>, depth: usize) -> Vec<(Range<usize>, Aabb)> {
        let mut parts = vec![(range.clone(), self.bounds_of(range))];
        while parts.len() < WIDTH {
            let cost = |part: &(Range<usize>, Aabb)| part.1.surface_area() * part.0.len() as f32;
            let splittable = (0..parts.len()).filter(|&i| parts[i].0.len() > 1);
            let Some(worst) =
                splittable.max_by(|&i, &j| cost(&parts[i]).total_cmp(&cost(&parts[j])))
            else {
                break;
            };
            let (part, _) = parts.swap_remove(worst);
            let middle = self.split(part.clone(), depth);
            for half in [part.start..middle, middle..part.end] {
                parts.push((half.clone(), self.bounds_of(half)));
            }
        }
        parts
    }

    fn bounds_of(&self, range: Range<usize>) -> Aabb {
        let boxes = self.order[range].iter().map(|&i| self.bounds[i as usize]);
        boxes.fold(Aabb::EMPTY, Aabb::union)
    }

    /// Reorders a range of two or more shapes; returns where its second half
    /// begins.
    ///
    /// Halving needs as many levels as the count has bits, so falling back to
    /// it in time keeps the depth within bounds, whatever the shapes.
    fn split(&mut self, range: Range<usize>, depth: usize) -> usize {
        let levels_needed = range.len().next_power_of_two().ilog2() as usize;
        if depth + levels_needed < MAX_DEPTH
            && let Some(middle) = self.split_by_cost(range.clone())
        {
            return middle;
        }
        self.split_in_half(range)
    }

    /// Splits where the sum of area times count is least, if centres differ.
    fn split_by_cost(&mut self, range: Range<usize>) -> Option<usize> {
        let bounds = self.bounds;
        let slots = &mut self.order[range.clone()];
        let centre = |i: u32| bounds[i as usize].centre();
        let centres = Aabb::around(slots.iter().map(|&i| centre(i)));
        let plane = (0..3).filter_map(|axis| best_plane(bounds, slots, &centres, axis));
        let best = plane.min_by(|a, b| a.cost.total_cmp(&b.cost))?;
        let is_left = |i: u32| best.grid.bin(centre(i)[best.grid.axis]) < best.bin;
        let left = partition(slots, is_left);
        (0 < left && left < range.len()).then_some(range.start + left)
    }

    /// Splits at the median of the centres along the longest axis.
    fn split_in_half(&mut self, range: Range<usize>) -> usize {
        let bounds = self.bounds;
        let slots = &mut self.order[range.clone()];
        let centre = |i: u32| bounds[i as usize].centre();
        let centres = Aabb::around(slots.iter().map(|&i| centre(i)));
        let axis = centres.extent().max_position();
        let half = slots.len() / 2;
        slots.select_nth_unstable_by(half, |&i, &j| centre(i)[axis].total_cmp(&centre(j)[axis]));
        range.start + half
    }
}

/// Equal intervals between the least and the greatest centre along an axis.
struct Grid {
    axis: usize,
    start: f32,
    bins_per_length: f32,
}

impl Grid {
    fn bin(&self, coordinate: f32) -> usize {
        (((coordinate - self.start) * self.bins_per_length) as usize).min(BINS - 1)
    }
}

/// A place to split: what lies in bins before `bin` goes left.
struct Plane {
    grid: Grid,
    bin: usize,
    cost: f32,
}

/// The cheapest plane across one axis; `None` if all centres are in one place.
fn best_plane(bounds: &[Aabb], shapes: &[u32], centres: &Aabb, axis: usize) -> Option<Plane> {
    let length = centres.extent()[axis];
    let bins_per_length = BINS as f32 / length;
    if length <= 0.0 || !bins_per_length.is_finite() {
        return None;
    }
    let grid = Grid { axis, start: centres.min[axis], bins_per_length };
    let mut bins = [(Aabb::EMPTY, 0_usize); BINS];
    for &i in shapes {
        let shape = bounds[i as usize];
        let (bin, count) = &mut bins[grid.bin(shape.centre()[axis])];
        *bin = bin.union(shape);
        *count += 1;
    }
    let left = costs(bins.iter());
    let right = costs(bins.iter().rev());
    let cost = |bin: usize| left[bin - 1] + right[BINS - 1 - bin];
    let bin = (1..BINS).min_by(|&i, &j| cost(i).total_cmp(&cost(j)))?;
    Some(Plane { cost: cost(bin), grid, bin })
}

/// Area times count of the first bin, the first two, and so on.
fn costs<'a>(bins: impl Iterator<Item = &'a (Aabb, usize)>) -> [f32; BINS] {
    let mut costs = [0.0; BINS];
    let mut sum = (Aabb::EMPTY, 0);
    for (cost, bin) in costs.iter_mut().zip(bins) {
        sum = (sum.0.union(bin.0), sum.1 + bin.1);
        *cost = sum.0.surface_area() * sum.1 as f32;
    }
    costs
}

/// Moves the shapes that go left to the front; returns how many there are.
fn partition(shapes: &mut [u32], is_left: impl Fn(u32) -> bool) -> usize {
    let mut left = 0;
    for i in 0..shapes.len() {
        if is_left(shapes[i]) {
            shapes.swap(i, left);
            left += 1;
        }
    }
    left
}
