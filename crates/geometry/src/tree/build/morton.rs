//! Items along a curve through space on which neighbours are mostly near.

use super::GRAIN;
use crate::tree::parallel;
use crate::{Aabb, Vec3};

/// Cells along each axis.
const CELLS: f32 = (1 << 21) as f32;

/// The items in the order of the Morton codes of their centres; where codes are
/// equal, in the order of their numbers.
pub(super) fn order(boxes: &[Aabb], items: &[u32]) -> Vec<u32> {
    let centre = |i: usize| boxes[items[i] as usize].centre();
    let cells = MortonCells::around(centres(items.len(), centre));
    // As one number, which is compared without a jump.
    let key = |i: usize| u128::from(cells.code(centre(i))) << u32::BITS | u128::from(items[i]);
    let mut keys = parallel::map(items.len(), GRAIN, key);
    parallel::sort(&mut keys);
    parallel::map(keys.len(), GRAIN, |i| keys[i] as u32)
}

/// The box around all centres.
fn centres(count: usize, centre: impl Fn(usize) -> Vec3 + Send + Sync) -> Aabb {
    let parts = parallel::chunks(count, GRAIN, |range| Aabb::around(range.map(&centre)));
    parts.into_iter().fold(Aabb::EMPTY, Aabb::union)
}

/// Cubic cells, as many as fit along the longest axis.
struct MortonCells {
    start: Vec3,
    cells_per_length: f32,
}

impl MortonCells {
    fn around(centres: Aabb) -> Self {
        Self { start: centres.min, cells_per_length: CELLS / centres.extent().max_element() }
    }

    /// The bits of the three cell numbers, taken in turn.
    fn code(&self, centre: Vec3) -> u64 {
        // Where all centres are in one place, 0 · ∞ is cell 0.
        let cell = (centre - self.start) * self.cells_per_length;
        let bits = |x: f32| spread(x.min(CELLS - 1.0) as u64);
        bits(cell.x) | bits(cell.y) << 1 | bits(cell.z) << 2
    }
}

/// Moves bit i of 21 to place 3i.
fn spread(x: u64) -> u64 {
    let x = (x | x << 32) & 0x001f_0000_0000_ffff;
    let x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    let x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    let x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_spread_in_threes() {
        for bit in 0..21 {
            assert_eq!(spread(1 << bit), 1 << (3 * bit));
        }
        assert_eq!(spread(0x1f_ffff), 0x1249_2492_4924_9249);
    }

    #[test]
    fn the_curve_goes_through_the_cells_of_a_cube_in_turn() {
        let corner = |i: u32| Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32);
        let boxes: Vec<Aabb> = (0..8).rev().map(|i| Aabb::around([corner(i)])).collect();
        assert_eq!(order(&boxes, &[0, 1, 2, 3, 4, 5, 6, 7]), [7, 6, 5, 4, 3, 2, 1, 0]);
    }

    #[test]
    fn equal_centres_stay_in_the_order_of_numbers() {
        let boxes = [Aabb::around([Vec3::ONE]); 3];
        assert_eq!(order(&boxes, &[2, 0, 1]), [0, 1, 2]);
    }
}
