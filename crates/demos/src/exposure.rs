//! The factor on light in pictures of 256 steps, which may be left to the picture.

use crate::say::say_line;
use std::str::FromStr;
use traylib_io::exposure_of;
use traylib_math::{Grid, Rgb};

/// The factor on light in 8-bit pictures, as a command line wants it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exposure {
    /// This one.
    Factor(f32),
    /// The one that [suits the picture](exposure_of).
    Auto,
}

impl Exposure {
    /// Returns the factor, if it is known before there is a picture.
    pub(crate) fn factor(self) -> Option<f32> {
        match self {
            Self::Factor(factor) => Some(factor),
            Self::Auto => None,
        }
    }

    /// Returns the factor for a picture; `own` is that of its scene, which a black one keeps.
    pub(crate) fn of(self, picture: &Grid<Rgb>, own: f32) -> f32 {
        match self {
            Self::Factor(factor) => factor,
            Self::Auto => exposure_of(picture).unwrap_or(own),
        }
    }

    /// Says which factor was taken, if that was left to the picture.
    pub(crate) fn tell(self, taken: f32) {
        if self == Self::Auto {
            say_line("note", format_args!("exposure taken of the picture: --exposure {taken}"));
        }
    }
}

impl FromStr for Exposure {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text == "auto" {
            return Ok(Self::Auto);
        }
        parse_exposure(text).map(Self::Factor).map_err(|wanted| format!("{wanted}, or auto"))
    }
}

/// Reads a factor on light.
///
/// # Errors
/// Returns a description of the value that was wanted instead.
pub fn parse_exposure(text: &str) -> Result<f32, &'static str> {
    let positive = |exposure: &f32| *exposure > 0.0 && exposure.is_finite();
    text.parse().ok().filter(positive).ok_or("wanted a number above 0, as 0.5 or 2")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exposures_are_positive_numbers() {
        assert_eq!(parse_exposure("0.25"), Ok(0.25));
        for bad in ["0", "-1", "inf", "NaN", "x"] {
            assert!(parse_exposure(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn a_black_picture_keeps_its_own() {
        let grey = |value| Grid::filled(2, 2, Rgb::splat(value));
        assert_eq!(Exposure::Auto.of(&grey(0.36), 7.0), 0.5);
        assert_eq!(Exposure::Auto.of(&grey(0.0), 7.0), 7.0);
        assert_eq!(Exposure::Factor(3.0).of(&grey(0.36), 7.0), 3.0);
        assert_eq!(("auto".parse(), "2".parse()), (Ok(Exposure::Auto), Ok(Exposure::Factor(2.0))));
        assert!("Auto".parse::<Exposure>().is_err());
    }
}
