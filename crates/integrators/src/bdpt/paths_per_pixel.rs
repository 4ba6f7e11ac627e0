//! The number of light paths of a pass.

use std::fmt;
use std::str::FromStr;

/// Light paths of a pass for each pixel of its film, in thousandths: at least one of them, so
/// that settings can be compared and spelled exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PathsPerPixel {
    thousandths: u32,
}

impl PathsPerPixel {
    /// One light path for each pixel.
    pub const ONE: Self = Self::of_thousandths(1000);

    /// Returns so many thousandths of one; at least one.
    pub const fn of_thousandths(thousandths: u32) -> Self {
        Self { thousandths: if thousandths == 0 { 1 } else { thousandths } }
    }

    /// The number itself.
    pub fn ratio(self) -> f64 {
        f64::from(self.thousandths) / 1000.0
    }

    /// Returns the number of light paths over a film of so many pixels: at least one.
    pub fn over(self, pixels: u32) -> u32 {
        let paths = u64::from(pixels) * u64::from(self.thousandths) / 1000;
        u32::try_from(paths).unwrap_or(u32::MAX).max(1)
    }
}

impl fmt::Display for PathsPerPixel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.ratio())
    }
}

impl FromStr for PathsPerPixel {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const MOST: f64 = 1000.0;
        let ratio = text.parse().ok().filter(|ratio: &f64| (0.001..=MOST).contains(ratio));
        ratio
            .map(|ratio| Self::of_thousandths((1000.0 * ratio).round() as u32))
            .ok_or("wanted: light paths a pixel, from 0.001 to 1000")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_number_are_the_same() {
        for (text, thousandths) in [("0.25", 250), ("1", 1000), ("2", 2000), ("0.001", 1)] {
            let read: PathsPerPixel = text.parse().unwrap();
            assert_eq!(read, PathsPerPixel::of_thousandths(thousandths));
            assert_eq!(read.to_string(), text);
        }
        for text in ["0", "-1", "NaN", "inf", "1001", "many", ""] {
            assert!(text.parse::<PathsPerPixel>().is_err(), "{text}");
        }
    }

    #[test]
    fn there_is_at_least_one_path() {
        let quarter = PathsPerPixel::of_thousandths(250);
        assert_eq!([1, 4, 10, 4000].map(|pixels| quarter.over(pixels)), [1, 1, 2, 1000]);
        assert_eq!(PathsPerPixel::ONE.over(u32::MAX), u32::MAX);
        assert_eq!(PathsPerPixel::of_thousandths(2000).over(u32::MAX), u32::MAX);
    }
}
