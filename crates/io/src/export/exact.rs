//! Numbers of which readers make exactly what is wanted.
//!
//! Readers make unit vectors of vectors, and cosines of angles, in single precision. What comes
//! out of a unit vector is another in its last digit as often as not; of some vector of another
//! length along it, it is the same.

use traylib_math::Vec3;

/// Lengths to try where a unit vector is made in single precision. Most are found by the first,
/// some by one in a thousand.
pub(super) const MANY: u32 = 20_000;
/// From one to the next.
const STEP: f32 = 0.000_37;
/// Numbers on either side of an angle that are tried.
const NEIGHBOURS: u32 = 200;

pub(super) fn same(a: Vec3, b: Vec3) -> bool {
    a.to_array().map(f32::to_bits) == b.to_array().map(f32::to_bits)
}

/// A vector along `wanted`, as long as `length` or somewhat longer, of which `make` makes
/// `wanted`; `wanted` at that length if there is none among so many.
pub(super) fn vector(
    wanted: Vec3,
    length: f32,
    tries: u32,
    make: impl Fn(Vec3) -> Option<Vec3>,
) -> Vec3 {
    let longer = |step: u32| wanted * (length * (1.0 + step as f32 * STEP));
    let fits = |v: &Vec3| make(*v).is_some_and(|made| same(made, wanted));
    (0..tries).map(longer).find(fits).unwrap_or(wanted * length)
}

/// A number next to `near` of which `make` makes `wanted`; `near` if there is none.
pub(super) fn number(wanted: f32, near: f32, make: impl Fn(f32) -> f32) -> f32 {
    let (mut above, mut below) = (near, near);
    for _ in 0..NEIGHBOURS {
        for tried in [above, below] {
            if make(tried).to_bits() == wanted.to_bits() {
                return tried;
            }
        }
        (above, below) = (above.next_up(), below.next_down());
    }
    near
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_math::Sampler;

    #[test]
    fn unit_vectors_are_found() {
        let mut sampler = Sampler::numbered(5, 0);
        for _ in 0..1000 {
            let mut next = || sampler.next_1d() * 2.0 - 1.0;
            let wanted = Vec3::new(next(), next(), next()).normalize();
            let make = |v: Vec3| v.try_normalize();
            let found = vector(wanted, 1.0, MANY, make);
            assert!(same(make(found).unwrap(), wanted), "{wanted}");
        }
    }

    #[test]
    fn angles_are_found() {
        let make = |degrees: f32| (0.5 * degrees).to_radians().cos();
        for degrees in [10.0_f32, 33.3, 40.0, 60.0] {
            let wanted = make(degrees);
            let near = 2.0 * wanted.acos().to_degrees();
            assert_eq!(make(number(wanted, near, make)).to_bits(), wanted.to_bits());
        }
    }
}
