//! Numbers as people read them.

use crate::results::{Estimate, MethodResults};

/// The text in place of a number that does not exist.
const NONE: &str = "–";
/// The text in place of an interval of which neither end exists.
const NOT_KNOWN: &str = "not known";

/// An exponent in raised digits.
pub(crate) fn superscript(exponent: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(u32::from(digit) - u32::from('0') + u32::from('⁰')).unwrap_or(c),
    };
    exponent.to_string().chars().map(raised).collect()
}

/// A number with so many digits that matter: `0.0123`, `1.23·10⁻⁵`.
pub(crate) fn significant(value: f64, digits: u8) -> String {
    if !value.is_finite() {
        return NONE.into();
    }
    if value == 0.0 {
        return "0".into();
    }
    let digits = digits.max(1) - 1;
    let places = usize::from(digits);
    // Rounded first, or 9.996 would be 10.00.
    let scientific = format!("{value:.places$e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = if (-3..5).contains(&exponent) {
        let decimals = (i32::from(digits) - exponent).max(0) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{mantissa}·10{}", superscript(exponent))
    };
    text.replace('-', "−")
}

/// A number that somebody chose, as it was written: `0.1`, `0.015`.
pub(crate) fn chosen(value: f64) -> String {
    if (1e-4..1e5).contains(&value) { value.to_string() } else { significant(value, 1) }
}

/// Rounded to digits that matter, also before the point: `6.5`, `390`, `67000`.
fn rounded(value: f64, digits: usize) -> String {
    let places = digits - 1;
    significant(format!("{value:.places$e}").parse().unwrap_or(value), digits as u8)
}

/// The time of a method relative to that of the best, in the same words wherever it is told.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Ratio {
    /// It is the best.
    One,
    /// Only that it takes longer than this is known.
    AtLeast(String),
    /// Only that it takes less is.
    AtMost(String),
    /// Not even a bound is known.
    Unknown,
    /// A number and its interval.
    Between([String; 3]),
}

/// The ratio of a method's cost to that of the best.
pub(crate) fn ratio(method: &MethodResults) -> Ratio {
    let Estimate { value, low, high } = method.cost_ratio;
    if low == high {
        return Ratio::One;
    }
    match (method.cost_ratio.knows_low(), method.cost_ratio.knows_high()) {
        (true, true) => Ratio::Between(apart([low, value, high])),
        (true, false) => Ratio::AtLeast(rounded(low, 2)),
        (false, true) => Ratio::AtMost(rounded(high, 2)),
        (false, false) => Ratio::Unknown,
    }
}

/// Two digits, or as many more as it takes that an interval has a width and is seen to
/// hold one or not to.
fn apart([low, value, high]: [f64; 3]) -> [String; 3] {
    let one = |digits| rounded(1.0, digits);
    let texts = |digits| [value, low, high].map(|number| rounded(number, digits));
    let told = |digits: usize| {
        let [middle, from, to] = texts(digits);
        let differ = from != middle && middle != to;
        let sided = (low == 1.0 || from != one(digits)) && (high == 1.0 || to != one(digits));
        differ && sided
    };
    texts((2..5).find(|digits| told(*digits)).unwrap_or(5))
}

impl Ratio {
    /// `1.3 times as long (1.2 to 1.4)`.
    pub(crate) fn as_long(&self) -> String {
        match self {
            Self::One => "the best".into(),
            Self::AtLeast(low) => format!("at least {low} times as long"),
            Self::AtMost(high) => format!("at most {high} times as long"),
            Self::Unknown => "an unknown number of times as long".into(),
            Self::Between([value, low, high]) => {
                format!("{value} times as long ({low} to {high})")
            }
        }
    }

    /// `1.3 (1.2 to 1.4)`, for a table.
    pub(crate) fn cell(&self) -> String {
        match self {
            Self::One => "1".into(),
            Self::AtLeast(low) => format!("at least {low}"),
            Self::AtMost(high) => format!("at most {high}"),
            Self::Unknown => NOT_KNOWN.into(),
            Self::Between([value, low, high]) => format!("{value} ({low} to {high})"),
        }
    }
}

/// Three digits.
pub(crate) fn short(value: f64) -> String {
    significant(value, 3)
}

/// `1.23 (1.10–1.40)`, `1.23 (at least 1.10)` where an end is not known; the number alone
/// where there is no doubt.
pub(crate) fn interval(estimate: Estimate) -> String {
    interval_of(estimate, 3)
}

/// Writes an interval with another number of digits.
pub(crate) fn interval_of(estimate: Estimate, digits: u8) -> String {
    let value = significant(estimate.value, digits);
    if estimate.low >= estimate.high || !estimate.value.is_finite() {
        return value;
    }
    format!("{value} ({})", between(estimate, |end| significant(end, digits)))
}

/// Writes an interval by those of its ends that are known.
fn between(estimate: Estimate, text: impl Fn(f64) -> String) -> String {
    let [low, high] = [estimate.low, estimate.high].map(text);
    match (estimate.knows_low(), estimate.knows_high()) {
        (true, true) => format!("{low}–{high}"),
        (true, false) => format!("at least {low}"),
        (false, true) => format!("at most {high}"),
        (false, false) => NOT_KNOWN.into(),
    }
}

/// Seconds with a unit that suits them: `3.4 ms`, `12 s`, `1.5 h`.
pub(crate) fn seconds(seconds: f64) -> String {
    if !seconds.is_finite() {
        return NONE.into();
    }
    let (unit, name) = unit(seconds);
    format!("{} {name}", significant(seconds / unit, 2))
}

