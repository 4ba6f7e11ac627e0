//! For x86-64: registers of four and two numbers, and how instructions become operators.
//!
//! Float exist only where their instructions do: an instruction set promises them, and
//! numbers come from it or from others. Methods are inlined into a function that is compiled
//! for those instructions.

#![allow(unsafe_code)]
// The names of the instructions tell where they come from.
#![allow(clippy::wildcard_imports)]

mod avx2;
mod sse41;

pub(crate) use avx2::Avx2Simd;
pub(crate) use sse41::Sse41Simd;

use super::{F32x4, FOUR, Float};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

/// Operators and comparisons of one register, by their instructions.
macro_rules! register {
    ($register:ident, $count:literal, [$add:ident, $sub:ident, $mul:ident, $div:ident],
     [$min:ident, $max:ident], [$below:expr, $at_most:expr], $mask:ident) => {
        register!(@operator $register, Add, add, $add);
        register!(@operator $register, Sub, sub, $sub);
        register!(@operator $register, Mul, mul, $mul);
        register!(@operator $register, Div, div, $div);

        impl Float for $register {
            const COUNT: u32 = $count;

            #[inline(always)]
            fn lesser(self, other: Self) -> Self {
                // SAFETY: numbers exist only where the machine has their instructions.
                Self(unsafe { $min(self.0, other.0) })
            }

            #[inline(always)]
            fn greater(self, other: Self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $max(self.0, other.0) })
            }

            #[inline(always)]
            fn below(self, other: Self) -> u32 {
                // SAFETY: as above.
                unsafe { $mask($below(self.0, other.0)) as u32 }
            }

            #[inline(always)]
            fn at_most(self, other: Self) -> u32 {
                // SAFETY: as above.
                unsafe { $mask($at_most(self.0, other.0)) as u32 }
            }
        }
    };
    (@operator $register:ident, $operator:ident, $method:ident, $instruction:ident) => {
        impl $operator for $register {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $instruction(self.0, other.0) })
            }
        }
    };
}
use register;

/// Four in single precision.
#[derive(Clone, Copy)]
pub(crate) struct Fours(__m128);

register!(
    Fours,
    4,
    [_mm_add_ps, _mm_sub_ps, _mm_mul_ps, _mm_div_ps],
    [_mm_min_ps, _mm_max_ps],
    [_mm_cmplt_ps, _mm_cmple_ps],
    _mm_movemask_ps
);

impl Fours {
    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: every x86-64 machine has SSE.
        Self(unsafe { _mm_andnot_ps(_mm_set1_ps(-0.0), self.0) })
    }

    /// All combined to one.
    #[inline(always)]
    fn fold(self, combined: impl Fn(Self, Self) -> Self) -> f32 {
        // SAFETY: every x86-64 machine has SSE.
        unsafe {
            let two = combined(self, Self(_mm_movehl_ps(self.0, self.0)));
            let one = combined(two, Self(_mm_shuffle_ps::<1>(two.0, two.0)));
            _mm_cvtss_f32(one.0)
        }
    }
}

impl F32x4 for Fours {
    #[inline(always)]
    fn to_array(self) -> [f32; FOUR] {
        let mut numbers = [0.0; FOUR];
        // SAFETY: every x86-64 machine has SSE; four numbers are 16 bytes.
        unsafe { _mm_storeu_ps(numbers.as_mut_ptr(), self.0) };
        numbers
    }
}

/// The first half and the second.
#[derive(Clone, Copy)]
pub(crate) struct Twice<N>([N; 2]);

impl<N: Copy> Twice<N> {
    #[inline(always)]
    fn with(self, other: Self, combined: impl Fn(N, N) -> N) -> Self {
        Self([combined(self.0[0], other.0[0]), combined(self.0[1], other.0[1])])
    }
}

impl<N: Float> Twice<N> {
    #[inline(always)]
    fn masks(low: u32, high: u32) -> u32 {
        low | high << N::COUNT
    }
}

impl<N: Float> Add for Twice<N> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, N::add)
    }
}

impl<N: Float> Sub for Twice<N> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, N::sub)
    }
}

impl<N: Float> Mul for Twice<N> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, N::mul)
    }
}

impl<N: Float> Div for Twice<N> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        self.with(other, N::div)
    }
}

impl<N: Float> Float for Twice<N> {
    const COUNT: u32 = 2 * N::COUNT;

    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        self.with(other, N::lesser)
    }

    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        self.with(other, N::greater)
    }

    #[inline(always)]
    fn below(self, other: Self) -> u32 {
        Self::masks(self.0[0].below(other.0[0]), self.0[1].below(other.0[1]))
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> u32 {
        Self::masks(self.0[0].at_most(other.0[0]), self.0[1].at_most(other.0[1]))
    }
}
