//! Colours: hue without magnitude.

use super::{Cause, observer};
use traylib_math::Rgb;

/// A chromaticity, CIE 1931. Mixtures may pass through values that no light has.
/// With y = 0 there is no luminance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Colour {
    pub(super) x: f64,
    pub(super) y: f64,
}

impl Default for Colour {
    /// Equal energy at all wavelengths.
    fn default() -> Self {
        Self { x: 1.0 / 3.0, y: 1.0 / 3.0 }
    }
}

/// Decimal fractions that should sum to one may be off by this much.
const ROUNDING: f64 = 1e-6;

impl Colour {
    /// `cxy`.
    pub(super) fn chromaticity([x, y]: [f64; 2]) -> Result<Self, Cause> {
        if x < 0.0 || y < 0.0 || x + y > 1.0 + ROUNDING {
            return Err(Cause::Illegal("x and y must be 0 or more and sum to 1 at most"));
        }
        Ok(Self { x, y })
    }

    /// `cspec`: two or more samples, evenly spaced from `first` to `last` in nm,
    /// linear between and 0 outside.
    pub(super) fn spectrum([first, last]: [f64; 2], samples: &[f64]) -> Result<Self, Cause> {
        if first >= last {
            return Err(Cause::Illegal("the first wavelength must be shorter than the last"));
        }
        let per_nm = (samples.len() - 1) as f64 / (last - first);
        Ok(Self::of(observer::xyz(|wavelength| {
            if wavelength < first || wavelength > last {
                return 0.0;
            }
            let place = (wavelength - first) * per_nm;
            let index = (place as usize).min(samples.len() - 2);
            let part = place - index as f64;
            samples[index] * (1.0 - part) + samples[index + 1] * part
        })))
    }

    /// `cct`: a black body at a temperature in kelvin.
    pub(super) fn temperature(kelvin: f64) -> Result<Self, Cause> {
        if !(1000.0..=1e10).contains(&kelvin) {
            let (what, range) = ("the temperature", "from 1000 to 1e10 K");
            return Err(Cause::Range { what, value: kelvin, range });
        }
        Ok(Self::of(observer::xyz(|wavelength| {
            let ratio = 1.4388e7 / (wavelength * kelvin);
            (560.0 / wavelength).powi(5) / ratio.exp_m1()
        })))
    }

    /// `cmix`: parts by relative luminance. Those without luminance add nothing.
    pub(super) fn mixture(parts: &[(f64, Self)]) -> Self {
        let mut sum = [0.0; 3];
        for (weight, colour) in parts {
            let Some(xyz) = colour.xyz() else { continue };
            for (sum, value) in sum.iter_mut().zip(xyz) {
                *sum += weight * value;
            }
        }
        Self::of(sum)
    }

    fn of([x, y, z]: [f64; 3]) -> Self {
        let sum = x + y + z;
        let colour = Self { x: x / sum, y: y / sum };
        let real = colour.x.is_finite() && colour.y.is_finite();
        if real { colour } else { Self { x: 1.0 / 3.0, y: 0.0 } }
    }

    /// X, Y and Z for a luminance of one; `None` without luminance.
    fn xyz(self) -> Option<[f64; 3]> {
        let Self { x, y } = self;
        let xyz = [x / y, 1.0, (1.0 - x - y) / y];
        xyz.iter().all(|value| value.is_finite()).then_some(xyz)
    }

