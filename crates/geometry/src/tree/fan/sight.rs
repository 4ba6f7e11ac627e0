//! A fan before triangles.

use super::rays::Rays;
use crate::tree::block::Block;
use crate::tree::eights::{Double, EIGHT, Eights, Four, Numbers, Single};
use crate::tree::lanes::{FARTHER, Hits};
use crate::tree::node::LEAF;
use crate::tree::sizes::{ROUNDING, Sizes};
use crate::tree::walk::ones;
use std::hint::black_box;

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

/// Coordinates of the corners of triangles: by corner, by axis, by triangle.
pub(crate) type Corners = [[[f32; LEAF]; 3]; 3];

/// Triangles as all rays see them.
struct Reach {
    /// From the origin, in the order of the axes.
    corners: Corners,
    /// Along the longest coordinate.
    nearest: [f32; LEAF],
    /// How far edge functions may be off by rounding.
    doubt: [f32; LEAF],
    /// One bit for each that is not behind.
    ahead: u32,
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
        let direction = [0, 1, 2].map(|i| rays.directions[axes[i]]);
        let reciprocal = direction[2].reciprocal();
        Self {
            eights: rays.eights,
            axes,
            origin: axes.map(|axis| rays.origin[axis]),
            direction,
            slope: [direction[0] * reciprocal, direction[1] * reciprocal],
            reciprocal,
            ahead: if rays.backward[axes[2]] == 0 { 1.0 } else { -1.0 },
            sizes,
        }
    }

    #[inline(always)]
    pub(super) fn eights(&self) -> E {
        self.eights
    }

    /// The triangles of a block that rays may meet at 0 < t < their limit: the place of each
    /// with one bit for each ray that has one in `active`. Perhaps others too:
    /// [`meet`](Self::meet) has the last word.
    #[inline(always)]
    pub(crate) fn candidates(
        &self,
        block: &Block,
        active: u32,
        limits: &[f32; EIGHT],
    ) -> impl Iterator<Item = (usize, u32)> + use<E> {
        // In memory, from where instructions take one number eight times.
        let reach = self.reach(block);
        let Reach { corners, nearest, doubt, ahead } = black_box(&reach);
        let limits = self.eights.load(*limits) * self.eights.splat(FARTHER);
        let mut all = 0;
        for lane in ones(*ahead) {
            let edges = self.edges(corners, lane % LEAF, E::Single::minus_about);
            let doubt = self.eights.splat(doubt[lane % LEAF]);
            let nearest = self.eights.splat(nearest[lane % LEAF]);
            // Products may vanish that are not zero; what is not a number stays in doubt.
            let nothing = self.eights.splat(-f32::MIN_POSITIVE);
            let outside = (E::Single::least(edges) + doubt).below(nothing)
                & (doubt - E::Single::greatest(edges)).below(nothing);
            let reached = (nearest * self.reciprocal.abs()).below(limits);
            all |= (reached & !outside & active) << (EIGHT * lane);
        }
        bytes(all)
    }

    #[inline(always)]
    fn reach(&self, block: &Block) -> Reach {
        let corners = self.relative(block);
        let ahead = self.eights.splat_four(self.ahead);
        let depths = [corners[0][2] * ahead, corners[1][2] * ahead, corners[2][2] * ahead];
        let farthest = E::Four::greatest(depths);
        let size = self.eights.load_four(block.words.map(|word| self.sizes.size(word)));
        Reach {
            corners: arrays(corners),
            nearest: E::Four::least(depths).to_array(),
            doubt: self.doubt(size, farthest).to_array(),
            ahead: self.eights.splat_four(0.0).below(farthest),
        }
    }

    /// How far edge functions of triangles may be off by rounding: of what a ray sees, see
    /// [`candidates`](crate::tree::lanes::Triangles::candidates).
    #[inline(always)]
    fn doubt(&self, size: E::Four, depth: E::Four) -> E::Four {
        let by_depth = depth * self.eights.splat_four(48.0 * ROUNDING);
        let by_size = size * self.eights.splat_four(96.0 * ROUNDING);
        (size + by_depth) * (by_size + by_depth)
    }

    /// The corners of triangles from the origin, in the order of the axes.
    #[inline(always)]
    fn relative(&self, block: &Block) -> [[E::Four; 3]; 3] {
        let corner = |corner: usize| {
            [self.row(block, corner, 0), self.row(block, corner, 1), self.row(block, corner, 2)]
        };
        [corner(0), corner(1), corner(2)]
    }

    #[inline(always)]
    fn row(&self, block: &Block, corner: usize, i: usize) -> E::Four {
        let row = block.corners[corner][self.axes[i]];
        self.eights.load_four(row) - self.eights.splat_four(self.origin[i])
    }

    /// The edge functions of a triangle for each ray: see [`Flat`](crate::coarse::Flat).
    #[inline(always)]
    fn edges(
        &self,
        corners: &Corners,
        lane: usize,
        minus_product: impl Fn(E::Single, E::Single, E::Single) -> E::Single,
    ) -> [E::Single; 3] {
        let a = self.place(&corners[0], lane, &minus_product);
        let b = self.place(&corners[1], lane, &minus_product);
        let c = self.place(&corners[2], lane, &minus_product);
        let cross = |p: [E::Single; 2], q: [E::Single; 2]| minus_product(p[0] * q[1], p[1], q[0]);
        [cross(b, c), cross(c, a), cross(a, b)]
    }

    /// Where rays have a corner, in single precision.
    #[inline(always)]
    fn place(
        &self,
        corner: &[[f32; LEAF]; 3],
        lane: usize,
        minus_product: impl Fn(E::Single, E::Single, E::Single) -> E::Single,
    ) -> [E::Single; 2] {
        let x = self.eights.splat(corner[0][lane]);
        let y = self.eights.splat(corner[1][lane]);
        let depth = self.eights.splat(corner[2][lane]);
        [minus_product(x, self.slope[0], depth), minus_product(y, self.slope[1], depth)]
    }

    /// The corners of triangles from the origin, in the order of the axes.
    #[inline(always)]
    pub(crate) fn corners(&self, block: &Block) -> Corners {
        arrays(self.relative(block))
    }

    /// [`Flat::meet`](crate::coarse::Flat::meet) for each ray that has a bit and a triangle of
    /// a block; and those rays that pass it where rounding decides.
    #[inline(always)]
    pub(crate) fn meet_fast(
        &self,
        corners: &Corners,
        lane: usize,
        active: u32,
        limits: &[f32; EIGHT],
    ) -> Option<(Hits<EIGHT>, u32)> {
        let edges = self.edges(corners, lane, E::Single::minus_product);
        let [of_a, of_b, of_c] = edges;
        let (zero, limits) = (self.eights.splat(0.0), self.eights.load(*limits));
        let a = self.eights.splat(corners[0][2][lane]) * self.reciprocal;
        let b = self.eights.splat(corners[1][2][lane]) * self.reciprocal;
        let c = self.eights.splat(corners[2][2][lane]) * self.reciprocal;
        let (first, last) = (E::Single::least([a, b, c]), E::Single::greatest([a, b, c]));
        let (least, greatest) = (E::Single::least(edges), E::Single::greatest(edges));
        let inside = zero.at_most(least) | greatest.at_most(zero);
        let passed = inside & zero.below(last) & first.below(limits) & active;
        if passed == 0 {
            return None;
        }
        let settled = zero.below(least) | greatest.below(zero);
        let reciprocal = (of_a + of_b + of_c).reciprocal();
        let sum = of_a * a + of_b * b + of_c * c;
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

/// The bytes of a number that are not zero, with their places.
#[inline(always)]
fn bytes(mut number: u32) -> impl Iterator<Item = (usize, u32)> {
    std::iter::from_fn(move || {
        let place = (number != 0).then(|| number.trailing_zeros() / u8::BITS)?;
        let byte = number >> (u8::BITS * place) & u32::from(u8::MAX);
        number ^= byte << (u8::BITS * place);
        Some((place as usize, byte))
    })
}

#[inline(always)]
fn arrays<F: Four>([a, b, c]: [[F; 3]; 3]) -> Corners {
    let rows = |[x, y, z]: [F; 3]| [x.to_array(), y.to_array(), z.to_array()];
    [rows(a), rows(b), rows(c)]
}
