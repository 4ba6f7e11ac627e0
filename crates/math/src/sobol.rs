//! Points that fill the unit cube more evenly than random ones: Sobol's sequence, in pairs.
//!
//! Of Sobol's sequence the first two dimensions are as even as two can be: 2^k points that
//! begin at a multiple of 2^k have one in every cell of each grid of 2^a by 2^b, a + b = k.
//! Later ones are not: of his seventh and eighth 32 points err nearly as much as random ones.
//! So each pair of coordinates here is those two dimensions, and pairs differ in the number of
//! their point: its bits are multiplied by a triangular matrix of the pair's own, over the
//! field of two elements, which leaves each run of 2^k where it is but in another order
//! (Kollig, Keller, *Efficient multidimensional sampling*, Comput. Graph. Forum 21, 2002, whose
//! orders are random). The matrices were searched, so that pairs are even with one another too:
//! `examples/search_mixes.rs`.

use crate::sampler::mix;

/// Pairs of coordinates of a point.
pub const PAIRS: usize = 8;

/// The point with this number: each coordinate is a binary fraction of 32 bits.
#[inline]
#[must_use]
pub fn point(mut number: u64) -> [[u32; 2]; PAIRS] {
    let mut point = [[0; 2]; PAIRS];
    // Each bit of the number brings in one direction a coordinate.
    while number != 0 {
        let directions = &DIRECTIONS[number.trailing_zeros() as usize];
        for ([x, y], [by_x, by_y]) in point.iter_mut().zip(directions) {
            *x ^= by_x;
            *y ^= by_y;
        }
        number &= number - 1;
    }
    point
}

/// The part of a point in the error of a mean: (1 + 6φ(x))·(1 + 6φ(y)) − 1 for a pair of its
/// coordinates, binary fractions of 32 bits, with φ(x) = 1/6 − 2^(⌊log₂ x⌋ − 1) and φ(0) = 1/6.
///
/// Its mean over the first 2^k points is the expected squared error of the mean over them of what
/// a pair decides, the worst of smooth functions whose slopes have unit size, if all points are
/// shifted by the same random bits; a product of several pairs' is that of what they decide
/// together. Over as many random points it is 3/2^k a pair (Dick, Pillichshammer, *Multivariate
/// integration in weighted Hilbert spaces based on Walsh functions and weighted Sobolev spaces*,
/// J. Complexity 21, 2005).
#[must_use]
pub fn kernel(pair: [u32; 2]) -> f64 {
    // 32 bits of which the first so many are zeros are 2^(−1 − zeros) and more.
    let [x, y] = pair.map(|x| 2.0 - 1.5 * (-f64::from(x.leading_zeros())).exp2());
    x * y - 1.0
}

/// Columns of the matrices that were searched; runs of up to 2^20 points need no others.
pub const MIXED: usize = 20;

/// For each pair but the first, whose number is left as it is, the columns of its matrix: column
/// k has ones up to bit k alone, and one there.
#[expect(clippy::unreadable_literal, reason = "as the search prints them")]
const MIXES: [[u64; MIXED]; PAIRS - 1] = [
    [
        1, 2, 5, 13, 16, 51, 82, 164, 404, 521, 1468, 2795, 4413, 8418, 17648, 49355, 86943,
        217525, 367696, 616546,
    ],
    [
        1, 2, 4, 9, 31, 40, 125, 140, 323, 735, 1159, 4087, 5530, 13340, 22876, 42542, 93013,
        148336, 387055, 698843,
    ],
    [
        1, 2, 5, 10, 26, 35, 110, 166, 404, 737, 1751, 2084, 4841, 8846, 19407, 57000, 105476,
        171157, 481354, 566776,
    ],
    [
        1, 3, 4, 12, 22, 55, 73, 146, 486, 950, 1423, 2631, 6957, 13828, 32589, 46551, 87614,
        196155, 303296, 713544,
    ],
    [
        1, 3, 5, 14, 23, 55, 100, 155, 390, 964, 1660, 2575, 5953, 13260, 20812, 58141, 118939,
        192135, 435808, 917771,
    ],
    [
        1, 3, 7, 8, 26, 47, 80, 244, 292, 546, 1168, 2995, 8115, 15563, 17928, 63505, 115835,
        235469, 438031, 525522,
    ],
    [
        1, 2, 6, 13, 20, 42, 69, 158, 374, 821, 1812, 3371, 4112, 13130, 31052, 33132, 121507,
        232568, 423558, 682865,
    ],
];

