//! The words after a keyword as numbers.

use super::Cause;
use super::error::shown;

/// Digits that tell a number, to within a few thousandths of its last bit.
const DIGITS: usize = 19;

/// A finite number, written as C does. Of its digits the first 19 count: to round by
/// more takes a thousand times longer.
pub(super) fn number(word: &str) -> Result<f64, Cause> {
    let long = if word.len() > DIGITS { shortened(word) } else { None };
    let value = long.as_deref().unwrap_or(word).parse();
    let value = value.ok().filter(|value: &f64| value.is_finite());
    value.ok_or_else(|| Cause::NotANumber(shown(word)))
}

/// The first digits of a number that has more, as `-1234e5`; `None` for any other word.
fn shortened(word: &str) -> Option<String> {
    let (mantissa, exponent) = word.split_once(['e', 'E']).unwrap_or((word, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let sign = if whole.starts_with('-') { "-" } else { "" };
    let whole = whole.strip_prefix(['-', '+']).unwrap_or(whole).trim_start_matches('0');
    let digits = || whole.bytes().chain(fraction.bytes());
    let zeros = digits().take_while(|&digit| digit == b'0').count();
    let count = whole.len() + fraction.len() - zeros;
    if count <= DIGITS || !digits().all(|digit| digit.is_ascii_digit()) {
        return None;
    }
    let first: String = digits().skip(zeros).take(DIGITS).map(char::from).collect();
    let left_out = i64::try_from(count - DIGITS).ok()? - i64::try_from(fraction.len()).ok()?;
    let exponent = exponent.parse::<i64>().ok()?.checked_add(left_out)?;
    Some(format!("{sign}{first}e{exponent}"))
}

/// An integer of 0 or more.
pub(super) fn count(word: &str) -> Result<u64, Cause> {
    word.parse().map_err(|_| Cause::NotACount(shown(word)))
}

/// All words as numbers, if there are `N` of them.
pub(super) fn numbers<const N: usize>(
    words: &[&str],
    expected: &'static str,
) -> Result<[f64; N], Cause> {
    let words: &[&str; N] = exactly(words, expected)?;
    let mut values = [0.0; N];
    for (value, word) in values.iter_mut().zip(words) {
        *value = number(word)?;
    }
    Ok(values)
}

/// The words, if there are `N` of them.
pub(super) fn exactly<'a, 'w, const N: usize>(
    words: &'a [&'w str],
    expected: &'static str,
) -> Result<&'a [&'w str; N], Cause> {
    words.try_into().map_err(|_| Cause::Arguments { expected, found: words.len() })
}

/// The value, if it is `fine`.
pub(super) fn within(
    fine: bool,
    value: f64,
    what: &'static str,
    range: &'static str,
) -> Result<f64, Cause> {
    if fine { Ok(value) } else { Err(Cause::Range { what, value, range }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_c_writes_them() {
        for (word, value) in [("1e-3", 0.001), (".5", 0.5), ("+1", 1.0), ("5.", 5.0)] {
            assert_eq!(number(word).unwrap(), value, "{word}");
        }
        assert!(number("-0").unwrap().is_sign_negative());
        for word in ["nan", "inf", "-INFINITY", "1e999", "", "x", "1,5", "0x10", "1 "] {
            assert!(matches!(number(word), Err(Cause::NotANumber(_))), "{word}");
        }
    }

    #[test]
    fn numbers_of_many_digits_are_read_by_their_first() {
        for (word, short) in [
            ("-0.0012345678901234567899", "-1234567890123456789e-21"),
            ("12345678901234567890123.5e-3", "1234567890123456789e1"),
            ("+1.23456789012345678999E7", "1234567890123456789e-11"),
        ] {
            assert_eq!(shortened(word).as_deref(), Some(short), "{word}");
            assert_eq!(number(word).unwrap(), word.parse::<f64>().unwrap(), "{word}");
        }
        for word in ["0.00000000000000000000000001", "-12345678901234567.89", "1e00000000000000005"]
        {
            assert_eq!(shortened(word), None, "{word}");
        }
        let zeros = "0".repeat(3000);
        assert_eq!(number(&format!("-{zeros}.{zeros}")).unwrap().to_bits(), (-0.0_f64).to_bits());
        assert_eq!(
            number(&format!("0.{zeros}12345678901234567891e3001")).unwrap(),
            1.234_567_890_123_456_8
        );
        for word in
            ["1234567890123456789012e", "1.2345678901234567890.1", "123456789012345678901e999"]
        {
            assert!(number(word).is_err(), "{word}");
        }
    }

    #[test]
    fn counts_are_integers_of_zero_or_more() {
        assert_eq!((count("+3").unwrap(), count("0").unwrap()), (3, 0));
        for word in ["-1", "1.0", "", "99999999999999999999", "x"] {
            assert!(matches!(count(word), Err(Cause::NotACount(_))), "{word}");
        }
    }

    #[test]
    fn long_words_are_not_repeated_in_full() {
        let message = number(&"é".repeat(5000)).unwrap_err().to_string();
        assert!(message.len() < 200, "{message}");
    }
}
