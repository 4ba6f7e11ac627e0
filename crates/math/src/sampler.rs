//! Streams of random numbers.

use crate::Vec2;
use rand_core::Rng;
use rand_pcg::Pcg32;

/// What a stream of numbers is for: streams of different purposes never meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Camera paths, numbered by pixel.
    Camera,
    /// Light paths, numbered within the pass.
    Light,
    /// Tests and measurements.
    Test,
}

/// The numbers one path vertex may need, all uniform on [0, 1), in steps of 2⁻²⁴
/// but where said otherwise.
///
/// All are drawn at every vertex, used or not, so that switching a technique
/// off does not shift the numbers of the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexNumbers {
    /// Which of the surfaces that light can pass straight through the edge to
    /// this vertex ends at.
    pub pass_through: f32,
    /// Lobe, and two for the direction.
    pub bsdf: [f32; 3],
    /// Russian roulette.
    pub roulette: f32,
    /// Which light; in steps of 2⁻³², for lamps that are rarely chosen.
    pub light_pick: f64,
    /// Where on the light.
    pub light_point: Vec2,
}

/// One stream of uniform random numbers: PCG-XSH-RR 64/32.
///
/// A path has a stream of its own, numbered by seed, purpose, pass and index,
/// so a result depends neither on the number of threads nor on their order.
#[derive(Clone, Debug)]
pub struct Sampler(Pcg32);

impl Sampler {
    /// The stream with this number.
    ///
    /// Start and increment of the generator are both hashed from all four
    /// parts: neighbouring streams of PCG are correlated, as its documentation
    /// warns.
    pub fn new(seed: u64, purpose: Purpose, pass: u64, index: u64) -> Self {
        let mut hash = mix(seed ^ 0x9e37_79b9_7f4a_7c15);
        for part in [purpose as u64, pass, index] {
            hash = mix(hash.wrapping_add(part.wrapping_mul(0xd134_2543_de82_ef95)).wrapping_add(1));
        }
        Self(Pcg32::new(hash, mix(hash)))
    }

    /// A number uniform on [0, 1), a multiple of 2⁻²⁴.
    #[inline]
    pub fn next_1d(&mut self) -> f32 {
        (self.0.next_u32() >> 8) as f32 * (1.0 / (1 << 24) as f32)
    }

    /// A number uniform on [0, 1), a multiple of 2⁻³²: what
    /// [`next_1d`](Self::next_1d) would have given, with eight bits more.
    #[inline]
    pub fn next_fine(&mut self) -> f64 {
        f64::from(self.0.next_u32()) * (1.0 / (1_u64 << 32) as f64)
    }

    /// A point uniform on the unit square.
    #[inline]
    pub fn next_2d(&mut self) -> Vec2 {
        let x = self.next_1d();
        Vec2::new(x, self.next_1d())
    }

    /// The numbers of the next path vertex.
    #[inline]
    pub fn next_vertex(&mut self) -> VertexNumbers {
        VertexNumbers {
            pass_through: self.next_1d(),
            bsdf: [self.next_1d(), self.next_1d(), self.next_1d()],
            roulette: self.next_1d(),
            light_pick: self.next_fine(),
            light_point: self.next_2d(),
        }
    }
}

/// A bijection of 64 bits in which every input bit moves every output bit:
/// the finaliser of `SplitMix64` (Steele, Lea and Flood 2014).
fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stream_repeats_and_its_neighbours_differ() {
        let draw = |seed, purpose, pass, index| Sampler::new(seed, purpose, pass, index).next_1d();
        let one = draw(1, Purpose::Camera, 2, 3);
        assert_eq!(one, draw(1, Purpose::Camera, 2, 3));
        assert_ne!(one, draw(2, Purpose::Camera, 2, 3));
        assert_ne!(one, draw(1, Purpose::Light, 2, 3));
        assert_ne!(one, draw(1, Purpose::Camera, 3, 2));
    }

    /// Pairs of the same draw from neighbouring streams fill a 16 × 16 grid
    /// evenly: chi-square with 255 degrees of freedom, 99.99 % quantile 347.7.
    #[test]
    fn neighbouring_streams_are_unrelated() {
        const STREAMS: u64 = 200_000;
        for draws_before in 0..3 {
            let value = |index| {
                let mut sampler = Sampler::new(7, Purpose::Test, 0, index);
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
        let mut coarse = Sampler::new(3, Purpose::Test, 0, 0);
        let mut fine = coarse.clone();
        for _ in 0..1000 {
            let (x, y) = (f64::from(coarse.next_1d()), fine.next_fine());
            assert!(x <= y && y - x < 2_f64.powi(-24) && y < 1.0, "{x} {y}");
            assert_eq!((y * 2_f64.powi(32)).fract(), 0.0);
        }
    }

    #[test]
    fn numbers_stay_below_one_and_have_the_right_mean() {
        let mut sampler = Sampler::new(0, Purpose::Test, 0, 0);
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
