//! Times as people write them.

use std::time::Duration;

/// Reads `90s`, `5m`, `1.5h`.
///
/// # Errors
/// What was wanted instead.
pub fn parse_duration(text: &str) -> Result<Duration, String> {
    let error = || String::from("wanted a positive number with its unit, as 90s, 5m or 1.5h");
    let (number, unit) = text.split_at_checked(text.len().saturating_sub(1)).ok_or_else(error)?;
    let seconds = match unit {
        "s" => 1.0,
        "m" => 60.0,
        "h" => 3600.0,
        _ => return Err(error()),
    };
    let number: f64 = number.parse().map_err(|_| error())?;
    match Duration::try_from_secs_f64(number * seconds) {
        Ok(time) if !time.is_zero() => Ok(time),
        _ => Err(error()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_carry_their_unit() {
        assert_eq!(parse_duration("90s"), Ok(Duration::from_secs(90)));
        assert_eq!(parse_duration("1.5h"), Ok(Duration::from_mins(90)));
        for bad in ["", "90", "s", "-1s", "0s", "infs", "nans", "1e300h", "5µ"] {
            assert!(parse_duration(bad).is_err(), "{bad}");
        }
    }
}
