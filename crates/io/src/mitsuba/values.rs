//! Numbers, vectors and colours of attributes.

use super::{Fault, Value};
use crate::srgb;
use crate::suggest::shown;

/// Numbers that one attribute may have.
const MOST: usize = 4096;

/// A finite number.
pub(super) fn number(text: &str) -> Result<f64, Fault> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| unreadable(text, "a finite number"))
}

/// `true` or `false`.
pub(super) fn boolean(text: &str) -> Result<bool, Fault> {
    match text.trim().to_ascii_lowercase().as_str() {
        "true" => Ok(true),
        "false" => Ok(false),
        _ => Err(unreadable(text, "`true` or `false`")),
    }
}

/// Numbers between commas and blanks.
pub(super) fn numbers(text: &str) -> Result<Vec<f64>, Fault> {
    let words = text.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty());
    let numbers = words.take(MOST + 1).map(number).collect::<Result<Vec<_>, _>>()?;
    if numbers.len() > MOST {
        return Err(Fault::TooMany { what: "numbers in one value", limit: MOST });
    }
    Ok(numbers)
}

/// Three numbers.
pub(super) fn vector(text: &str) -> Result<[f64; 3], Fault> {
    numbers(text)?.try_into().map_err(|_| unreadable(text, "three numbers"))
}

/// One number for all of three, or three.
pub(super) fn one_or_three(text: &str) -> Result<[f64; 3], Fault> {
    match *numbers(text)?.as_slice() {
        [all] => Ok([all; 3]),
        [x, y, z] => Ok([x, y, z]),
        _ => Err(unreadable(text, "one number or three")),
    }
}

/// A colour as numbers or as `#rrggbb`, coded for screens or linear.
pub(super) fn colour(text: &str, is_coded: bool) -> Result<Value, Fault> {
    let bands = match text.trim().strip_prefix('#') {
        Some(digits) => hexadecimal(digits).ok_or_else(|| unreadable(text, "a colour"))?,
        None => one_or_three(text)?,
    };
    let linear = |band: f64| f64::from(srgb::decode(band as f32));
    Ok(Value::Colour(if is_coded { bands.map(linear) } else { bands }))
}

fn hexadecimal(digits: &str) -> Option<[f64; 3]> {
    if digits.len() != 6 || !digits.is_ascii() {
        return None;
    }
    let band = |at: usize| u8::from_str_radix(&digits[at..at + 2], 16).ok();
    let bands = [band(0)?, band(2)?, band(4)?];
    Some(bands.map(|band| f64::from(band) / 255.0))
}

/// A spectrum: one number, in old files also three that are a colour, or `wavelength:value` pairs.
pub(super) fn spectrum(text: &str) -> Result<Value, Fault> {
    if text.contains(':') {
        return pairs(text).map(Value::Spectrum);
    }
    match *numbers(text)?.as_slice() {
        [all] => Ok(Value::Even(all)),
        [r, g, b] => Ok(Value::Colour([r, g, b])),
        _ => Err(unreadable(text, "a number or `wavelength:value` pairs")),
    }
}

fn pairs(text: &str) -> Result<Vec<[f64; 2]>, Fault> {
    let mut pairs = Vec::new();
    let words = text.split(|c: char| c == ',' || c.is_whitespace()).filter(|word| !word.is_empty());
    for word in words.take(MOST) {
        let pair =
            word.split_once(':').ok_or_else(|| unreadable(word, "a `wavelength:value` pair"))?;
        let pair = [number(pair.0)?, number(pair.1)?];
        if pairs.last().is_some_and(|last: &[f64; 2]| last[0] >= pair[0]) {
            return Err(unreadable(word, "at a longer wavelength than the one before"));
        }
        pairs.push(pair);
    }
    Ok(pairs)
}

/// The fault of a text that is not what it should be.
pub(super) fn unreadable(text: &str, expected: &'static str) -> Fault {
    Fault::Unreadable { text: shown(text), expected }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_between_commas_and_blanks() {
        assert_eq!(numbers("1, 2\n3,-4e1"), Ok(vec![1.0, 2.0, 3.0, -40.0]));
        assert_eq!(one_or_three("2"), Ok([2.0; 3]));
        for bad in ["1 x", "nan", "inf", "1e999"] {
            assert!(numbers(bad).is_err(), "{bad}");
        }
        assert!(matches!(numbers(&"1 ".repeat(MOST + 1)), Err(Fault::TooMany { .. })));
    }

    #[test]
    fn colours_come_in_several_spellings() {
        assert_eq!(colour("0.5 0.3, 0.2", false), Ok(Value::Colour([0.5, 0.3, 0.2])));
        assert_eq!(colour("#ff0033", false), Ok(Value::Colour([1.0, 0.0, 0.2])));
        let Ok(Value::Colour([grey, ..])) = colour("0.5", true) else { panic!() };
        assert!((grey - 0.214_041).abs() < 1e-5, "{grey}");
        for bad in ["#12345", "#gggggg", "#äöü", "1 2", ""] {
            assert!(colour(bad, false).is_err(), "{bad}");
        }
    }

    #[test]
    fn spectra_are_a_number_a_colour_or_pairs() {
        assert_eq!(spectrum("0.25"), Ok(Value::Even(0.25)));
        assert_eq!(
            spectrum("400:0.1, 500:0.2"),
            Ok(Value::Spectrum(vec![[400.0, 0.1], [500.0, 0.2]]))
        );
        for bad in ["400:0.1, 300:0.2", "400:x", "400:0.1, 7", "1 2"] {
            assert!(spectrum(bad).is_err(), "{bad}");
        }
    }
}
