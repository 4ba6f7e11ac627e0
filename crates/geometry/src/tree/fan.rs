//! Rays from one point that go almost the same way, as those of a camera do: they open
//! boxes together.

mod slopes;

use super::Tree;
use super::batch::Batch;
use super::lanes::{Lanes, Triangles, greater, lesser};
use super::node::{Child, Content};
use super::prefetch::Ahead;
use super::stack::{Room, Stack};
use super::walk::{Visitor, ones, visit};
use crate::Ray;
use slopes::Slopes;
use std::array::from_fn;
use std::ops::Range;

/// Rays in a fan.
const FAN: usize = 8;

/// The least cosine between the first ray of a fan and the last.
const NARROW: f32 = 0.99;

/// The rays, if they make a fan: rays that can be traced, of one origin and octant and not
/// far apart.
#[inline(always)]
fn fan(rays: &[Ray]) -> Option<&[Ray; FAN]> {
    let rays: &[Ray; FAN] = rays.try_into().ok()?;
    let (first, last) = (&rays[0], &rays[FAN - 1]);
    // Most rays are told by the first and the last.
    (first.origin == last.origin && is_narrow(first, last) && goes_together(rays)).then_some(rays)
}

#[inline(always)]
fn is_narrow(first: &Ray, last: &Ray) -> bool {
    let (along, aside) = (first.direction, last.direction);
    let lengths = along.length_squared() * aside.length_squared();
    along.dot(aside) > NARROW * lengths.sqrt()
}

#[inline(always)]
fn goes_together(rays: &[Ray; FAN]) -> bool {
    let first = &rays[0];
    let mut differing = 0;
    // Stays zero with numbers, and else is not a number.
    let mut nothing = 0.0;
    let (mut smallest, mut all_ask) = (f32::INFINITY, true);
    for ray in rays {
        for axis in 0..3 {
            differing |= ray.origin[axis].to_bits() ^ first.origin[axis].to_bits();
            let turned = ray.direction[axis].to_bits() ^ first.direction[axis].to_bits();
            differing |= turned & 1 << 31;
        }
        nothing += 0.0 * ray.direction.element_sum();
        smallest = lesser(ray.direction.abs().element_sum(), smallest);
        all_ask &= ray.t_max > 0.0;
    }
    differing == 0 && first.is_traceable() && nothing == 0.0 && smallest >= Ray::SMALLEST && all_ask
}

/// Takes all fans among the rays to their leaves. The places of the rays that are left.
#[inline(always)]
pub(crate) fn walk_fans<'a, L: Lanes, T: Triangles, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    lanes: impl Fn(&'a Ray) -> L,
    triangles: impl Fn(&'a Ray) -> T,
    batch: &mut B,
) -> Vec<Range<usize>> {
    let mut left: Vec<Range<usize>> = Vec::new();
    for (chunk, rays) in batch.rays().chunks(FAN).enumerate() {
        let places = FAN * chunk..FAN * chunk + rays.len();
        match fan(rays) {
            Some(rays) => walk_fan(tree, root, (&lanes, &triangles), batch, places.start, rays),
            None => match left.last_mut().filter(|last| last.end == places.start) {
                Some(last) => last.end = places.end,
                None => left.push(places),
            },
        }
    }
    left
}

/// Takes a fan, whose first ray has number `first`, to all leaves that its rays meet.
#[inline(always)]
fn walk_fan<'a, L: Lanes, T: Triangles, B: Batch<'a>>(
    tree: &Tree,
    root: Child,
    (lanes, triangles): (&impl Fn(&'a Ray) -> L, &impl Fn(&'a Ray) -> T),
    batch: &mut B,
    first: usize,
    rays: &'a [Ray; FAN],
) {
    let slopes = Slopes::of(rays);
    let [near, far] = slopes.widest();
    let all = lanes(&rays[0]).with_slopes(near, far);
    let ahead = Ahead::of(tree);
    let mut each = [triangles(&rays[0]); FAN];
    for (each, ray) in each.iter_mut().zip(rays).skip(1) {
        *each = triangles(ray);
    }
    let mut fan = Visitors::new(from_fn(|i| batch.begin(first + i)));
    let mut room = Room::new();
    let mut stack = Stack::new(&mut room);
    let mut next = Some((root, u32::MAX >> (32 - FAN)));
    loop {
        if let Some((child, active)) = next {
            match child.open() {
                Content::Node(index) => {
                    let names = Child::slots(index);
                    all.open(&tree.nodes[index], &names, fan.limit, &mut stack);
                }
                _ => fan.visit(tree, child, &each, active),
            }
            if let Some((node, lane)) = stack.top().map(Child::slot) {
                ahead.ask(tree.nodes[node].children[lane]);
            }
        }
        let Some((index, lane)) = stack.pop(fan.limit).map(Child::slot) else { break };
        let node = &tree.nodes[index];
        let active = slopes.meet(node, lane, &fan.limits);
        next = (active != 0).then(|| (node.children[lane], active));
    }
    for (i, visitor) in fan.each.iter().enumerate() {
        batch.end(first + i, visitor);
    }
}

/// What the rays of a fan do in leaves.
struct Visitors<V> {
    each: [V; FAN],
    /// Below zero once a ray asks nothing more.
    limits: [f32; FAN],
    /// The farthest of them.
    limit: f32,
}

impl<V: Visitor> Visitors<V> {
    #[inline(always)]
    fn new(visitors: [V; FAN]) -> Self {
        let limits = from_fn(|i| visitors[i].limit());
        let mut this = Self { each: visitors, limits, limit: 0.0 };
        this.see_limits();
        this
    }

    #[inline(always)]
    fn see_limits(&mut self) {
        self.limit = self.limits.iter().fold(-1.0, |farthest, &limit| greater(limit, farthest));
    }

    /// Takes the rays that have a bit to a leaf.
    #[inline(always)]
    fn visit<T: Triangles>(&mut self, tree: &Tree, leaf: Child, each: &[T; FAN], active: u32) {
        for i in ones(active) {
            let visitor = &mut self.each[i % FAN];
            let is_done = visit(tree, leaf, &each[i % FAN], visitor).is_break();
            self.limits[i % FAN] = if is_done { -1.0 } else { visitor.limit() };
        }
        self.see_limits();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vec3;

    fn side_by_side() -> [Ray; FAN] {
        from_fn(|i| Ray::new(Vec3::ONE, Vec3::new(1.0, -0.01 * i as f32 - 0.01, 0.0)))
    }

    #[test]
    fn rays_side_by_side_make_a_fan() {
        assert!(fan(&side_by_side()).is_some());
        assert!(fan(&side_by_side()[1..]).is_none());
        let spoil = [
            |ray: &mut Ray| ray.origin.x = 1.5,
            |ray: &mut Ray| ray.direction.y = 0.01,
            |ray: &mut Ray| ray.direction = Vec3::ZERO,
            |ray: &mut Ray| ray.direction.x = f32::NAN,
            |ray: &mut Ray| ray.direction.x = f32::INFINITY,
            |ray: &mut Ray| ray.t_max = f32::NAN,
        ];
        for spoil in spoil {
            for i in 0..FAN {
                let mut rays = side_by_side();
                spoil(&mut rays[i]);
                assert!(fan(&rays).is_none(), "{:?}", rays[i]);
            }
        }
        let mut wide = side_by_side();
        wide[FAN - 1].direction.y = -0.2;
        assert!(fan(&wide).is_none());
    }
}
