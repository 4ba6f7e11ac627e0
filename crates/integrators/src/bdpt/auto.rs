//! The choices that are left to a plan.

use std::fmt;
use std::str::FromStr;

/// The choice to leave the method to a plan, and what else the plan may do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Auto {
    /// The part of all light that may be lost by a longest path, which the plan then chooses.
    pub may_lose: MayLose,
}

/// A part of all light, in millionths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MayLose {
    millionths: u32,
}

impl MayLose {
    /// No light.
    pub const NOTHING: Self = Self { millionths: 0 };

    /// The part itself.
    pub fn part(self) -> f64 {
        1e-6 * f64::from(self.millionths)
    }
}

/// Writes it as after `--max-depth`: `auto:0.5%`.
impl fmt::Display for MayLose {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "auto:{}%", f64::from(self.millionths) / 1e4)
    }
}

impl FromStr for MayLose {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let percent = text.strip_prefix("auto:").and_then(|rest| rest.strip_suffix('%'));
        let percent = percent.and_then(|percent| percent.parse::<f64>().ok());
        percent
            .filter(|percent| (1e-4..=50.0).contains(percent))
            .map(|percent| Self { millionths: (percent * 1e4).round() as u32 })
            .ok_or("wanted: a number of edges from 1 on, or auto:0.5%, at most 50 %")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_percents() {
        let half: MayLose = "auto:0.5%".parse().unwrap();
        assert_eq!((half.part(), half.to_string().as_str()), (0.005, "auto:0.5%"));
        for text in ["auto", "auto:0%", "auto:51%", "auto:x%", "0.5%", "auto:0.5"] {
            assert!(text.parse::<MayLose>().is_err(), "{text}");
        }
    }
}
