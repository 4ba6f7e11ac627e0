//! The words after a keyword as numbers.

use super::Cause;
use super::error::shown;

/// A finite number, written as C does.
pub(super) fn number(word: &str) -> Result<f64, Cause> {
    let value = word.parse().ok().filter(|value: &f64| value.is_finite());
    value.ok_or_else(|| Cause::NotANumber(shown(word)))
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
