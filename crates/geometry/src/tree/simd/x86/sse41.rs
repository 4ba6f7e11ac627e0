//! For machines with SSE4.1, of which SSE2 is enough here.

use super::super::{F32x4, F32x8, F64x4, F64x8, FOUR, Float, PACKET, Simd};
use super::{Fours, Twice, register};
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

/// Every x86-64 machine has the instructions.
#[derive(Clone, Copy)]
pub(crate) struct Sse41Simd;

/// Two in double precision.
#[derive(Clone, Copy)]
pub(crate) struct TwoDoubles(__m128d);

register!(
    TwoDoubles,
    2,
    [_mm_add_pd, _mm_sub_pd, _mm_mul_pd, _mm_div_pd],
    [_mm_min_pd, _mm_max_pd],
    [_mm_cmplt_pd, _mm_cmple_pd],
    _mm_movemask_pd
);

impl Simd for Sse41Simd {
    type F32x8 = Twice<Fours>;
    type F32x4 = Fours;
    type F64x4 = Twice<TwoDoubles>;

    #[inline(always)]
    fn load(self, [a, b, c, d, e, f, g, h]: [f32; PACKET]) -> Twice<Fours> {
        Twice([self.load_four([a, b, c, d]), self.load_four([e, f, g, h])])
    }

    #[inline(always)]
    fn splat(self, number: f32) -> Twice<Fours> {
        Twice([self.splat_four(number); 2])
    }

    #[inline(always)]
    fn load_four(self, numbers: [f32; FOUR]) -> Fours {
        // SAFETY: every x86-64 machine has SSE2; four numbers are 16 bytes.
        Fours(unsafe { _mm_loadu_ps(numbers.as_ptr()) })
    }

    #[inline(always)]
    fn splat_four(self, number: f32) -> Fours {
        // SAFETY: as above.
        Fours(unsafe { _mm_set1_ps(number) })
    }

    #[inline(always)]
    fn load_four_doubles(self, numbers: [f64; FOUR]) -> Twice<TwoDoubles> {
        let (low, high) = numbers.split_at(2);
        // SAFETY: as above; either half is two numbers, which are 16 bytes.
        Twice([low, high].map(|half| TwoDoubles(unsafe { _mm_loadu_pd(half.as_ptr()) })))
    }

    #[inline(always)]
    fn splat_four_doubles(self, number: f64) -> Twice<TwoDoubles> {
        // SAFETY: as above.
        Twice([TwoDoubles(unsafe { _mm_set1_pd(number) }); 2])
    }

    #[inline(always)]
    fn widen_four(self, numbers: Fours) -> Twice<TwoDoubles> {
        widened(numbers)
    }

    #[inline(always)]
    fn splat_double(self, number: f64) -> Twice<Twice<TwoDoubles>> {
        Twice([self.splat_four_doubles(number); 2])
    }
}

impl F32x8 for Twice<Fours> {
    type F64x8 = Twice<Twice<TwoDoubles>>;

    #[inline(always)]
    fn minus_about(self, a: Self, b: Self) -> Self {
        self.minus_product(a, b)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        let [low, high] = self.0;
        Self([low.abs(), high.abs()])
    }

    #[inline(always)]
    fn reciprocal(self) -> Self {
        Sse41Simd.splat(1.0) / self
    }

    #[inline(always)]
    fn signs(self) -> u32 {
        let [low, high] = self.0;
        // SAFETY: every x86-64 machine has SSE2.
        unsafe { Self::masks(_mm_movemask_ps(low.0) as u32, _mm_movemask_ps(high.0) as u32) }
    }

    #[inline(always)]
    fn widen(self) -> Twice<Twice<TwoDoubles>> {
        let [low, high] = self.0;
        Twice([widened(low), widened(high)])
    }

    #[inline(always)]
    fn to_array(self) -> [f32; PACKET] {
        let ([a, b, c, d], [e, f, g, h]) = (self.0[0].to_array(), self.0[1].to_array());
        [a, b, c, d, e, f, g, h]
    }

    #[inline(always)]
    fn smallest(self) -> f32 {
        self.0[0].lesser(self.0[1]).fold(Fours::lesser)
    }

    #[inline(always)]
    fn largest(self) -> f32 {
        self.0[0].greater(self.0[1]).fold(Fours::greater)
    }
}

impl F64x4 for Twice<TwoDoubles> {
    type F32x4 = Fours;

    #[inline(always)]
    fn square_root(self) -> Self {
        // SAFETY: every x86-64 machine has SSE2.
        Self(self.0.map(|two| TwoDoubles(unsafe { _mm_sqrt_pd(two.0) })))
    }

    #[inline(always)]
    fn with_signs_of(self, other: Self) -> Self {
        // SAFETY: every x86-64 machine has SSE2.
        self.with(other, |two, other| unsafe {
            let sign = _mm_set1_pd(-0.0);
            let size = _mm_andnot_pd(sign, two.0);
            TwoDoubles(_mm_or_pd(size, _mm_and_pd(sign, other.0)))
        })
    }

    #[inline(always)]
    fn signs(self) -> u32 {
        // SAFETY: every x86-64 machine has SSE2.
        let [low, high] = self.0.map(|two| unsafe { _mm_movemask_pd(two.0) as u32 });
        Self::masks(low, high)
    }

    #[inline(always)]
    fn narrow(self) -> Fours {
        narrowed(self)
    }
}

impl F64x8 for Twice<Twice<TwoDoubles>> {
    type F32x8 = Twice<Fours>;

    #[inline(always)]
    fn narrow(self) -> Twice<Fours> {
        let [low, high] = self.0;
        Twice([narrowed(low), narrowed(high)])
    }
}

#[inline(always)]
fn widened(four: Fours) -> Twice<TwoDoubles> {
    // SAFETY: every x86-64 machine has SSE2.
    unsafe {
        let high = _mm_movehl_ps(four.0, four.0);
        Twice([TwoDoubles(_mm_cvtps_pd(four.0)), TwoDoubles(_mm_cvtps_pd(high))])
    }
}

#[inline(always)]
fn narrowed(Twice([low, high]): Twice<TwoDoubles>) -> Fours {
    // SAFETY: every x86-64 machine has SSE2.
    Fours(unsafe { _mm_movelh_ps(_mm_cvtpd_ps(low.0), _mm_cvtpd_ps(high.0)) })
}
