//! Streams of random numbers.

use crate::Vec2;
use rand_core::Rng;
use rand_pcg::Pcg32;

/// One stream of uniform random numbers: PCG-XSH-RR 64/32.
///
/// Work that can be done in any order has a stream of its own, so a result depends neither on the
/// number of threads nor on their order.
#[derive(Clone, Debug)]
pub struct Sampler(Pcg32);

impl Sampler {
    /// The first part of the number of every stream for tests and measurements; what
    /// makes results takes others.
    pub const TESTS: u64 = 2;

    /// The stream of this seed with this number, whose first part says what it is for.
    ///
    /// Start and increment of the generator are both hashed from seed and number:
    /// neighbouring streams of PCG are correlated, as its documentation warns.
    pub fn new(seed: u64, number: [u64; 3]) -> Self {
        let hash = hash(seed, number);
        Self(Pcg32::new(hash, mix(hash)))
    }

    /// A stream for tests and measurements: the one with the number
    /// [[`TESTS`](Self::TESTS), 0, `number`].
    pub fn numbered(seed: u64, number: u64) -> Self {
        Self::new(seed, [Self::TESTS, 0, number])
    }

    /// A number uniform on [0, 1), a multiple of 2⁻²⁴.
    #[inline]
    pub fn next_1d(&mut self) -> f32 {
        unit(self.0.next_u32())
    }

    /// A number uniform on [0, 1), a multiple of 2⁻³²: what
    /// [`next_1d`](Self::next_1d) would have given, with eight bits more.
    #[inline]
    pub fn next_fine(&mut self) -> f64 {
        fine_unit(self.0.next_u32())
    }

    /// A point uniform on the unit square.
    #[inline]
    pub fn next_2d(&mut self) -> Vec2 {
        let x = self.next_1d();
        Vec2::new(x, self.next_1d())
    }

    /// A point uniform in the unit cube.
    #[inline]
    pub fn next_3d(&mut self) -> [f32; 3] {
        [self.next_1d(), self.next_1d(), self.next_1d()]
    }
}

/// A number on [0, 1) of random bits, a multiple of 2⁻²⁴: the highest that an `f32` holds.
#[inline]
#[must_use]
pub fn unit(bits: u32) -> f32 {
    (bits >> 8) as f32 * (1.0 / (1 << 24) as f32)
}

/// A number on [0, 1) of random bits, a multiple of 2⁻³²: all of them.
#[inline]
#[must_use]
pub fn fine_unit(bits: u32) -> f64 {
    f64::from(bits) * (1.0 / (1_u64 << 32) as f64)
}

/// Sixty-four bits of a seed and a number of three parts, any of whose bits moves all.
#[must_use]
pub fn hash(seed: u64, number: [u64; 3]) -> u64 {
    number.iter().fold(mix(seed ^ 0x9e37_79b9_7f4a_7c15), |hash, part| {
        mix(hash.wrapping_add(part.wrapping_mul(0xd134_2543_de82_ef95)).wrapping_add(1))
    })
}

/// A bijection of 64 bits in which every input bit moves every output bit:
/// the finaliser of `SplitMix64` (Steele, Lea and Flood 2014).
#[inline]
#[must_use]
pub const fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stream_repeats_and_its_neighbours_differ() {
        let draw = |seed, number| Sampler::new(seed, number).next_1d();
        let one = draw(1, [0, 2, 3]);
        assert_eq!(one, draw(1, [0, 2, 3]));
        assert_ne!(one, draw(2, [0, 2, 3]));
        assert_ne!(one, draw(1, [1, 2, 3]));
        assert_ne!(one, draw(1, [0, 3, 2]));
    }

    /// Pairs of the same draw from neighbouring streams fill a 16 × 16 grid
    /// evenly: chi-square with 255 degrees of freedom, 99.99 % quantile 347.7.
    #[test]
    fn neighbouring_streams_are_unrelated() {
        const STREAMS: u64 = 200_000;
        for draws_before in 0..3 {
            let value = |index| {
                let mut sampler = Sampler::numbered(7, index);
                for _ in 0..draws_before {
                    sampler.next_1d();
                }
                (sampler.next_1d() * 16.0) as usize
            };
            let mut counts = [[0_u32; 16]; 16];
            for i in 0..STREAMS {
                counts[value(2 * i)][value(2 * i + 1)] += 1;
            }
            let expected = STREAMS as f64 / 256.0;
            let chi_square: f64 = counts
                .iter()
                .flatten()
                .map(|&n| (f64::from(n) - expected).powi(2) / expected)
                .sum();
            assert!(chi_square < 347.7, "draw {draws_before}: {chi_square}");
        }
    }

    #[test]
    fn fine_numbers_have_more_bits_of_the_same_draw() {
        let mut coarse = Sampler::numbered(3, 0);
        let mut fine = coarse.clone();
        for _ in 0..1000 {
            let (x, y) = (f64::from(coarse.next_1d()), fine.next_fine());
            assert!(x <= y && y - x < 2_f64.powi(-24) && y < 1.0, "{x} {y}");
            assert_eq!((y * 2_f64.powi(32)).fract(), 0.0);
        }
    }

    #[test]
    fn numbers_stay_below_one_and_have_the_right_mean() {
        let mut sampler = Sampler::numbered(0, 0);
        let n = 100_000;
        let mut sum = 0.0;
        for _ in 0..n {
            let u = sampler.next_1d();
            assert!((0.0..1.0).contains(&u));
            sum += f64::from(u);
        }
        // Five standard errors of a uniform mean.
        assert!((sum / f64::from(n) - 0.5).abs() < 5.0 * (1.0 / 12.0_f64 / f64::from(n)).sqrt());
    }
}
