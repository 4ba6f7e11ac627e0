//! For machines with AVX2 and FMA.
//!
//! Numbers exist only where the instructions do: an [`Avx2Eights`] promises them, and
//! numbers come from it or from others. Methods are inlined into a function that is compiled
//! for those instructions.

#![allow(unsafe_code)]
// The names of the instructions tell where they come from.
#![allow(clippy::wildcard_imports)]

use super::{Double, EIGHT, Eights, FOUR, Four, Numbers, Single};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

/// Shows that the machine has AVX2 and FMA.
#[derive(Clone, Copy)]
pub(crate) struct Avx2Eights(());

impl Avx2Eights {
    /// # Safety
    /// The machine must have AVX2 and FMA.
    #[inline(always)]
    pub(crate) unsafe fn new() -> Self {
        Self(())
    }
}

#[derive(Clone, Copy)]
pub(crate) struct Singles(__m256);

#[derive(Clone, Copy)]
pub(crate) struct Fours(__m128);

/// The first four and the others.
#[derive(Clone, Copy)]
pub(crate) struct Doubles([__m256d; 2]);

impl Eights for Avx2Eights {
    type Single = Singles;
    type Four = Fours;

    #[inline(always)]
    fn load(self, numbers: [f32; EIGHT]) -> Singles {
        // SAFETY: `self` shows that the machine has AVX2; eight numbers are 32 bytes.
        Singles(unsafe { _mm256_loadu_ps(numbers.as_ptr()) })
    }

    #[inline(always)]
    fn splat(self, number: f32) -> Singles {
        // SAFETY: as above.
        Singles(unsafe { _mm256_set1_ps(number) })
    }

    #[inline(always)]
    fn load_four(self, numbers: [f32; FOUR]) -> Fours {
        // SAFETY: as above; four numbers are 16 bytes.
        Fours(unsafe { _mm_loadu_ps(numbers.as_ptr()) })
    }

    #[inline(always)]
    fn splat_four(self, number: f32) -> Fours {
        // SAFETY: as above.
        Fours(unsafe { _mm_set1_ps(number) })
    }

    #[inline(always)]
    fn splat_double(self, number: f64) -> Doubles {
        // SAFETY: as above.
        Doubles([unsafe { _mm256_set1_pd(number) }; 2])
    }
}

impl Singles {
    /// All combined to one.
    #[inline(always)]
    fn fold(self, combined: impl Fn(__m128, __m128) -> __m128) -> f32 {
        // SAFETY: numbers exist only where the machine has AVX2.
        unsafe {
            let (low, high) = (_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0));
            let four = combined(low, high);
            let two = combined(four, _mm_movehl_ps(four, four));
            _mm_cvtss_f32(combined(two, _mm_movehdup_ps(two)))
        }
    }
}

impl Doubles {
    #[inline(always)]
    fn with(self, other: Self, combined: impl Fn(__m256d, __m256d) -> __m256d) -> Self {
        Self([combined(self.0[0], other.0[0]), combined(self.0[1], other.0[1])])
    }

    /// The signs.
    #[inline(always)]
    fn mask(self) -> u32 {
        // SAFETY: numbers exist only where the machine has AVX2.
        let [low, high] = self.0.map(|half| unsafe { _mm256_movemask_pd(half) } as u32);
        low | high << 4
    }
}

/// An operator, by its instructions.
macro_rules! operator {
    ($operator:ident, $method:ident, $four:ident, $single:ident, $double:ident) => {
        impl $operator for Fours {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: numbers exist only where the machine has AVX2.
                Self(unsafe { $four(self.0, other.0) })
            }
        }

        impl $operator for Singles {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: as above.
                Self(unsafe { $single(self.0, other.0) })
            }
        }

        impl $operator for Doubles {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: as above.
                self.with(other, |a, b| unsafe { $double(a, b) })
            }
        }
    };
}

operator!(Add, add, _mm_add_ps, _mm256_add_ps, _mm256_add_pd);
operator!(Sub, sub, _mm_sub_ps, _mm256_sub_ps, _mm256_sub_pd);
operator!(Mul, mul, _mm_mul_ps, _mm256_mul_ps, _mm256_mul_pd);
operator!(Div, div, _mm_div_ps, _mm256_div_ps, _mm256_div_pd);