/// `12 s (10–15)`, all three in the unit of the first; ends as of [`interval`].
pub(crate) fn seconds_interval(estimate: Estimate) -> String {
    let Estimate { value, low, high } = estimate;
    if !value.is_finite() || low >= high {
        return seconds(value);
    }
    let unit = unit(value).0;
    format!("{} ({})", seconds(value), between(estimate, |end| significant(end / unit, 2)))
}

fn unit(seconds: f64) -> (f64, &'static str) {
    match seconds {
        s if s < 1e-3 => (1e-6, "µs"),
        s if s < 0.995 => (1e-3, "ms"),
        s if s < 120.0 => (1.0, "s"),
        s if s < 7200.0 => (60.0, "min"),
        s if s < 172_800.0 => (3600.0, "h"),
        _ => (86_400.0, "d"),
    }
}

/// Bytes in kB, MB, GB of a thousand.
pub(crate) fn bytes(bytes: u64) -> String {
    let (number, prefix) = with_prefix(bytes as f64);
    format!("{number}\u{a0}{prefix}B")
}

/// A number with k, M or G where it is large, behind a blank that does not break.
pub(crate) fn prefixed(value: f64) -> String {
    match with_prefix(value) {
        (number, "") => number,
        (number, prefix) => format!("{number}\u{a0}{prefix}"),
    }
}

fn with_prefix(value: f64) -> (String, &'static str) {
    let (unit, prefix) = match value.abs() {
        v if v >= 1e9 => (1e9, "G"),
        v if v >= 1e6 => (1e6, "M"),
        v if v >= 1e3 => (1e3, "k"),
        _ => (1.0, ""),
    };
    (short(value / unit), prefix)
}

/// A share as per cent: tenths of them, and more digits below one.
pub(crate) fn percent(share: f64) -> String {
    let number = match 100.0 * share {
        value if !value.is_finite() => return NONE.into(),
        value if value.abs() >= 1.0 => format!("{value:.1}").replace('-', "−"),
        value => significant(value, 2),
    };
    format!("{number}\u{a0}%")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_digits_are_enough_to_speak_of() {
        for (value, text) in [(6.46, "6.5"), (387.9, "390"), (66_600.0, "67000"), (1.0, "1.0")] {
            assert_eq!(rounded(value, 2), text);
        }
    }

    #[test]
    fn intervals_keep_a_width_and_their_side_of_one() {
        let cases = [
            ([1.2, 1.3, 1.4], ["1.3", "1.2", "1.4"]),
            ([1.29, 1.31, 1.33], ["1.31", "1.29", "1.33"]),
            ([1.004, 1.2, 1.4], ["1.200", "1.004", "1.400"]),
            ([0.98, 1.14, 1.3], ["1.1", "0.98", "1.3"]),
            ([8.2, 9.0, 9.9], ["9.0", "8.2", "9.9"]),
            ([66_400.0, 66_600.0, 66_800.0], ["66600", "66400", "66800"]),
        ];
        for (numbers, texts) in cases {
            assert_eq!(apart(numbers), texts);
        }
    }

    #[test]
    fn digits_that_matter() {
        let cases = [
            (0.012_345, "0.0123"),
            (9.996, "10.0"),
            (123_456.0, "1.23·10⁵"),
            (-1.5e-12, "−1.50·10⁻¹²"),
            (0.0, "0"),
            (f64::NAN, "–"),
            (f64::INFINITY, "–"),
        ];
        for (value, text) in cases {
            assert_eq!(short(value), text);
        }
    }

    #[test]
    fn chosen_numbers_stay_as_they_are() {
        let texts = [0.1, 0.015, 1e-5].map(chosen);
        assert_eq!(texts, ["0.1", "0.015", "1·10⁻⁵"]);
    }

    #[test]
    fn times_have_a_unit() {
        let cases = [(2.5e-7, "0.25 µs"), (0.0123, "12 ms"), (99.6, "100 s"), (600.0, "10 min")];
        for (value, text) in cases {
            assert_eq!(seconds(value), text);
        }
        let estimate = Estimate { value: 12.0, low: 10.0, high: 15.0 };
        assert_eq!(seconds_interval(estimate), "12 s (10–15)");
        assert_eq!(seconds_interval(Estimate { value: f64::INFINITY, ..estimate }), "–");
    }

    #[test]
    fn an_end_of_which_nothing_is_known_is_not_told() {
        let known = Estimate { value: 316.0, low: 103.0, high: 500.0 };
        let cases = [
            (known.without_high(), "316 (at least 103)", "32 ms (at least 10)"),
            (known.without_low(), "316 (at most 500)", "32 ms (at most 50)"),
            (known.without_low().without_high(), "316 (not known)", "32 ms (not known)"),
        ];
        for (estimate, text, time) in cases {
            assert_eq!(interval(estimate), text);
            assert_eq!(seconds_interval(estimate.map(|v| v / 1e4)), time);
            // Logarithms and back, as in the bootstrap.
            let again = estimate.map(|v| v.ln().exp());
            assert_eq!(interval(again), text);
        }
    }

    #[test]
    fn one_has_no_interval() {
        assert_eq!(interval(Estimate { value: 1.0, low: 1.0, high: 1.0 }), "1.00");
    }

    #[test]
    fn sizes_and_shares() {
        assert_eq!([bytes(1_500_000), bytes(12)], ["1.50\u{a0}MB", "12.0\u{a0}B"]);
        assert_eq!([prefixed(2e6), prefixed(12.0)], ["2.00\u{a0}M", "12.0"]);
        let texts = [0.1234, 0.996, -0.41, 0.000_51, f64::NAN].map(percent);
        let expected = ["12.3\u{a0}%", "99.6\u{a0}%", "−41.0\u{a0}%", "0.051\u{a0}%", "–"];
        assert_eq!(texts, expected);
    }
}
