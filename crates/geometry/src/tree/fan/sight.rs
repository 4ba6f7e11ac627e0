//! A fan before triangles.

use super::rays::Rays;
use crate::tree::block::Block;
use crate::tree::eights::{Double, EIGHT, Eights, Numbers, Single};
use crate::tree::lanes::{FARTHER, Hits, greater, lesser};
use crate::tree::node::LEAF;
use crate::tree::sizes::{ROUNDING, Sizes};

/// A fan as triangles see it; the longest coordinate comes last.
#[derive(Clone, Copy)]
pub(crate) struct Sight<E: Eights> {
    eights: E,
    axes: [usize; 3],
    origin: [f32; 3],
    direction: [E::Single; 3],
    /// How fast the rays move along the two that stay.
    slope: [E::Single; 2],
    /// From depth to t.
    reciprocal: E::Single,
    /// From depth to how far it is ahead: 1 or −1.
    ahead: f32,
    sizes: Sizes,
}

/// A triangle as each ray sees it: see [`Flat`](crate::coarse::Flat).
struct Seen<S> {
    edges: [S; 3],
    /// Along the longest coordinate, the same for all.
    depths: [f32; 3],
}

type DoubleOf<E> = <<E as Eights>::Single as Single>::Double;

/// A corner as each ray sees it: see [`watertight`](crate::watertight).
#[derive(Clone, Copy)]
struct Corner<D> {
    place: [D; 2],
    depth: D,
}

impl<E: Eights> Sight<E> {
    #[inline(always)]
    pub(super) fn of(rays: &Rays<E>, sizes: Sizes) -> Self {
        let axes = rays.axes;
        let direction = [0, 1, 2].map(|i| rays.directions[axes[i] % 3]);
        let reciprocal = direction[2].reciprocal();
        Self {
            eights: rays.eights,
            axes,
            origin: axes.map(|axis| rays.origin[axis]),
            direction,
            slope: [direction[0] * reciprocal, direction[1] * reciprocal],
            reciprocal,
            ahead: if rays.octant >> axes[2] & 1 == 0 { 1.0 } else { -1.0 },
            sizes,
        }
    }

    /// For each triangle of a block those rays that may meet it at 0 < t < their limit, one
    /// bit each, and perhaps others: [`meet`](Self::meet) has the last word.
    #[inline(always)]
    pub(crate) fn candidates(&self, block: &Block, limits: &[f32; EIGHT]) -> [u32; LEAF] {
        let limits = self.eights.load(*limits) * self.eights.splat(FARTHER);
        let mut candidates = [0; LEAF];
        for (lane, candidates) in candidates.iter_mut().enumerate() {
            *candidates = self.candidates_of(block, lane, limits);
        }
        candidates
    }

    #[inline(always)]
    fn candidates_of(&self, block: &Block, lane: usize, limits: E::Single) -> u32 {
        let Seen { edges, depths } = self.see(block, lane, E::Single::minus_about);
        let [a, b, c] = depths.map(|depth| depth * self.ahead);
        let (nearest, farthest) = (lesser(lesser(a, b), c), greater(greater(a, b), c));
        let doubt = self.eights.splat(doubt(self.sizes.size(block.words[lane]), farthest));
        // Products may vanish that are not zero; what is not a number stays in doubt.
        let nothing = self.eights.splat(-f32::MIN_POSITIVE);
        let outside = (E::Single::least(edges) + doubt).below(nothing)
            & (doubt - E::Single::greatest(edges)).below(nothing);
        let reached = (self.eights.splat(nearest) * self.reciprocal.abs()).below(limits);
        if farthest > 0.0 { reached & !outside } else { 0 }
    }

    /// [`Flat::meet`](crate::coarse::Flat::meet) for each ray that has a bit and a triangle of
    /// a block; and those rays that pass it where rounding decides.
    #[inline(always)]
    pub(crate) fn meet_fast(
        &self,
        block: &Block,
        lane: usize,
        active: u32,
        limits: &[f32; EIGHT],
    ) -> Option<(Hits<EIGHT>, u32)> {
        let Seen { edges, depths } = self.see(block, lane, E::Single::minus_product);
        let [of_a, of_b, of_c] = edges;
        let (zero, limits) = (self.eights.splat(0.0), self.eights.load(*limits));
        let [a, b, c] = depths.map(|depth| self.eights.splat(depth));
        let depths = [a * self.reciprocal, b * self.reciprocal, c * self.reciprocal];
        let (first, last) = (E::Single::least(depths), E::Single::greatest(depths));
        let (least, greatest) = (E::Single::least(edges), E::Single::greatest(edges));
        let inside = zero.at_most(least) | greatest.at_most(zero);
        let passed = inside & zero.below(last) & first.below(limits) & active;
        if passed == 0 {
            return None;
        }
        let settled = zero.below(least) | greatest.below(zero);
        let reciprocal = (of_a + of_b + of_c).reciprocal();
        let sum = of_a * depths[0] + of_b * depths[1] + of_c * depths[2];
        // Between the nearest corner and the farthest; what is not a number stays.
        let t = last.lesser(first.greater(sum * reciprocal));
        let counts = zero.below(t) & t.below(limits);
        let hits = Hits {
            mask: passed & settled & counts,
            t: t.to_array(),
            u: (of_b * reciprocal).to_array(),
            v: (of_c * reciprocal).to_array(),
        };
        Some((hits, passed & !settled))
    }

