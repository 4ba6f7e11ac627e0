//! Parameters that would create energy or NaN.

use traylib_math::Rgb;

/// The reason why a material cannot be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A reflectance band is negative, above one or not a number.
    #[error("{name} {value:?} must lie between 0 and 1 in each band")]
    Reflectance {
        /// The parameter.
        name: &'static str,
        /// The value that was given.
        value: [f32; 3],
    },
    /// The parts together reflect more than arrives.
    #[error("{first} + {second} reflects up to {sum}, more than arrives; scale them to a sum of 1")]
    Energy {
        /// One part.
        first: &'static str,
        /// The other part.
        second: &'static str,
        /// The largest band of their sum.
        sum: f32,
    },
    /// An exponent outside the range for which the lobe is accurate.
    #[error("exponent {0} must lie between 0 and 1e6; a sharper lobe is a Mirror")]
    Exponent(f32),
    /// An index of refraction that makes no boundary, or none that there is.
    #[error("index {0} must lie between 0.1 and 10 and not be 1")]
    Index(f32),
}

/// Rounding that a sum of decimal fractions in `f32` may show.
const SUM_SLACK: f32 = 1e-6;

/// Refuses a reflectance outside [0, 1].
pub(crate) fn check_reflectance(name: &'static str, value: Rgb) -> Result<(), Error> {
    let sound = value.to_array().iter().all(|band| (0.0..=1.0).contains(band));
    if sound { Ok(()) } else { Err(Error::Reflectance { name, value: value.to_array() }) }
}

/// Refuses two parts that together exceed one in a band.
pub(crate) fn check_energy(
    (first, a): (&'static str, Rgb),
    (second, b): (&'static str, Rgb),
) -> Result<(), Error> {
    check_reflectance(first, a)?;
    check_reflectance(second, b)?;
    let sum = (a + b).max_band();
    if sum > 1.0 + SUM_SLACK { Err(Error::Energy { first, second, sum }) } else { Ok(()) }
}

/// Refuses an exponent for which the lobe would lose accuracy.
pub(crate) fn check_exponent(exponent: f32) -> Result<(), Error> {
    if (0.0..=1e6).contains(&exponent) { Ok(()) } else { Err(Error::Exponent(exponent)) }
}
