//! Eight numbers at once, one for each ray of a packet; and four, one for each shape of a
//! block.

mod portable;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use portable::Portable;
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::{Avx2Simd, Sse41Simd};

use std::ops::{Add, Div, Mul, Sub};

/// The number of rays in a packet, one a lane.
pub(crate) const PACKET: usize = 8;

/// One for each shape of a block.
pub(crate) const FOUR: usize = 4;

/// All eight have a bit.
pub(crate) const ALL: u32 = u32::MAX >> (32 - PACKET);

/// An instruction set: where numbers come from.
pub(crate) trait Simd: Copy {
    type F32x8: F32x8;
    type F32x4: F32x4;
    type F64x4: F64x4<F32x4 = Self::F32x4>;

    fn load(self, numbers: [f32; PACKET]) -> Self::F32x8;

    /// Returns the number eight times.
    fn splat(self, number: f32) -> Self::F32x8;

    fn load_four(self, numbers: [f32; FOUR]) -> Self::F32x4;

    /// Returns the number four times.
    fn splat_four(self, number: f32) -> Self::F32x4;

    fn load_four_doubles(self, numbers: [f64; FOUR]) -> Self::F64x4;

    /// Returns the number four times.
    fn splat_four_doubles(self, number: f64) -> Self::F64x4;

    fn widen_four(self, numbers: Self::F32x4) -> Self::F64x4;

    /// Returns the number eight times.
    fn splat_double(self, number: f64) -> <Self::F32x8 as F32x8>::F64x8;
}

/// The operations on numbers side by side, in single and double precision. Masks have one bit for
/// each.
pub(crate) trait Float:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The number of them side by side.
    const COUNT: u32;

    /// The lesser of each pair; if one is not a number, that of `other`.
    fn lesser(self, other: Self) -> Self;

    /// The greater of each pair; if one is not a number, that of `other`.
    fn greater(self, other: Self) -> Self;

    /// Returns a mask of those that are less than those of `other`.
    fn below(self, other: Self) -> u32;

    /// Returns a mask of those that are not greater than those of `other`, and numbers.
    fn at_most(self, other: Self) -> u32;

    /// The least of three.
    #[inline(always)]
    fn least([a, b, c]: [Self; 3]) -> Self {
        a.lesser(b).lesser(c)
    }

    /// The greatest of three.
    #[inline(always)]
    fn greatest([a, b, c]: [Self; 3]) -> Self {
        a.greater(b).greater(c)
    }
}

/// Eight numbers in single precision.
pub(crate) trait F32x8: Float {
    type F64x8: F64x8<F32x8 = Self>;

    /// `self` − `a` `b`, rounded once or twice.
    fn minus_about(self, a: Self, b: Self) -> Self;

    fn abs(self) -> Self;

    fn reciprocal(self) -> Self;

    /// Returns a mask of those that have a minus, zeros too.
    fn signs(self) -> u32;

    fn widen(self) -> Self::F64x8;

    fn to_array(self) -> [f32; PACKET];

    /// The least of the eight, all numbers.
    fn smallest(self) -> f32;

    /// The greatest of the eight, all numbers.
    fn largest(self) -> f32;

    /// `self` − `a` `b`, both rounded.
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }
}

/// Four numbers in single precision.
pub(crate) trait F32x4: Float {
    fn to_array(self) -> [f32; FOUR];
}

/// Four numbers in double precision.
pub(crate) trait F64x4: Float {
    type F32x4: F32x4;

    fn square_root(self) -> Self;

    /// Returns numbers as large as before, with the signs of `other`, which zeros have too.
    fn with_signs_of(self, other: Self) -> Self;

    /// Returns a mask of those that have a minus, zeros too.
    fn signs(self) -> u32;

    fn narrow(self) -> Self::F32x4;
}

/// Eight numbers in double precision.
pub(crate) trait F64x8: Float {
    type F32x8: F32x8<F64x8 = Self>;

    fn narrow(self) -> Self::F32x8;
}

#[cfg(all(test, target_arch = "x86_64", not(miri)))]
mod tests;