    #[inline(always)]
    fn see(
        &self,
        block: &Block,
        lane: usize,
        minus_product: impl Fn(E::Single, E::Single, E::Single) -> E::Single,
    ) -> Seen<E::Single> {
        let corners @ [a, b, c] = block.picked(lane, self.axes);
        let a = self.place(a, &minus_product);
        let b = self.place(b, &minus_product);
        let c = self.place(c, &minus_product);
        let cross = |p: [E::Single; 2], q: [E::Single; 2]| minus_product(p[0] * q[1], p[1], q[0]);
        let edges = [cross(b, c), cross(c, a), cross(a, b)];
        Seen { edges, depths: corners.map(|corner| corner[2] - self.origin[2]) }
    }

    /// Where rays have a corner, in single precision.
    #[inline(always)]
    fn place(
        &self,
        corner: [f32; 3],
        minus_product: impl Fn(E::Single, E::Single, E::Single) -> E::Single,
    ) -> [E::Single; 2] {
        let [x, y, depth] = [0, 1, 2].map(|i| corner[i] - self.origin[i]);
        let (x, y, depth) = (self.eights.splat(x), self.eights.splat(y), self.eights.splat(depth));
        [minus_product(x, self.slope[0], depth), minus_product(y, self.slope[1], depth)]
    }

    /// [`watertight::meet`] for each ray that has a bit and a triangle of a block; `None`
    /// where rounding decides.
    #[inline(always)]
    pub(crate) fn meet(
        &self,
        block: &Block,
        lane: usize,
        candidates: u32,
        limits: &[f32; EIGHT],
    ) -> Option<Hits<EIGHT>> {
        let [x, y, longest] = self.direction;
        let direction = [x.widen(), y.widen(), longest.widen()];
        let [a, b, c] = block.picked(lane, self.axes);
        let (a, b, c) =
            (self.corner(a, direction), self.corner(b, direction), self.corner(c, direction));
        let edges @ [of_a, of_b, of_c] = [b.cross(c), c.cross(a), a.cross(b)];
        let zero = self.eights.splat_double(0.0);
        let (least, greatest) = (Numbers::least(edges), Numbers::greatest(edges));
        let inside = zero.below(least) | greatest.below(zero);
        let outside = least.below(zero) & zero.below(greatest);
        if (inside | outside) & candidates != candidates {
            return None;
        }
        let scale = self.eights.splat_double(1.0) / ((of_a + of_b + of_c) * direction[2]);
        let t = ((of_a * a.depth + of_b * b.depth + of_c * c.depth) * scale).narrow();
        let share = scale * direction[2];
        let counts = self.eights.splat(0.0).below(t) & t.below(self.eights.load(*limits));
        Some(Hits {
            mask: inside & counts & candidates,
            t: t.to_array(),
            u: (of_b * share).narrow().to_array(),
            v: (of_c * share).narrow().to_array(),
        })
    }

    /// How rays see a corner, in double precision.
    #[inline(always)]
    fn corner(&self, corner: [f32; 3], direction: [DoubleOf<E>; 3]) -> Corner<DoubleOf<E>> {
        let [x, y, depth] = [0, 1, 2].map(|i| f64::from(corner[i]) - f64::from(self.origin[i]));
        let x = self.eights.splat_double(x);
        let y = self.eights.splat_double(y);
        let depth = self.eights.splat_double(depth);
        let place =
            [x * direction[2] - direction[0] * depth, y * direction[2] - direction[1] * depth];
        Corner { place, depth }
    }
}

impl<D: Double> Corner<D> {
    /// Twice the area between a ray, this corner and the next.
    #[inline(always)]
    fn cross(self, next: Self) -> D {
        self.place[0] * next.place[1] - self.place[1] * next.place[0]
    }
}

/// How far an edge function of a triangle may be off by rounding: of what a ray sees, see
/// [`candidates`](crate::tree::lanes::Triangles::candidates).
#[inline(always)]
fn doubt(size: f32, depth: f32) -> f32 {
    let by_depth = 48.0 * ROUNDING * depth;
    (size + by_depth) * (96.0 * ROUNDING * size + by_depth)
}