    /// Linear Rec. 709 for a luminance of one, equal energy being white. A
    /// colour outside of what the primaries can show moves to their edge and
    /// keeps its luminance. `None` without luminance.
    pub(super) fn rgb(self) -> Option<Rgb> {
        // Equal energy adapted to D65 (Bradford), then to the primaries.
        const BANDS: [[f64; 3]; 3] = [
            [3.146_658, -1.666_464, -0.480_194],
            [-0.995_522, 1.955_757, 0.039_765],
            [0.063_595, -0.214_563, 1.150_968],
        ];
        const LUMINANCE: [f64; 3] = [0.222_828, 0.708_691, 0.068_481];
        let xyz = self.xyz()?;
        let bands = BANDS.map(|row| dot(row, xyz).max(0.0));
        let luminance = dot(LUMINANCE, bands);
        let rgb = Rgb::from(bands.map(|band| (band / luminance) as f32));
        rgb.is_finite().then_some(rgb)
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(colour: Colour, x: f64, y: f64, tolerance: f64) {
        let off = (colour.x - x).abs().max((colour.y - y).abs());
        assert!(off < tolerance, "{colour:?} is not {x} {y}");
    }

    #[test]
    fn a_flat_spectrum_is_neutral_and_neutral_is_white() {
        near(Colour::spectrum([380.0, 780.0], &[3.0; 5]).unwrap(), 1.0 / 3.0, 1.0 / 3.0, 1e-12);
        let rgb = Colour::default().rgb().unwrap();
        assert!(rgb.to_array().iter().all(|band| (band - 1.0).abs() < 1e-5), "{rgb:?}");
    }

    #[test]
    fn black_bodies_have_their_published_chromaticities() {
        for (kelvin, x, y) in [
            (2000.0, 0.5267, 0.4133),
            (2856.0, 0.4476, 0.4074),
            (4000.0, 0.3805, 0.3767),
            (6500.0, 0.3135, 0.3237),
            (10000.0, 0.2806, 0.2883),
        ] {
            near(Colour::temperature(kelvin).unwrap(), x, y, 0.001);
        }
        for kelvin in [999.0, -5.0, 1e11] {
            assert!(Colour::temperature(kelvin).is_err(), "{kelvin}");
        }
        near(Colour::temperature(1e10).unwrap(), 0.2399, 0.2340, 0.002);
    }

    #[test]
    fn luminances_of_the_primaries_mix_to_their_white() {
        let primary = |x, y| Colour::chromaticity([x, y]).unwrap();
        let (r, g, b) = (primary(0.64, 0.33), primary(0.29, 0.6), primary(0.15, 0.06));
        near(Colour::mixture(&[(0.265, r), (0.670, g), (0.065, b)]), 0.3331, 0.333, 1e-4);
        near(Colour::mixture(&[(1.0, r), (1.0, g)]), 0.5158, 0.4258, 1e-4);
        let dark = Colour { x: 0.7, y: 0.0 };
        assert_eq!(Colour::mixture(&[(1.0, r), (5.0, dark)]).rgb(), r.rgb());
    }

    #[test]
    fn a_narrow_band_has_the_colour_of_its_wavelength() {
        // The spectral locus at 520 nm, a little smoothed by the table's steps.
        near(Colour::spectrum([519.0, 521.0], &[1.0; 2]).unwrap(), 0.0743, 0.8338, 0.004);
        assert!(Colour::spectrum([500.0, 500.0], &[1.0; 2]).is_err());
        assert!(Colour::spectrum([600.0, 500.0], &[1.0; 2]).is_err());
    }

    #[test]
    fn what_has_no_luminance_has_no_bands() {
        assert_eq!(Colour::spectrum([900.0, 1000.0], &[1.0; 2]).unwrap().rgb(), None);
        assert_eq!(Colour::spectrum([400.0, 700.0], &[0.0; 2]).unwrap().rgb(), None);
        assert_eq!(Colour::mixture(&[(0.0, Colour::default()); 2]).rgb(), None);
        assert_eq!(Colour::chromaticity([0.5, 0.0]).unwrap().rgb(), None);
    }

    #[test]
    fn saturated_colours_keep_their_luminance() {
        let [r, g, b] = Colour { x: 0.05, y: 0.8 }.rgb().unwrap().to_array();
        assert_eq!((r, b > 0.0), (0.0, b > 0.0));
        assert!((0.222_828 * r + 0.708_691 * g + 0.068_481 * b - 1.0).abs() < 1e-5);
        assert!(r >= 0.0 && b >= 0.0 && g > 1.0);
    }

    #[test]
    fn chromaticities_lie_in_their_triangle() {
        for [x, y] in [[-0.1, 0.5], [0.5, -0.1], [0.6, 0.5]] {
            assert!(Colour::chromaticity([x, y]).is_err(), "{x} {y}");
        }
        assert!(Colour::chromaticity([0.7, 0.300_000_1]).is_ok());
    }
}
