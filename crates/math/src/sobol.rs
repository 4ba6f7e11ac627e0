//! Points that fill the unit cube more evenly than random ones: the sequence of Sobol'.
//!
//! Among the first 2^k points, or any run of 2^k that begins at a multiple of 2^k, each
//! stretch of length 2^-k holds one in every dimension. Direction numbers are those of
//! S. Joe and F. Y. Kuo, *Constructing Sobol sequences with better two-dimensional
//! projections*, SIAM J. Sci. Comput. 30, 2008 (their file `new-joe-kuo-6.21201`, free for
//! any use with this reference and the authors' copyright notice).

/// Dimensions of a point.
pub const DIMENSIONS: usize = 16;

/// The point with this number: each coordinate is a binary fraction of 32 bits.
#[inline]
#[must_use]
pub fn point(mut index: u64) -> [u32; DIMENSIONS] {
    let mut point = [0; DIMENSIONS];
    // Each bit of the number brings in one direction number a dimension.
    while index != 0 {
        let direction = &DIRECTIONS[index.trailing_zeros() as usize];
        for (coordinate, direction) in point.iter_mut().zip(direction) {
            *coordinate ^= direction;
        }
        index &= index - 1;
    }
    point
}

/// For each dimension but the first, the inner coefficients of its primitive polynomial,
/// highest power first, and its first direction numbers, as many as the degree.
const POLYNOMIALS: [(u32, &[u64]); DIMENSIONS - 1] = [
    (0, &[1]),
    (1, &[1, 3]),
    (1, &[1, 3, 1]),
    (2, &[1, 1, 1]),
    (1, &[1, 1, 3, 3]),
    (4, &[1, 3, 5, 13]),
    (2, &[1, 1, 5, 5, 17]),
    (4, &[1, 1, 5, 5, 5]),
    (7, &[1, 1, 7, 11, 19]),
    (11, &[1, 1, 5, 1, 1]),
    (13, &[1, 1, 1, 3, 11]),
    (14, &[1, 3, 5, 5, 31]),
    (1, &[1, 3, 3, 9, 7, 49]),
    (13, &[1, 1, 1, 15, 21, 21]),
    (16, &[1, 3, 1, 13, 27, 49]),
];

/// For each bit of the number and each dimension, the highest 32 bits of the direction.
static DIRECTIONS: [[u32; DIMENSIONS]; 64] = directions();

const fn directions() -> [[u32; DIMENSIONS]; 64] {
    let mut all = [[0; DIMENSIONS]; 64];
    let mut dimension = 0;
    while dimension < DIMENSIONS {
        let of_dimension = if dimension == 0 {
            radical_inverse()
        } else {
            let (coefficients, first) = POLYNOMIALS[dimension - 1];
            recurrence(coefficients, first)
        };
        let mut bit = 0;
        while bit < 64 {
            all[bit][dimension] = (of_dimension[bit] >> 32) as u32;
            bit += 1;
        }
        dimension += 1;
    }
    all
}

/// Returns the directions of the first dimension, the bits of the number in reverse.
const fn radical_inverse() -> [u64; 64] {
    let mut directions = [0; 64];
    let mut bit = 0;
    while bit < 64 {
        directions[bit] = 1 << (63 - bit);
        bit += 1;
    }
    directions
}

/// Each from as many before it as the polynomial has degrees (Joe and Kuo, equation 3).
const fn recurrence(coefficients: u32, first: &[u64]) -> [u64; 64] {
    let degree = first.len();
    let mut directions = [0; 64];
    let mut bit = 0;
    while bit < 64 {
        directions[bit] = if bit < degree {
            first[bit] << (63 - bit)
        } else {
            let mut next = directions[bit - degree] ^ (directions[bit - degree] >> degree);
            let mut power = 1;
            while power < degree {
                if coefficients >> (degree - 1 - power) & 1 == 1 {
                    next ^= directions[bit - power];
                }
                power += 1;
            }
            next
        };
        bit += 1;
    }
    directions
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells of a grid of 2^a by 2^b over two dimensions that hold one of these points.
    fn cells(points: &[[u32; DIMENSIONS]], [x, y]: [usize; 2], a: u32, b: u32) -> usize {
        let cell =
            |value: u32, bits: u32| if bits == 0 { 0 } else { (value >> (32 - bits)) as usize };
        let mut seen = vec![false; 1 << (a + b)];
        for point in points {
            seen[cell(point[x], a) << b | cell(point[y], b)] = true;
        }
        seen.iter().filter(|seen| **seen).count()
    }

    fn run(first: u64, count: u64) -> Vec<[u32; DIMENSIONS]> {
        (first..first + count).map(point).collect()
    }

    #[test]
    fn every_dimension_is_stratified_wherever_a_run_begins() {
        for first in [0, 256, 3 << 8, 1 << 32, (1 << 40) + (5 << 8)] {
            let points = run(first, 256);
            for dimension in 0..DIMENSIONS {
                assert_eq!(cells(&points, [dimension, 0], 8, 0), 256, "{first} {dimension}");
            }
        }
    }

    /// In the first two dimensions of every shape of cells; in any two of them sixteen
    /// squares are filled by 256 points, as the authors' choice promises.
    #[test]
    fn pairs_of_dimensions_are_stratified() {
        let points = run(0, 256);
        for a in 0..=8 {
            assert_eq!(cells(&points, [0, 1], a, 8 - a), 256, "{a}");
        }
        for x in 0..DIMENSIONS {
            for y in 0..x {
                assert_eq!(cells(&points, [x, y], 2, 2), 16, "{x} {y}");
            }
        }
    }

    /// The points are those of `scipy.stats.qmc.Sobol` 1.17, which counts in Gray code.
    #[test]
    fn points_are_those_of_the_authors() {
        let eighths = |index| point(index).map(|value| value >> 29);
        assert_eq!(eighths(1), [4; DIMENSIONS]);
        assert_eq!(eighths(2), [2, 6, 6, 6, 2, 2, 6, 2, 2, 2, 2, 2, 6, 6, 2, 6]);
        assert_eq!(eighths(4), [1, 5, 3, 1, 1, 3, 5, 5, 5, 7, 5, 1, 5, 3, 1, 1]);
        let far = [
            0xa7b3_d000,
            0x8c85_b000,
            0xa51b_d000,
            0xc7a6_f000,
            0x1d75_9000,
            0xefbd_f000,
            0xf30a_9000,
            0xd517_5000,
            0x1d36_d000,
            0x592c_3000,
            0x2017_f000,
            0x82ef_d000,
            0x2bac_d000,
            0x553a_f000,
            0x186c_1000,
            0xe224_d000,
        ];
        assert_eq!(point(0xb_cde5), far);
    }
}
