//! For machines with AVX2 and FMA.

use super::super::{Double, EIGHT, Eights, FOUR, Numbers, Single};
use super::{Fours, Sse41Eights, Twice, register};
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

/// Four in double precision.
#[derive(Clone, Copy)]
pub(crate) struct FourDoubles(__m256d);

register!(
    Singles,
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
        Sse41Eights.load_four(numbers)
    }

    #[inline(always)]
    fn splat_four(self, number: f32) -> Fours {
        Sse41Eights.splat_four(number)
    }

    #[inline(always)]
    fn splat_double(self, number: f64) -> Twice<FourDoubles> {
        // SAFETY: as above.
        Twice([FourDoubles(unsafe { _mm256_set1_pd(number) }); 2])
    }
}

impl Singles {
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
impl Single for Singles {
    type Double = Twice<FourDoubles>;

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
    fn to_array(self) -> [f32; EIGHT] {
        let mut numbers = [0.0; EIGHT];
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

impl Double for Twice<FourDoubles> {
    type Single = Singles;

    #[inline(always)]
    fn narrow(self) -> Singles {
        let [low, high] = self.0;
        // SAFETY: as said above.
        Singles(unsafe { _mm256_set_m128(_mm256_cvtpd_ps(high.0), _mm256_cvtpd_ps(low.0)) })
    }
}
