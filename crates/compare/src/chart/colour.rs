//! Colours, and what becomes of them in a dark window.

use plotters::style::RGBColor;
use std::fmt::Write;

/// A colour by its name in the style: on white, and on black.
struct Ink {
    name: &'static str,
    light: RGBColor,
    dark: RGBColor,
}

const fn ink(name: &'static str, light: [u8; 3], dark: [u8; 3]) -> Ink {
    Ink { name, light: rgb(light), dark: rgb(dark) }
}

const fn rgb([r, g, b]: [u8; 3]) -> RGBColor {
    RGBColor(r, g, b)
}

/// Hues after Okabe and Ito's palette, which people who see few colours can tell
/// apart; darkened or lightened until each has a contrast of 4.5 with the paper, as
/// text needs it. Markers differ as well.
const METHOD_INKS: [Ink; 8] = [
    ink("m0", [0x00, 0x72, 0xB2], [0x56, 0xB4, 0xE9]),
    ink("m1", [0xC4, 0x4E, 0x00], [0xF0, 0x8A, 0x4B]),
    ink("m2", [0x00, 0x7F, 0x5F], [0x2F, 0xC4, 0x9B]),
    ink("m3", [0xA6, 0x43, 0x7F], [0xE3, 0x92, 0xC0]),
    ink("m4", [0x8A, 0x65, 0x00], [0xE6, 0xB4, 0x22]),
    ink("m5", [0x4B, 0x5B, 0x73], [0xAE, 0xBA, 0xCB]),
    ink("m6", [0x7A, 0x3B, 0x1D], [0xD2, 0xA0, 0x78]),
    ink("m7", [0x5B, 0x4F, 0xC0], [0xA9, 0xA3, 0xF5]),
];

const ROLE_INKS: [Ink; 5] = [
    ink("ink", [0x1A, 0x1D, 0x21], [0xE7, 0xE9, 0xEC]),
    ink("muted", [0x5C, 0x63, 0x6C], [0xA3, 0xAB, 0xB5]),
    ink("grid", [0xDF, 0xE2, 0xE6], [0x34, 0x3A, 0x42]),
    ink("paper", [0xFF, 0xFF, 0xFF], [0x14, 0x17, 0x1B]),
    ink("pale", [0xB4, 0xBA, 0xC2], [0x5E, 0x66, 0x70]),
];

/// Text and axes.
pub(crate) const INK: RGBColor = ROLE_INKS[0].light;
/// The colour of less important elements.
pub(crate) const MUTED: RGBColor = ROLE_INKS[1].light;
/// Lines to read values by.
pub(crate) const GRID: RGBColor = ROLE_INKS[2].light;
/// The background.
pub(crate) const PAPER: RGBColor = ROLE_INKS[3].light;
/// The colour of elements that another one beats.
pub(crate) const PALE: RGBColor = ROLE_INKS[4].light;
/// The number of method colours.
pub(crate) const METHODS: usize = METHOD_INKS.len();

/// The colour of a method.
pub(crate) fn method(slot: usize) -> RGBColor {
    METHOD_INKS[slot % METHODS].light
}

fn inks() -> impl Iterator<Item = &'static Ink> {
    METHOD_INKS.iter().chain(&ROLE_INKS)
}

fn hex(RGBColor(r, g, b): RGBColor) -> String {
    format!("#{r:02X}{g:02X}{b:02X}")
}

/// Times beside ticks are the only texts in colours of methods; a narrow window has
/// no room for them, and the table below the chart has them too.
fn narrow_style() -> String {
    let texts: Vec<String> =
        METHOD_INKS.iter().map(|ink| format!("svg text[fill=\"{}\"]", hex(ink.light))).collect();
    format!("@media (max-width:40rem){{{}{{display:none}}}}\n", texts.join(","))
}

/// Style: each colour as a variable, and charts that obey the variables.
pub(crate) fn style() -> String {
    let (mut light, mut dark, mut rules) = (String::new(), String::new(), String::new());
    for Ink { name, light: on_white, dark: on_black } in inks() {
        let sentinel = hex(*on_white);
        // A `String` takes any text.
        let _ = write!(light, "--{name}:{sentinel};");
        let _ = write!(dark, "--{name}:{};", hex(*on_black));
        let _ = writeln!(
            rules,
            "svg [fill=\"{sentinel}\"]{{fill:var(--{name})}}\
             svg [stroke=\"{sentinel}\"]{{stroke:var(--{name})}}"
        );
    }
    let narrow = narrow_style();
    format!(
        ":root{{{light}}}\n@media (prefers-color-scheme:dark){{:root{{{dark}}}}}\n{rules}{narrow}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn luminance(RGBColor(r, g, b): RGBColor) -> f64 {
        let linear = |byte: u8| {
            let coded = f64::from(byte) / 255.0;
            if coded <= 0.04045 { coded / 12.92 } else { ((coded + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b)
    }

    fn contrast(a: RGBColor, b: RGBColor) -> f64 {
        let (a, b) = (luminance(a) + 0.05, luminance(b) + 0.05);
        a.max(b) / a.min(b)
    }

    #[test]
    fn methods_stand_out_from_the_paper_and_text_is_readable() {
        let paper = &ROLE_INKS[3];
        for ink in &METHOD_INKS {
            assert!(contrast(ink.light, paper.light) > 4.5, "{} on white", ink.name);
            assert!(contrast(ink.dark, paper.dark) > 4.5, "{} on black", ink.name);
        }
        for ink in &ROLE_INKS[..2] {
            assert!(contrast(ink.light, paper.light) > 4.5, "{} on white", ink.name);
            assert!(contrast(ink.dark, paper.dark) > 4.5, "{} on black", ink.name);
        }
    }

    #[test]
    fn no_two_inks_are_mistaken_for_one() {
        let mut sentinels: Vec<_> = inks().map(|ink| hex(ink.light)).collect();
        sentinels.sort();
        sentinels.dedup();
        assert_eq!(sentinels.len(), METHOD_INKS.len() + ROLE_INKS.len());
    }
}
