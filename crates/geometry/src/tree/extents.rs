//! The largest extent of a triangle, quantised to four bits, and its sides, in one.
//!
//! Edge functions in single precision have errors that grow with the size of the triangle.
//! A kernel that knows the size knows which signs are not certain.

use crate::Sides;

/// Set for a triangle that has its front alone.
const FRONT_ALONE: u32 = 1 << 27;

/// Beside numbers below this there is room for sides and a class.
pub(crate) const MOST: u32 = FRONT_ALONE;

/// Half the distance from one to the next number: what an operation may round by.
const ROUNDING: f32 = f32::EPSILON / 2.0;

/// The bound on the error of an edge function for each unit of depth and of size, as
/// [`TriangleIntersector::candidates`](super::intersector::TriangleIntersector::candidates) has it.
pub(crate) const ERROR_BY_DEPTH: f32 = 48.0 * ROUNDING;
pub(crate) const ERROR_BY_SIZE: f32 = 96.0 * ROUNDING;

/// The position of the class in a word, in bits.
pub(crate) const CLASS_SHIFT: i32 = 28;

/// The smallest class. The next would make a word of ones with the greatest number, which
/// stands for no triangle.
const SMALLEST: u32 = 14;

/// The position of the power of two in a float, in bits.
const EXPONENT_SHIFT: i32 = 23;

/// The exponent, with bias, of the largest extents of which edge functions do not overflow:
/// the corners of a triangle that is met are at most twice as far from the ray, and a
/// product of two such distances is less than 2¹²⁷.
const LARGEST: u32 = 127 + 62;

/// The class of the greatest float. With it and all classes from there errors overflow, which
/// decides for no triangle.
const GREATEST: u32 = 127 + 127;

/// The classes of a tree: up to a power of two, up to a quarter of it, and so on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct QuantisedExtents {
    /// The bits of the greatest size as a float. Those of others are less by one at
    /// [`Self::CLASS_IN_FLOAT`] for each class.
    pub(crate) greatest: u32,
}

impl QuantisedExtents {
    /// A class makes a size smaller by a factor of four: two steps of the exponent.
    pub(crate) const CLASS_IN_FLOAT: i32 = EXPONENT_SHIFT + 1;

    /// Classes for triangles whose extents along the axes are at most `greatest`.
    pub(crate) fn up_to(greatest: f32) -> Self {
        // No class of so large a size falls below what a float can hold.
        let exponent = exponent(greatest.max(2.0_f32.powi(-90)));
        let exponent = if exponent > LARGEST { GREATEST } else { exponent };
        Self { greatest: exponent << EXPONENT_SHIFT }
    }

    /// The number of a triangle, its sides and the class of its extent, in a word.
    pub(crate) fn word(self, number: u32, sides: Sides, extent: f32) -> u32 {
        let steps = (self.greatest >> EXPONENT_SHIFT).saturating_sub(exponent(extent));
        let sides = match sides {
            Sides::Both => 0,
            Sides::Front => FRONT_ALONE,
        };
        (steps / 2).min(SMALLEST) << CLASS_SHIFT | sides | number
    }

    /// The sides in a word.
    #[inline(always)]
    pub(crate) fn sides(word: u32) -> Sides {
        if word & FRONT_ALONE == 0 { Sides::Both } else { Sides::Front }
    }

    /// The size that the class in a word stands for.
    #[inline(always)]
    pub(crate) fn size(self, word: u32) -> f32 {
        f32::from_bits(self.greatest.wrapping_sub(word >> CLASS_SHIFT << Self::CLASS_IN_FLOAT))
    }

    /// The number in a word.
    #[inline]
    pub(crate) fn number(word: u32) -> u32 {
        word & (MOST - 1)
    }
}

/// The exponent, with bias, of the least power of two that is not below a size.
fn exponent(size: f32) -> u32 {
    let exponent = (size.to_bits() + (1 << EXPONENT_SHIFT) - 1) >> EXPONENT_SHIFT;
    exponent.min(GREATEST)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_triangle_is_larger_than_its_class() {
        for greatest in [0.0, 1e-30, 0.3, 1.0, 1e30] {
            let extents = QuantisedExtents::up_to(greatest);
            for part in [1.0, 0.9, 0.5, 0.26, 0.25, 0.2, 1e-3, 1e-7, 1e-20, 0.0] {
                let (number, extent) = (123_456_789, part * greatest);
                let sides = if part == 0.5 { Sides::Front } else { Sides::Both };
                let word = extents.word(number, sides, extent);
                assert_eq!(
                    (QuantisedExtents::number(word), QuantisedExtents::sides(word)),
                    (number, sides)
                );
                let (class, size) = (word >> CLASS_SHIFT, extents.size(word));
                assert!(size >= extent && size > 0.0, "{size:e} {extent:e}");
                assert!(class == SMALLEST || size <= 8.0 * extent.max(2.0_f32.powi(-90)));
            }
        }
    }
}
