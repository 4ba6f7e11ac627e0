//! For any machine.

use super::{F32x4, F32x8, F64x4, F64x8, FOUR, Float, PACKET, Simd};
use std::array::from_fn;
use std::ops::{Add, Div, Mul, Sub};

/// No instruction set but the one that is compiled for.
#[derive(Clone, Copy)]
pub(crate) struct Portable;

#[derive(Clone, Copy)]
pub(crate) struct Array<T, const N: usize>([T; N]);

impl<T: Copy, const N: usize> Array<T, N> {
    #[inline(always)]
    fn with<U>(self, other: Self, combined: impl Fn(T, T) -> U) -> [U; N] {
        from_fn(|i| combined(self.0[i], other.0[i]))
    }
}

/// One bit for each that is true.
#[inline(always)]
fn mask<const N: usize>(is_set: [bool; N]) -> u32 {
    let bits: [u32; N] = from_fn(|i| if is_set[i] { 1 << i } else { 0 });
    bits.iter().fold(0, |mask, bit| mask | bit)
}

impl Simd for Portable {
    type F32x8 = Array<f32, PACKET>;
    type F32x4 = Array<f32, FOUR>;
    type F64x4 = Array<f64, FOUR>;

    #[inline(always)]
    fn load(self, numbers: [f32; PACKET]) -> Array<f32, PACKET> {
        Array(numbers)
    }

    #[inline(always)]
    fn splat(self, number: f32) -> Array<f32, PACKET> {
        Array([number; PACKET])
    }

    #[inline(always)]
    fn load_four(self, numbers: [f32; FOUR]) -> Array<f32, FOUR> {
        Array(numbers)
    }

    #[inline(always)]
    fn splat_four(self, number: f32) -> Array<f32, FOUR> {
        Array([number; FOUR])
    }

    #[inline(always)]
    fn load_four_doubles(self, numbers: [f64; FOUR]) -> Array<f64, FOUR> {
        Array(numbers)
    }

    #[inline(always)]
    fn splat_four_doubles(self, number: f64) -> Array<f64, FOUR> {
        Array([number; FOUR])
    }

    #[inline(always)]
    fn widen_four(self, numbers: Array<f32, FOUR>) -> Array<f64, FOUR> {
        Array(numbers.0.map(f64::from))
    }

    #[inline(always)]
    fn splat_double(self, number: f64) -> Array<f64, PACKET> {
        Array([number; PACKET])
    }
}

impl<T: Copy + Add<Output = T>, const N: usize> Add for Array<T, N> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.with(other, T::add))
    }
}

impl<T: Copy + Sub<Output = T>, const N: usize> Sub for Array<T, N> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.with(other, T::sub))
    }
}

impl<T: Copy + Mul<Output = T>, const N: usize> Mul for Array<T, N> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.with(other, T::mul))
    }
}

impl<T: Copy + Div<Output = T>, const N: usize> Div for Array<T, N> {
    type Output = Self;

    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(self.with(other, T::div))
    }
}

impl<T, const N: usize> Float for Array<T, N>
where
    T: Copy + PartialOrd + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Div<Output = T>,
{
    const COUNT: u32 = N as u32;

    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        Self(self.with(other, |a, b| if a < b { a } else { b }))
    }

    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        Self(self.with(other, |a, b| if a > b { a } else { b }))
    }

    #[inline(always)]
    fn below(self, other: Self) -> u32 {
        mask(self.with(other, |a, b| a < b))
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> u32 {
        mask(self.with(other, |a, b| a <= b))
    }
}

impl F32x8 for Array<f32, PACKET> {
    type F64x8 = Array<f64, PACKET>;

    #[inline(always)]
    fn minus_about(self, a: Self, b: Self) -> Self {
        self.minus_product(a, b)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(f32::abs))
    }

    #[inline(always)]
    fn reciprocal(self) -> Self {
        Self(self.0.map(f32::recip))
    }

    #[inline(always)]
    fn signs(self) -> u32 {
        mask(self.0.map(f32::is_sign_negative))
    }

    #[inline(always)]
    fn widen(self) -> Array<f64, PACKET> {
        Array(self.0.map(f64::from))
    }

    #[inline(always)]
    fn to_array(self) -> [f32; PACKET] {
        self.0
    }

    #[inline(always)]
    fn smallest(self) -> f32 {
        self.0.into_iter().fold(f32::INFINITY, f32::min)
    }

    #[inline(always)]
    fn largest(self) -> f32 {
        self.0.into_iter().fold(f32::NEG_INFINITY, f32::max)
    }
}

impl F32x4 for Array<f32, FOUR> {
    #[inline(always)]
    fn to_array(self) -> [f32; FOUR] {
        self.0
    }
}

impl F64x4 for Array<f64, FOUR> {
    type F32x4 = Array<f32, FOUR>;

    #[inline(always)]
    fn square_root(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }

    #[inline(always)]
    fn with_signs_of(self, other: Self) -> Self {
        Self(self.with(other, f64::copysign))
    }

    #[inline(always)]
    fn signs(self) -> u32 {
        mask(self.0.map(f64::is_sign_negative))
    }

    #[inline(always)]
    fn narrow(self) -> Array<f32, FOUR> {
        Array(self.0.map(|x| x as f32))
    }
}

impl F64x8 for Array<f64, PACKET> {
    type F32x8 = Array<f32, PACKET>;

    #[inline(always)]
    fn narrow(self) -> Array<f32, PACKET> {
        Array(self.0.map(|x| x as f32))
    }
}
