//! The rays of a packet side by side.

use crate::tree::simd::{ALL, F32x8, Float, PACKET, Simd};
use crate::{Ray, Vec3, watertight};
use std::array::from_fn;

/// The least cosine between the first ray of a packet and the last.
const NARROW: f32 = 0.99;

/// The rays of a packet: of one origin and octant, with the same longest coordinate.
#[derive(Clone, Copy)]
pub(crate) struct Rays<E: Simd> {
    pub(crate) simd: E,
    pub(crate) origin: Vec3,
    /// The directions by axis.
    pub(crate) directions: [E::F32x8; 3],
    /// For each axis 1 if they go backward along it.
    pub(crate) backward: [usize; 3],
    /// The axes in the order of [`watertight::axes`].
    pub(crate) axes: [usize; 3],
}

impl<E: Simd> Rays<E> {
    #[inline(always)]
    pub(crate) fn of(simd: E, rays: &[Ray; PACKET]) -> Self {
        let direction = |axis: usize| simd.load(from_fn(|i| rays[i].direction[axis]));
        let backward = |axis: usize| usize::from(rays[0].direction[axis].is_sign_negative());
        Self {
            simd,
            origin: rays[0].origin,
            directions: [direction(0), direction(1), direction(2)],
            backward: [backward(0), backward(1), backward(2)],
            axes: watertight::axes(&rays[0].direction),
        }
    }

    /// Tells whether all directions are some, of one octant, and have the same longest coordinate.
    #[inline(always)]
    fn go_together(&self) -> bool {
        let [x, y, z] = self.directions;
        let is_one_way = [x.signs(), y.signs(), z.signs()].iter().all(|&s| s == 0 || s == ALL);
        let size = |i: usize| self.directions[self.axes[i]].abs();
        let (aside, across, along) = (size(0), size(1), size(2));
        let sum = aside + across + along;
        let are_directions =
            self.simd.splat(Ray::SMALLEST).at_most(sum) & sum.below(self.simd.splat(f32::INFINITY));
        is_one_way && are_directions & aside.below(along) & across.below(along) == ALL
    }
}

/// The rays, if they make a packet and all can be traced.
#[inline(always)]
pub(crate) fn packet<E: Simd>(simd: E, rays: &[Ray]) -> Option<&[Ray; PACKET]> {
    let rays: &[Ray; PACKET] = rays.try_into().ok()?;
    let (first, last) = (&rays[0], &rays[PACKET - 1]);
    // Most rays are told by the first and the last.
    let is_packet = first.origin == last.origin
        && is_narrow(first, last)
        && start_together(rays)
        && first.is_traceable()
        && simd.splat(0.0).below(simd.load(from_fn(|i| rays[i].t_max))) == ALL
        && Rays::of(simd, rays).go_together();
    is_packet.then_some(rays)
}

#[inline(always)]
fn is_narrow(first: &Ray, last: &Ray) -> bool {
    let (along, aside) = (first.direction, last.direction);
    let lengths = along.length_squared() * aside.length_squared();
    along.dot(aside) > NARROW * lengths.sqrt()
}

/// Tells whether all have the same origin, to the bit.
#[inline(always)]
fn start_together(rays: &[Ray; PACKET]) -> bool {
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
    use crate::tree::simd::Portable;

    fn side_by_side() -> [Ray; PACKET] {
        from_fn(|i| Ray::new(Vec3::ONE, Vec3::new(1.0, -0.01 * i as f32 - 0.01, 0.0)))
    }

    fn is_packet(rays: &[Ray]) -> bool {
        packet(Portable, rays).is_some()
    }

    #[test]
    fn rays_side_by_side_make_a_packet() {
        assert!(is_packet(&side_by_side()));
        assert!(!is_packet(&side_by_side()[1..]));
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
            for i in 0..PACKET {
                let mut rays = side_by_side();
                spoil(&mut rays[i]);
                assert!(!is_packet(&rays), "{:?}", rays[i]);
            }
        }
        let mut wide = side_by_side();
        wide[PACKET - 1].direction.y = -0.2;
        assert!(!is_packet(&wide));
    }
}
