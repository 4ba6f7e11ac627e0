//! The rays of a fan side by side.

use crate::tree::eights::{ALL, EIGHT, Eights, Numbers, Single};
use crate::{Ray, Vec3, watertight};
use std::array::from_fn;

/// Rays in a fan.
pub(super) const FAN: usize = EIGHT;

/// The least cosine between the first ray of a fan and the last.
const NARROW: f32 = 0.99;

/// Rays that can be traced, of one origin and octant, with the same longest coordinate.
#[derive(Clone, Copy)]
pub(super) struct Rays<E: Eights> {
    pub(super) eights: E,
    pub(super) origin: Vec3,
    /// By axis.
    pub(super) directions: [E::Single; 3],
    /// One bit for each axis along which they go backward.
    pub(super) octant: usize,
    /// As [`watertight::axes`] has them, for all rays.
    pub(super) axes: [usize; 3],
}

impl<E: Eights> Rays<E> {
    /// The rays, if they make a fan.
    #[inline(always)]
    pub(super) fn of(eights: E, rays: &[Ray]) -> Option<Self> {
        let rays: &[Ray; FAN] = rays.try_into().ok()?;
        let (first, last) = (&rays[0], &rays[FAN - 1]);
        // Most rays are told by the first and the last.
        if first.origin != last.origin || !is_narrow(first, last) || !start_together(rays) {
            return None;
        }
        let direction = |axis: usize| eights.load(from_fn(|i| rays[i].direction[axis]));
        let directions = [direction(0), direction(1), direction(2)];
        let limits = eights.load(from_fn(|i| rays[i].t_max));
        let signs = [directions[0].signs(), directions[1].signs(), directions[2].signs()];
        let axes = watertight::axes(&first.direction);
        let this = Self {
            eights,
            origin: first.origin,
            directions,
            octant: (0..3).map(|axis| (signs[axis] as usize & 1) << axis).sum(),
            axes,
        };
        let is_one_way = signs.iter().all(|&signs| signs == 0 || signs == ALL);
        let can_all_ask = eights.splat(0.0).below(limits) == ALL && first.is_traceable();
        (is_one_way && can_all_ask && this.have_length()).then_some(this)
    }

    /// Whether all directions are some, and the same coordinate is the longest of each.
    #[inline(always)]
    fn have_length(&self) -> bool {
        let size = |i: usize| self.directions[self.axes[i] % 3].abs();
        let [x, y, longest] = [size(0), size(1), size(2)];
        let size = x + y + longest;
        let are_directions = self.eights.splat(Ray::SMALLEST).at_most(size)
            & size.below(self.eights.splat(f32::INFINITY));
        are_directions & x.below(longest) & y.below(longest) == ALL
    }
}

#[inline(always)]
fn is_narrow(first: &Ray, last: &Ray) -> bool {
    let (along, aside) = (first.direction, last.direction);
    let lengths = along.length_squared() * aside.length_squared();
    along.dot(aside) > NARROW * lengths.sqrt()
}

/// Whether all have the same origin, to the bit.
#[inline(always)]
fn start_together(rays: &[Ray; FAN]) -> bool {
    let mut differing = 0;
    for ray in rays {
        for axis in 0..3 {
            differing |= ray.origin[axis].to_bits() ^ rays[0].origin[axis].to_bits();
        }
    }
    differing == 0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tree::eights::Portable;

    fn side_by_side() -> [Ray; FAN] {
        from_fn(|i| Ray::new(Vec3::ONE, Vec3::new(1.0, -0.01 * i as f32 - 0.01, 0.0)))
    }

    fn is_fan(rays: &[Ray]) -> bool {
        Rays::of(Portable, rays).is_some()
    }

    #[test]
    fn rays_side_by_side_make_a_fan() {
        assert!(is_fan(&side_by_side()));
        assert!(!is_fan(&side_by_side()[1..]));
        let spoil = [
            |ray: &mut Ray| ray.origin.x = 1.5,
            |ray: &mut Ray| ray.direction.y = 0.01,
            |ray: &mut Ray| ray.direction = Vec3::ZERO,
            |ray: &mut Ray| ray.direction.x = f32::NAN,
            |ray: &mut Ray| ray.direction.x = f32::INFINITY,
            |ray: &mut Ray| ray.direction.y = -1.1,
            |ray: &mut Ray| ray.t_max = f32::NAN,
        ];
        for spoil in spoil {
            for i in 0..FAN {
                let mut rays = side_by_side();
                spoil(&mut rays[i]);
                assert!(!is_fan(&rays), "{:?}", rays[i]);
            }
        }
        let mut wide = side_by_side();
        wide[FAN - 1].direction.y = -0.2;
        assert!(!is_fan(&wide));
    }
}
