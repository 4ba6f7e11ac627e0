//! Searches the mixes of `src/sobol.rs`, and prints them as they stand there (a minute or two).
//!
//! Any mixes make every pair of coordinates as even as two can be; these are to make those of
//! different pairs even with one another. What is made small is the expected squared error of
//! a smooth function's mean:
//!
//! 1. The error is a sum of products of kernels, one a pair ([`kernel`]). Twice as many points
//!    need one column more of each matrix.
//! 2. From random columns, the best is chosen for one pair after the other until none changes.
//! 3. The best sets of matrices go on to the next column.
//!
//! ```sh
//! cargo run --release -p traylib-math --example search_mixes
//! ```

#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program")]

use traylib_math::Sampler;
use traylib_math::sobol::{MIXED, PAIRS, kernel, point};

/// Pairs that a path uses together: a walk's pixel, its light samples and its directions, each
/// with the next.
const TOGETHER: [[usize; 2]; 6] = [[0, 1], [0, 2], [1, 2], [2, 3], [2, 4], [4, 5]];
/// So three pairs do.
const TRIPLES: [[usize; 3]; 4] = [[0, 1, 2], [0, 2, 3], [1, 2, 3], [2, 4, 5]];
const TRIPLE_WEIGHT: f64 = 0.2;

/// All columns are tried up to this bit, so many random ones beyond.
const ALL_COLUMNS: usize = 7;
const RANDOM_COLUMNS: u64 = 128;

/// The matrices so far, and what their points weigh.
#[derive(Clone)]
struct Mixes {
    columns: [Vec<u64>; PAIRS],
    points: [Vec<[u32; 2]>; PAIRS],
    kernels: [Vec<f64>; PAIRS],
    error: f64,
}

fn main() {
    let mut sampler = Sampler::numbered(0, 0);
    let none = Mixes {
        columns: Default::default(),
        points: std::array::from_fn(|_| vec![[0; 2]]),
        kernels: std::array::from_fn(|_| vec![kernel([0; 2])]),
        error: 0.0,
    };
    let mut best = vec![none];
    for bit in 0..MIXED {
        let (starts, kept) =
            if bit < ALL_COLUMNS { (64, 16) } else { (1 + 32 / bit, 1 + 16 / bit) };
        best = best.iter().flat_map(|mixes| mixes.with_column(bit, starts, &mut sampler)).collect();
        best.sort_by(|a, b| a.error.total_cmp(&b.error));
        best.dedup_by(|a, b| a.columns == b.columns);
        best.truncate(kept);
        eprintln!("{} points: {:.2}", 2_u64 << bit, best[0].error);
    }
    for columns in &best[0].columns[1..] {
        println!("    {columns:?},");
    }
}

/// What two pairs weigh: as much as any where a path uses them together, else by how early it
/// comes to them.
fn weight(a: usize, b: usize) -> f64 {
    if TOGETHER.contains(&[a.min(b), a.max(b)]) {
        1.0
    } else {
        0.7 / (((1 + a) * (1 + b)) as f64).sqrt()
    }
}

impl Mixes {
    /// Adds a column to every matrix, once from each of so many beginnings.
    fn with_column(&self, bit: usize, starts: usize, sampler: &mut Sampler) -> Vec<Self> {
        (0..starts).map(|_| self.improved(bit, sampler)).collect()
    }

    /// Adds a random column to every matrix and improves one after the other.
    fn improved(&self, bit: usize, sampler: &mut Sampler) -> Self {
        let mut columns: [u64; PAIRS] = std::array::from_fn(|_| random_column(bit, sampler));
        // The first pair is Sobol's own.
        columns[0] = 1 << bit;
        let mut kernels: [Vec<f64>; PAIRS] =
            std::array::from_fn(|pair| self.new_kernels(pair, columns[pair]).collect());
        let mut changed = true;
        while changed {
            changed = false;
            for pair in 1..PAIRS {
                let better = self.better_column(pair, bit, columns[pair], &kernels, sampler);
                if let Some(column) = better {
                    columns[pair] = column;
                    kernels[pair] = self.new_kernels(pair, column).collect();
                    changed = true;
                }
            }
        }
        self.extended(columns, kernels)
    }

