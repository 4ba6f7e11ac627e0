//! Which rays make a fan.

use super::FAN;
use crate::Ray;

/// The least cosine between the first ray of a fan and the last.
const NARROW: f32 = 0.99;

/// The rays, if they make a fan: rays that can be traced, of one origin and octant and not
/// far apart.
#[inline(always)]
pub(super) fn fan(rays: &[Ray]) -> Option<&[Ray; FAN]> {
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
    let (mut differing, mut turned, mut all_ask) = (0, 0, true);
    // How far above the smallest direction, in bits; wraps for those below, and is great for
    // what is not a number.
    let mut greatest = 0;
    for ray in rays {
        for axis in 0..3 {
            differing |= ray.origin[axis].to_bits() ^ first.origin[axis].to_bits();
            turned |= ray.direction[axis].to_bits() ^ first.direction[axis].to_bits();
        }
        let size = ray.direction.abs().element_sum().to_bits();
        greatest = size.wrapping_sub(Ray::SMALLEST.to_bits()).max(greatest);
        all_ask &= ray.t_max > 0.0;
    }
    let are_directions = greatest < f32::INFINITY.to_bits() - Ray::SMALLEST.to_bits();
    differing == 0 && turned >> 31 == 0 && are_directions && all_ask && first.is_traceable()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vec3;
    use std::array::from_fn;

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
