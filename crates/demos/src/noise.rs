//! An error that is good enough.

use std::str::FromStr;

/// The error of a picture, as a part of its light, at which a rendering may end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise(f64);

/// The least passes: of fewer the error is not known well enough.
const FIRST: u32 = 16;

/// Within each doubling of the passes the error is asked for so many times.
const LOOKS: u32 = 16;

impl Noise {
    /// Tells whether the error is asked for after so many passes: of them alone, so that a
    /// rendering that goes on from a checkpoint ends where it would have.
    pub(crate) fn is_asked(passes: u32) -> bool {
        let step = (passes.max(1).ilog2().saturating_sub(LOOKS.ilog2())).min(31);
        passes >= FIRST && passes.is_multiple_of(1 << step)
    }

    /// Tells whether an estimated error is no more; one that is not known is.
    pub(crate) fn allows(self, error: Option<f64>) -> bool {
        error.is_some_and(|error| error <= self.0)
    }
}

impl std::fmt::Display for Noise {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", self.0)
    }
}

impl FromStr for Noise {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (number, unit) = text.strip_suffix('%').map_or((text, 1.0), |number| (number, 0.01));
        let error = number.trim().parse::<f64>().ok().map(|number| number * unit);
        error.filter(|error| *error > 0.0 && *error < 1.0).map(Self).ok_or("wanted as 0.01 or 1%")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_asked_for_now_and_then() {
        let asked: Vec<u32> = (0..72).filter(|&passes| Noise::is_asked(passes)).collect();
        assert_eq!(asked[..3], [16, 17, 18]);
        assert_eq!(asked[asked.len() - 4..], [60, 62, 64, 68]);
        assert!(Noise::is_asked(1 << 31) && !Noise::is_asked(u32::MAX));
    }

    #[test]
    fn errors_are_parts_or_per_cent() {
        assert_eq!("0.02".parse(), Ok(Noise(0.02)));
        assert_eq!("2%".parse(), Ok(Noise(0.02)));
        for bad in ["0", "-1%", "100%", "1", "NaN", "", "%"] {
            assert!(bad.parse::<Noise>().is_err(), "{bad}");
        }
        let two: Noise = "2%".parse().unwrap();
        assert!(two.allows(Some(0.02)) && !two.allows(Some(0.021)) && !two.allows(None));
    }
}
