//! For machines with AVX2 and FMA.

use super::super::{F32x8, F64x4, F64x8, FOUR, Float, PACKET, Simd};
use super::{Fours, Sse41Simd, Twice, register};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

/// Shows that the machine has AVX2 and FMA.
#[derive(Clone, Copy)]
pub(crate) struct Avx2Simd(());

impl Avx2Simd {
    /// # Safety
    /// The machine must have AVX2 and FMA.
    #[inline(always)]
    pub(crate) unsafe fn new() -> Self {
        Self(())
    }
}

#[derive(Clone, Copy)]
pub(crate) struct Floats(__m256);

/// Four in double precision.
#[derive(Clone, Copy)]
pub(crate) struct FourDoubles(__m256d);

register!(
    Floats,
    8,
    [_mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps],
    [_mm256_min_ps, _mm256_max_ps],
    [_mm256_cmp_ps::<_CMP_LT_OQ>, _mm256_cmp_ps::<_CMP_LE_OQ>],
    _mm256_movemask_ps
);
register!(
    FourDoubles,
    4,
    [_mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd],
    [_mm256_min_pd, _mm256_max_pd],
    [_mm256_cmp_pd::<_CMP_LT_OQ>, _mm256_cmp_pd::<_CMP_LE_OQ>],
    _mm256_movemask_pd
);

impl Simd for Avx2Simd {
    type F32x8 = Floats;
    type F32x4 = Fours;
    type F64x4 = FourDoubles;

    #[inline(always)]
    fn load(self, numbers: [f32; PACKET]) -> Floats {
        // SAFETY: `self` shows that the machine has AVX2; eight numbers are 32 bytes.
        Floats(unsafe { _mm256_loadu_ps(numbers.as_ptr()) })
    }

    #[inline(always)]
    fn splat(self, number: f32) -> Floats {
        // SAFETY: as above.
        Floats(unsafe { _mm256_set1_ps(number) })
    }

    #[inline(always)]
    fn load_four(self, numbers: [f32; FOUR]) -> Fours {
        Sse41Simd.load_four(numbers)
    }

    #[inline(always)]
    fn splat_four(self, number: f32) -> Fours {
        Sse41Simd.splat_four(number)
    }

    #[inline(always)]
    fn load_four_doubles(self, numbers: [f64; FOUR]) -> FourDoubles {
        // SAFETY: as above; four numbers are 32 bytes.
        FourDoubles(unsafe { _mm256_loadu_pd(numbers.as_ptr()) })
    }

    #[inline(always)]
    fn splat_four_doubles(self, number: f64) -> FourDoubles {
        // SAFETY: as above.
        FourDoubles(unsafe { _mm256_set1_pd(number) })
    }

    #[inline(always)]
    fn widen_four(self, numbers: Fours) -> FourDoubles {
        // SAFETY: as above.
        FourDoubles(unsafe { _mm256_cvtps_pd(numbers.0) })
    }

    #[inline(always)]
    fn splat_double(self, number: f64) -> Twice<FourDoubles> {
        // SAFETY: as above.
        Twice([FourDoubles(unsafe { _mm256_set1_pd(number) }); 2])
    }
}

impl Floats {
    /// All combined to one.
    #[inline(always)]
    fn fold(self, combined: impl Fn(Fours, Fours) -> Fours) -> f32 {
        // SAFETY: numbers exist only where the machine has AVX2.
        let (low, high) =
            unsafe { (_mm256_castps256_ps128(self.0), _mm256_extractf128_ps::<1>(self.0)) };
        combined(Fours(low), Fours(high)).fold(combined)
    }
}

// SAFETY, below: numbers exist only where the machine has AVX2 and FMA.
impl F32x8 for Floats {
    type F64x8 = Twice<FourDoubles>;

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
        Self(unsafe { _mm256_set1_ps(1.0) }) / self
    }

    #[inline(always)]
    fn signs(self) -> u32 {
        // SAFETY: as said above.
        unsafe { _mm256_movemask_ps(self.0) as u32 }
    }

    #[inline(always)]
    fn widen(self) -> Twice<FourDoubles> {
        // SAFETY: as said above.
        unsafe {
            let low = _mm256_castps256_ps128(self.0);
            let high = _mm256_extractf128_ps::<1>(self.0);
            Twice([FourDoubles(_mm256_cvtps_pd(low)), FourDoubles(_mm256_cvtps_pd(high))])
        }
    }

    #[inline(always)]
    fn to_array(self) -> [f32; PACKET] {
        let mut numbers = [0.0; PACKET];
        // SAFETY: as said above; eight numbers are 32 bytes.
        unsafe { _mm256_storeu_ps(numbers.as_mut_ptr(), self.0) };
        numbers
    }

    #[inline(always)]
    fn smallest(self) -> f32 {
        self.fold(Fours::lesser)
    }

    #[inline(always)]
    fn largest(self) -> f32 {
        self.fold(Fours::greater)
    }
}

impl F64x4 for FourDoubles {
    type F32x4 = Fours;

    #[inline(always)]
    fn square_root(self) -> Self {
        // SAFETY: as said above.
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn with_signs_of(self, other: Self) -> Self {
        // SAFETY: as said above.
        unsafe {
            let sign = _mm256_set1_pd(-0.0);
            let size = _mm256_andnot_pd(sign, self.0);
            Self(_mm256_or_pd(size, _mm256_and_pd(sign, other.0)))
        }
    }

    #[inline(always)]
    fn signs(self) -> u32 {
        // SAFETY: as said above.
        unsafe { _mm256_movemask_pd(self.0) as u32 }
    }

    #[inline(always)]
    fn narrow(self) -> Fours {
        // SAFETY: as said above.
        Fours(unsafe { _mm256_cvtpd_ps(self.0) })
    }
}

impl F64x8 for Twice<FourDoubles> {
    type F32x8 = Floats;

    #[inline(always)]
    fn narrow(self) -> Floats {
        let [low, high] = self.0;
        // SAFETY: as said above.
        Floats(unsafe { _mm256_set_m128(_mm256_cvtpd_ps(high.0), _mm256_cvtpd_ps(low.0)) })
    }
}