/// [`Numbers`] of one register, by their instructions.
macro_rules! numbers {
    ($numbers:ident, $min:ident, $max:ident, $compare:ident, $mask:ident) => {
        impl Numbers for $numbers {
            #[inline(always)]
            fn lesser(self, other: Self) -> Self {
                // SAFETY: numbers exist only where the machine has AVX2.
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
                unsafe { $mask($compare::<_CMP_LT_OQ>(self.0, other.0)) as u32 }
            }

            #[inline(always)]
            fn at_most(self, other: Self) -> u32 {
                // SAFETY: as above.
                unsafe { $mask($compare::<_CMP_LE_OQ>(self.0, other.0)) as u32 }
            }
        }
    };
}

numbers!(Fours, _mm_min_ps, _mm_max_ps, _mm_cmp_ps, _mm_movemask_ps);
numbers!(Singles, _mm256_min_ps, _mm256_max_ps, _mm256_cmp_ps, _mm256_movemask_ps);

// SAFETY, below: numbers exist only where the machine has AVX2 and FMA.
impl Numbers for Doubles {
    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        // SAFETY: as said above.
        self.with(other, |a, b| unsafe { _mm256_min_pd(a, b) })
    }

    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        // SAFETY: as said above.
        self.with(other, |a, b| unsafe { _mm256_max_pd(a, b) })
    }

    #[inline(always)]
    fn below(self, other: Self) -> u32 {
        // SAFETY: as said above.
        self.with(other, |a, b| unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(a, b) }).mask()
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> u32 {
        // SAFETY: as said above.
        self.with(other, |a, b| unsafe { _mm256_cmp_pd::<_CMP_LE_OQ>(a, b) }).mask()
    }
}

impl Single for Singles {
    type Double = Doubles;

    #[inline(always)]
    fn minus_about(self, a: Self, b: Self) -> Self {
        // SAFETY: as said above.
        Self(unsafe { _mm256_fnmadd_ps(a.0, b.0, self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: as said above.
        Self(unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), self.0) })
    }

    #[inline(always)]
    fn reciprocal(self) -> Self {
        // SAFETY: as said above.
        Self(unsafe { _mm256_div_ps(_mm256_set1_ps(1.0), self.0) })
    }

    #[inline(always)]
    fn signs(self) -> u32 {
        // SAFETY: as said above.
        unsafe { _mm256_movemask_ps(self.0) as u32 }
    }

    #[inline(always)]
    fn widen(self) -> Doubles {
        // SAFETY: as said above.
        unsafe {
            let low = _mm256_castps256_ps128(self.0);
            let high = _mm256_extractf128_ps::<1>(self.0);
            Doubles([_mm256_cvtps_pd(low), _mm256_cvtps_pd(high)])
        }
    }

    #[inline(always)]
    fn to_array(self) -> [f32; EIGHT] {
        let mut numbers = [0.0; EIGHT];
        // SAFETY: as said above; eight numbers are 32 bytes.
        unsafe { _mm256_storeu_ps(numbers.as_mut_ptr(), self.0) };
        numbers
    }

    #[inline(always)]
    fn smallest(self) -> f32 {
        // SAFETY: as said above.
        self.fold(|a, b| unsafe { _mm_min_ps(a, b) })
    }

    #[inline(always)]
    fn largest(self) -> f32 {
        // SAFETY: as said above.
        self.fold(|a, b| unsafe { _mm_max_ps(a, b) })
    }
}

impl Four for Fours {
    #[inline(always)]
    fn to_array(self) -> [f32; FOUR] {
        let mut numbers = [0.0; FOUR];
        // SAFETY: as said above; four numbers are 16 bytes.
        unsafe { _mm_storeu_ps(numbers.as_mut_ptr(), self.0) };
        numbers
    }
}

impl Double for Doubles {
    type Single = Singles;

    #[inline(always)]
    fn narrow(self) -> Singles {
        // SAFETY: as said above.
        let [low, high] = self.0.map(|half| unsafe { _mm256_cvtpd_ps(half) });
        // SAFETY: as said above.
        Singles(unsafe { _mm256_set_m128(high, low) })
    }
}