    /// Kernels of the points that a column adds.
    fn new_kernels(&self, pair: usize, column: u64) -> impl Iterator<Item = f64> {
        let [x, y] = point(column)[0];
        self.points[pair].iter().map(move |[old_x, old_y]| kernel([old_x ^ x, old_y ^ y]))
    }

    /// Searches a column of one matrix with a smaller error beside the others' than it has.
    fn better_column(
        &self,
        pair: usize,
        bit: usize,
        now: u64,
        kernels: &[Vec<f64>; PAIRS],
        sampler: &mut Sampler,
    ) -> Option<u64> {
        let others: Vec<f64> =
            (0..kernels[0].len()).map(|point| error_by_kernel(pair, point, kernels)).collect();
        let error = |column| {
            self.new_kernels(pair, column).zip(&others).map(|(kernel, error)| kernel * error).sum()
        };
        let mut best: (f64, u64) = (error(now), now);
        let all = bit <= ALL_COLUMNS;
        for number in 0..if all { 1 << bit } else { RANDOM_COLUMNS } {
            let column = if all { 1 << bit | number } else { random_column(bit, sampler) };
            let found = error(column);
            // What is as good is no better, whatever rounding says of it.
            if found < best.0 - 1e-6 {
                best = (found, column);
            }
        }
        (best.1 != now).then_some(best.1)
    }

    fn extended(&self, columns: [u64; PAIRS], kernels: [Vec<f64>; PAIRS]) -> Self {
        let mut mixes = self.clone();
        for (pair, new) in kernels.into_iter().enumerate() {
            let [x, y] = point(columns[pair])[0];
            let moved = self.points[pair].iter().map(|[old_x, old_y]| [old_x ^ x, old_y ^ y]);
            mixes.points[pair].extend(moved);
            mixes.columns[pair].push(columns[pair]);
            mixes.kernels[pair].extend(new);
        }
        mixes.error += error(&mixes.kernels);
        mixes
    }
}

/// What the error gains by one unit of a pair's kernel at one point.
fn error_by_kernel(pair: usize, point: usize, kernels: &[Vec<f64>; PAIRS]) -> f64 {
    let of_pairs = (0..PAIRS)
        .filter(|other| *other != pair)
        .map(|other| weight(pair, other) * kernels[other][point])
        .sum::<f64>();
    let of_triples = TRIPLES
        .iter()
        .filter(|triple| triple.contains(&pair))
        .map(|triple| {
            let others = triple.iter().filter(|other| **other != pair);
            TRIPLE_WEIGHT / 3.0 * others.map(|other| kernels[*other][point]).product::<f64>()
        })
        .sum::<f64>();
    of_pairs + of_triples
}

/// The error of all points, in units of that of one random point.
fn error(kernels: &[Vec<f64>; PAIRS]) -> f64 {
    let sum = |of: &dyn Fn(usize) -> f64| (0..kernels[0].len()).map(of).sum::<f64>();
    let mut error = 0.0;
    for a in 0..PAIRS {
        for b in a + 1..PAIRS {
            error += weight(a, b) * sum(&|point| kernels[a][point] * kernels[b][point]);
        }
    }
    for [a, b, c] in TRIPLES {
        let product = |point: usize| kernels[a][point] * kernels[b][point] * kernels[c][point];
        error += TRIPLE_WEIGHT / 3.0 * sum(&product);
    }
    error
}

/// A column that makes a matrix of those before it that can be undone.
fn random_column(bit: usize, sampler: &mut Sampler) -> u64 {
    1 << bit | (sampler.next_fine() * (1_u64 << bit) as f64) as u64
}
