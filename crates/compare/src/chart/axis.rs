//! Logarithmic axes.

use crate::number::{significant, superscript};
use crate::results::{LEAST_ERROR, Point};
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// A logarithmic axis, at least a decade long.
#[derive(Clone, Debug)]
pub(crate) struct Decades {
    /// Logarithms of both ends, to base ten.
    low: f64,
    high: f64,
}

impl Decades {
    /// Holds all those of the values that can be drawn, and a little more.
    pub(crate) fn around(values: impl IntoIterator<Item = f64>) -> Self {
        let logs = values.into_iter().filter(|v| drawable(*v)).map(f64::log10);
        let (low, high) = logs
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        if low > high {
            return Self { low: -1.0, high: 1.0 };
        }
        let missing = (1.0 - (high - low)).max(0.0) / 2.0;
        let margin = missing + 0.03 * (high - low).max(1.0);
        Self { low: low - margin, high: high + margin }
    }

    /// Makes the axis longer by a fifth at the low end, so that the shortest bar shows.
    pub(crate) fn with_room_below(self) -> Self {
        Self { low: self.low - 0.2 * (self.high - self.low), ..self }
    }

    /// Both ends.
    pub(crate) fn ends(&self) -> (f64, f64) {
        (10_f64.powf(self.low), 10_f64.powf(self.high))
    }

    /// Tells whether a value lies on it.
    pub(crate) fn holds(&self, value: f64) -> bool {
        drawable(value) && (self.low..=self.high).contains(&value.log10())
    }

    /// Powers of ten, and twice and five times those where the axis is short.
    fn ticks(&self) -> Vec<f64> {
        let length = self.high - self.low;
        let step = (length / 8.0).ceil().max(1.0) as i32;
        let factors: &[f64] = if length < 2.0 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let exponents = self.low.floor() as i32..=self.high.ceil() as i32;
        exponents
            .filter(|exponent| exponent.rem_euclid(step) == 0)
            .flat_map(|exponent| factors.iter().map(move |f| f * 10_f64.powi(exponent)))
            .filter(|tick| self.holds(*tick))
            .collect()
    }
}

/// Tells whether a point has a place on logarithmic axes; an error that is none has not.
pub(crate) fn visible(point: &Point) -> bool {
    drawable(point.seconds) && drawable(point.error.value) && point.error.value > LEAST_ERROR
}

/// Tells whether a value has a logarithm.
pub(crate) fn drawable(value: f64) -> bool {
    value.is_finite() && value > 0.0
}

impl Ranged for Decades {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    /// Values outside are moved to the nearer end, those that cannot be drawn to the low one.
    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let log = if drawable(*value) { value.log10() } else { self.low };
        let share = ((log - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        from + (share * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() { Vec::new() } else { self.ticks() }
    }

    fn range(&self) -> Range<f64> {
        let (low, high) = self.ends();
        low..high
    }
}

impl ValueFormatter<f64> for Decades {
    fn format_ext(&self, value: &f64) -> String {
        label(*value)
    }
}

/// A tick in words: `0.05`, `200`, `10⁻⁵`, `2·10⁴`.
pub(crate) fn label(value: f64) -> String {
    // Just above, lest 10⁻³ count as a little less than itself.
    let exponent = (value.log10() + 1e-9).floor() as i32;
    let mantissa = value / 10_f64.powi(exponent);
    match exponent {
        -2..=3 => significant(value, 1),
        _ if (mantissa - 1.0).abs() < 1e-6 => format!("10{}", superscript(exponent)),
        _ => format!("{mantissa:.0}·10{}", superscript(exponent)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_few_and_readable() {
        let texts = |low: f64, high: f64| -> Vec<String> {
            Decades::around([low, high]).ticks().into_iter().map(label).collect()
        };
        assert_eq!(texts(1e-4, 1.0), ["10⁻⁴", "10⁻³", "0.01", "0.1", "1"]);
        assert_eq!(texts(2.0, 3.0), ["1", "2", "5"]);
        assert!(texts(1e-12, 1e12).len() <= 9);
    }

    #[test]
    fn nothing_drawable_still_makes_an_axis() {
        for values in [vec![], vec![0.0], vec![f64::NAN, -1.0, f64::INFINITY]] {
            assert!(!Decades::around(values).ticks().is_empty());
        }
    }

    #[test]
    fn outside_is_moved_to_the_end() {
        let axis = Decades::around([1.0, 100.0]);
        for (value, pixel) in [(0.0, 0), (-1.0, 0), (f64::NAN, 0), (1e9, 1000), (10.0, 500)] {
            assert_eq!(axis.map(&value, (0, 1000)), pixel, "{value}");
        }
    }
}
