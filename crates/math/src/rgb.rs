//! Light in three bands.

use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign};

/// A quantity of light (the paper's `Light`): red, green and blue, linear,
/// Rec. 709 primaries.
///
/// The unit is the caller's: W/(m²·sr) for radiance, W/sr for the intensity of
/// a point light, none for a reflectance or a throughput.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
}

impl Rgb {
    /// No light.
    pub const BLACK: Self = Self::splat(0.0);
    /// One in each band.
    pub const WHITE: Self = Self::splat(1.0);

    /// Light with the given bands.
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Self { r, g, b }
    }

    /// Makes a colour of the same value in all three bands.
    pub const fn splat(value: f32) -> Self {
        Self::new(value, value, value)
    }

    /// Luminance, the Y of CIE XYZ, for Rec. 709 primaries.
    pub fn luminance(self) -> f32 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }

    /// The largest band.
    pub fn max_band(self) -> f32 {
        self.r.max(self.g).max(self.b)
    }

    /// Each band brought into [0, 1]; what is not a number becomes 0.
    #[must_use]
    pub fn saturated(self) -> Self {
        Self::from(self.to_array().map(|band| if band > 0.0 { band.min(1.0) } else { 0.0 }))
    }

    /// The smallest band.
    pub fn min_band(self) -> f32 {
        self.r.min(self.g).min(self.b)
    }

    /// Tells whether no band holds anything.
    pub fn is_black(self) -> bool {
        self == Self::BLACK
    }

    /// Tells whether every band is a number and finite.
    pub fn is_finite(self) -> bool {
        self.r.is_finite() && self.g.is_finite() && self.b.is_finite()
    }

    /// The bands in order r, g, b.
    pub const fn to_array(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }
}

impl From<[f32; 3]> for Rgb {
    fn from([r, g, b]: [f32; 3]) -> Self {
        Self::new(r, g, b)
    }
}

impl Add for Rgb {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.r + other.r, self.g + other.g, self.b + other.b)
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Mul for Rgb {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.r * other.r, self.g * other.g, self.b * other.b)
    }
}

impl Mul<f32> for Rgb {
    type Output = Self;
    fn mul(self, factor: f32) -> Self {
        Self::new(self.r * factor, self.g * factor, self.b * factor)
    }
}

impl Mul<Rgb> for f32 {
    type Output = Rgb;
    fn mul(self, light: Rgb) -> Rgb {
        light * self
    }
}

impl MulAssign for Rgb {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl MulAssign<f32> for Rgb {
    fn mul_assign(&mut self, factor: f32) {
        *self = *self * factor;
    }
}

impl Div<f32> for Rgb {
    type Output = Self;
    fn div(self, divisor: f32) -> Self {
        Self::new(self.r / divisor, self.g / divisor, self.b / divisor)
    }
}

impl Sum for Rgb {
    fn sum<I: Iterator<Item = Self>>(values: I) -> Self {
        values.fold(Self::BLACK, Add::add)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_has_luminance_one() {
        assert!((Rgb::WHITE.luminance() - 1.0).abs() < 1e-6);
    }

    #[test]
    fn bands_are_independent() {
        let light = Rgb::new(1.0, 2.0, 3.0) * Rgb::new(4.0, 5.0, 6.0) * 2.0;
        assert_eq!(light, Rgb::new(8.0, 20.0, 36.0));
        assert_eq!((light.max_band(), light.min_band()), (36.0, 8.0));
    }

    #[test]
    fn a_single_bad_band_is_noticed() {
        assert!(!Rgb::new(0.0, f32::NAN, 0.0).is_finite());
        assert!(!Rgb::new(0.0, 0.0, f32::INFINITY).is_finite());
    }
}
