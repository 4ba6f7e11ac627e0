//! Curves from light to what a screen shows of it.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

/// A curve from light, times the exposure, to the light of a screen whose white is 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tone {
    /// Light as it is, clipped at white.
    #[default]
    Linear,
    /// As film takes it: what is dark or bright with less contrast, so that up to seven times
    /// white can be told apart. Each band by the fit of Narkowicz to the curve of the Academy
    /// Color Encoding System (K. Narkowicz, *ACES Filmic Tone Mapping Curve*, 2015); middle grey
    /// of 0.18 becomes 0.27.
    Filmic,
}

impl Tone {
    /// All curves.
    pub const ALL: [Self; 2] = [Self::Linear, Self::Filmic];

    /// Its name on command lines.
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Filmic => "filmic",
        }
    }

    /// The light of a screen for one band of light. What is below zero or beyond white is left
    /// for whoever clips.
    #[inline]
    pub(super) fn apply(self, light: f32) -> f32 {
        match self {
            Self::Linear => light,
            Self::Filmic => filmic(light),
        }
    }
}

/// The quotient tends to 2.51/2.43, and is that of no number where squares have no bound.
fn filmic(light: f32) -> f32 {
    let x = light.clamp(0.0, 1e6);
    (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14)
}

impl Display for Tone {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Tone {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let named = Self::ALL.into_iter().find(|tone| tone.name() == text);
        named.ok_or("wanted: linear or filmic")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: 0.18·0.4818 / (0.18·1.0274 + 0.14), 2.54/3.16, 20.26/21.44 … and white from 7.3 on.
    #[test]
    fn the_filmic_curve_is_the_published_one() {
        for (light, shown) in
            [(0.0, 0.0), (0.18, 0.266_931), (1.0, 0.803_797), (2.0, 0.914_855), (7.3, 1.000_263)]
        {
            let found = Tone::Filmic.apply(light);
            assert!((found - shown).abs() < 1e-4, "{light} became {found}");
        }
    }

    #[test]
    fn curves_rise_and_have_an_end() {
        for tone in Tone::ALL {
            let shown: Vec<f32> = (0..400).map(|i| tone.apply(0.02 * i as f32)).collect();
            assert!(shown.windows(2).all(|pair| pair[0] < pair[1]), "{tone}");
            assert!(tone.apply(f32::INFINITY) > 1.0 && tone.apply(-1.0) <= 0.0, "{tone}");
            assert!(tone.apply(f32::NAN).is_nan(), "{tone}");
            assert_eq!(tone.name().parse(), Ok(tone));
        }
        assert!("film".parse::<Tone>().is_err());
    }
}
