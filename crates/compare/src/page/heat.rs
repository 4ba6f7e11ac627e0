//! Maps of error, on one scale for all methods of a scene.

use crate::number::superscript;
use crate::page::image::bytes_as_image;
use maud::{Markup, html};
use traylib_math::Grid;

/// From no error to the largest: lightness grows evenly, so that the order shows
/// without colours too.
const ANCHORS: [[f64; 3]; 6] = [
    [8.0, 10.0, 36.0],
    [58.0, 22.0, 110.0],
    [140.0, 38.0, 112.0],
    [214.0, 72.0, 66.0],
    [248.0, 150.0, 40.0],
    [252.0, 246.0, 172.0],
];

/// Longest scale, in decades.
const DECADES: i32 = 6;

/// A logarithmic scale between two powers of ten.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Scale {
    low: i32,
    high: i32,
}

impl Scale {
    /// Holds nearly all pixels of all maps: from the power of ten below the
    /// hundredth part of them up to the one above the largest but a thousandth.
    pub(crate) fn of(maps: &[Grid<f64>]) -> Self {
        let errors = maps.iter().flat_map(Grid::values).copied();
        let mut errors: Vec<f64> = errors.filter(|e| *e > 0.0 && e.is_finite()).collect();
        if errors.is_empty() {
            return Self { low: -3, high: 0 };
        }
        errors.sort_by(f64::total_cmp);
        let at = |share: f64| errors[((errors.len() - 1) as f64 * share) as usize].log10();
        let high = at(0.999).ceil() as i32;
        let low = (at(0.01).floor() as i32).clamp(high - DECADES, high - 1);
        Self { low, high }
    }

    fn colour(self, error: f64) -> [u8; 3] {
        let share = (error.log10() - f64::from(self.low)) / f64::from(self.high - self.low);
        // The logarithm of zero is −∞; not a number is shown as the worst.
        mixed(if share.is_nan() { 1.0 } else { share.clamp(0.0, 1.0) })
    }

    /// The map of one method.
    pub(crate) fn map(self, errors: &Grid<f64>, name: &str) -> Markup {
        let alt = format!("Where {name} errs");
        bytes_as_image(&errors.map(|&error| self.colour(error)), &alt, None)
    }

    /// The scale drawn, with a tick each decade.
    pub(crate) fn bar(self) -> Markup {
        let stops: Vec<String> =
            ANCHORS.iter().map(|[r, g, b]| format!("rgb({r} {g} {b})")).collect();
        html! {
            div.scale {
                div.ramp style={ "background:linear-gradient(to right," (stops.join(",")) ")" } {}
                div.ticks {
                    @for exponent in self.low..=self.high {
                        @let place = 100 * (exponent - self.low) / (self.high - self.low);
                        span style={ "left:" (place) "%" } { "10" (superscript(exponent)) }
                    }
                }
            }
        }
    }
}

fn mixed(share: f64) -> [u8; 3] {
    let place = share * (ANCHORS.len() - 1) as f64;
    let below = (place as usize).min(ANCHORS.len() - 2);
    let part = place - below as f64;
    let (from, to) = (ANCHORS[below], ANCHORS[below + 1]);
    [0, 1, 2].map(|k| (from[k] + part * (to[k] - from[k])).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_error_is_lighter() {
        let luma = |[r, g, b]: [u8; 3]| {
            0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
        };
        let steps: Vec<f64> = (0..=50).map(|i| luma(mixed(f64::from(i) / 50.0))).collect();
        assert!(steps.is_sorted_by(|a, b| a < b), "{steps:?}");
    }

    #[test]
    fn one_scale_holds_all_maps() {
        let map = |value| Grid::filled(4, 4, value);
        assert_eq!(Scale::of(&[map(0.002), map(30.0)]), Scale { low: -3, high: 2 });
        assert_eq!(Scale::of(&[map(0.0), map(f64::NAN)]), Scale { low: -3, high: 0 });
        assert_eq!(Scale::of(&[map(1e-20), map(1.0)]), Scale { low: -6, high: 0 });
    }

    #[test]
    fn strange_errors_have_a_colour() {
        let scale = Scale { low: -3, high: 0 };
        assert_eq!(scale.colour(0.0), mixed(0.0));
        for error in [f64::NAN, f64::INFINITY, 1e9] {
            assert_eq!(scale.colour(error), mixed(1.0), "{error}");
        }
    }
}