/// For each bit of the number, the directions of each pair.
static DIRECTIONS: [[[u32; 2]; PAIRS]; 64] = directions();

const fn directions() -> [[[u32; 2]; PAIRS]; 64] {
    let second = second_dimension();
    let mut all = [[[0; 2]; PAIRS]; 64];
    let mut bit = 0;
    while bit < 64 {
        let mut pair = 0;
        while pair < PAIRS {
            all[bit][pair] = plane_point(column(pair, bit), &second);
            pair += 1;
        }
        bit += 1;
    }
    all
}

/// Returns a column of a pair's matrix.
const fn column(pair: usize, bit: usize) -> u64 {
    if pair == 0 {
        1 << bit
    } else if bit < MIXED {
        MIXES[pair - 1][bit]
    } else {
        // Random ones keep each pair even, and pairs as even with others as the shorter runs.
        1 << bit | mix((pair * 64 + bit) as u64) & ((1 << bit) - 1)
    }
}

/// Returns the point of Sobol's first two dimensions with this number, the highest 32 bits of each:
/// the number's bits in reverse, and the sum of the second's directions that they bring in.
const fn plane_point(number: u64, second: &[u64; 64]) -> [u32; 2] {
    let mut y = 0;
    let mut bit = 0;
    while bit < 64 {
        if number >> bit & 1 == 1 {
            y ^= second[bit];
        }
        bit += 1;
    }
    [(number.reverse_bits() >> 32) as u32, (y >> 32) as u32]
}

/// Returns the directions of Sobol's second dimension, each from the one before it: its polynomial
/// is x + 1.
const fn second_dimension() -> [u64; 64] {
    let mut directions = [1 << 63; 64];
    let mut bit = 1;
    while bit < 64 {
        directions[bit] = directions[bit - 1] ^ (directions[bit - 1] >> 1);
        bit += 1;
    }
    directions
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells of a grid that hold one of these points; for each axis, a pair of the point, a
    /// coordinate of that pair, and the bits by which it is divided.
    fn cells(points: &[[[u32; 2]; PAIRS]], axes: &[(usize, usize, u32)]) -> usize {
        let cells = points.iter().map(|point| {
            axes.iter().fold(0_u64, |cell, &(pair, coordinate, bits)| {
                cell << bits | u64::from(point[pair][coordinate]) >> (32 - bits)
            })
        });
        cells.collect::<std::collections::BTreeSet<_>>().len()
    }

    fn run(first: u64, count: u64) -> Vec<[[u32; 2]; PAIRS]> {
        (first..first + count).map(point).collect()
    }

    /// Every pair, in every shape of cells, wherever a run begins: beyond the columns that were
    /// searched, too.
    #[test]
    fn pairs_are_as_even_as_two_can_be() {
        for first in [0, 256, 3 << 8, 1 << 21, 1 << 32, (1 << 40) + (5 << 8)] {
            for bits in 1..=8 {
                let points = run(first, 1 << bits);
                for pair in 0..PAIRS {
                    for a in 0..=bits {
                        let axes = [(pair, 0, a), (pair, 1, bits - a)];
                        assert_eq!(cells(&points, &axes), 1 << bits, "{first} {pair} {axes:?}");
                    }
                }
            }
        }
    }

    /// The error of what two pairs decide together, over that of random points: at most so much.
    /// Of Sobol's own dimensions two and two reach 1.8 by 32 points and 0.74 by 256.
    #[test]
    fn pairs_are_even_with_one_another() {
        for (bits, most) in [(5, 1.6), (6, 1.1), (8, 0.6), (10, 0.4), (14, 0.13)] {
            let points = run(0, 1 << bits);
            for a in 0..PAIRS {
                for b in 0..a {
                    // Nine is the sum's expectation for random points, each 3 by 3.
                    let error: f64 = points.iter().map(|at| kernel(at[a]) * kernel(at[b])).sum();
                    assert!(error < 9.0 * most, "{bits} {a} {b}: {}", error / 9.0);
                }
            }
        }
    }

    /// The first pair is the first two dimensions of `scipy.stats.qmc.Sobol` 1.17, which counts
    /// in Gray code.
    #[test]
    fn the_first_pair_is_sobols() {
        let eighths = |number| point(number)[0].map(|value| value >> 29);
        assert_eq!(eighths(1), [4, 4]);
        assert_eq!(eighths(2), [2, 6]);
        assert_eq!(eighths(4), [1, 5]);
        assert_eq!(point(0xb_cde5)[0], [0xa7b3_d000, 0x8c85_b000]);
    }
}
