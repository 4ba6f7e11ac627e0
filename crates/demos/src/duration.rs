//! Times as people write them.

use std::time::Duration;

/// Units with their seconds, the longest first.
const UNITS: [(char, f64); 3] = [('h', 3600.0), ('m', 60.0), ('s', 1.0)];

/// Reads `90s`, `5m`, `1.5h` or `1m30s`: numbers with their units, the longest unit first.
///
/// # Errors
/// Returns a description of the value that was wanted instead.
pub fn parse_duration(text: &str) -> Result<Duration, String> {
    seconds(text)
        .and_then(|seconds| Duration::try_from_secs_f64(seconds).ok())
        .filter(|time| !time.is_zero())
        .ok_or_else(|| "wanted a positive number with its unit, as 90s, 1m30s or 1.5h".into())
}

fn seconds(text: &str) -> Option<f64> {
    let (mut rest, mut sum) = (text, None);
    for (unit, seconds) in UNITS {
        if let Some((number, after)) = rest.split_once(unit) {
            // Digits and a point alone: what else a number may be is no time.
            let is_plain = number.chars().all(|c| c.is_ascii_digit() || c == '.');
            let number: f64 = number.parse().ok().filter(|_| is_plain)?;
            sum = Some(sum.unwrap_or(0.0) + number * seconds);
            rest = after;
        }
    }
    sum.filter(|_| rest.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_carry_their_units() {
        for (text, seconds) in
            [("90s", 90), ("5m", 300), ("1.5h", 5400), ("1m30s", 90), ("1h0m.5s", 3600)]
        {
            assert_eq!(parse_duration(text).map(|time| time.as_secs()), Ok(seconds), "{text}");
        }
        for bad in [
            "", "90", "s", "-1s", "0s", "0m0s", "infs", "nans", "1e300h", "5µ", "30s1m", "1m30",
            "1m2m", "m30s",
        ] {
            assert!(parse_duration(bad).is_err(), "{bad}");
        }
    }
}
