//! Colours, and what becomes of them in a dark window.

use plotters::style::RGBColor;
use std::fmt::Write;

/// A colour by its name in the style: on white, and on black.
struct Ink {
    name: &'static str,
    light: RGBColor,
    dark: RGBColor,
}

const fn ink(name: &'static str, light: u32, dark: u32) -> Ink {
    Ink { name, light: rgb(light), dark: rgb(dark) }
}

const fn rgb(hex: u32) -> RGBColor {
    RGBColor((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

/// Hues after Okabe and Ito's palette, which people who see few colours can tell
/// apart; darkened or lightened until each has a contrast of 3 with both the paper
/// and the panels. Markers differ as well.
const METHOD_INKS: [Ink; 8] = [
    ink("m0", 0x0072_B2, 0x56_B4E9),
    ink("m1", 0xC4_4E00, 0xF0_8A4B),
    ink("m2", 0x00_7F5F, 0x2F_C49B),
    ink("m3", 0xA6_437F, 0xE3_92C0),
    ink("m4", 0x8A_6500, 0xE6_B422),
    ink("m5", 0x4B_5B73, 0xAE_BACB),
    ink("m6", 0x7A_3B1D, 0xD2_A078),
    ink("m7", 0x5B_4FC0, 0xA9_A3F5),
];

const ROLE_INKS: [Ink; 5] = [
    ink("ink", 0x1A_1D21, 0xE7_E9EC),
    ink("muted", 0x5C_636C, 0xA3_ABB5),
    ink("grid", 0xDF_E2E6, 0x34_3A42),
    ink("paper", 0xFF_FFFF, 0x14_171B),
    ink("pale", 0xB4_BAC2, 0x5E_6670),
];

/// Text and axes.
pub(crate) const INK: RGBColor = ROLE_INKS[0].light;
/// What is less important.
pub(crate) const MUTED: RGBColor = ROLE_INKS[1].light;
/// Lines to read values by.
pub(crate) const GRID: RGBColor = ROLE_INKS[2].light;
/// The background.
pub(crate) const PAPER: RGBColor = ROLE_INKS[3].light;
/// What is beaten by something else.
pub(crate) const PALE: RGBColor = ROLE_INKS[4].light;
/// How many colours there are for methods.
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

/// Style: each colour as a variable, and charts that obey the variables.
pub(crate) fn style() -> String {
    let (mut light, mut dark, mut rules) = (String::new(), String::new(), String::new());
    for Ink { name, light: on_white, dark: on_black } in inks() {
        let sentinel = hex(*on_white);
        // A `String` takes any text.
        let _ = write!(light, "--{name}:{sentinel};");
        let _ = write!(dark, "--{name}:{};", hex(*on_black));
        let _ = write!(
            rules,
            "svg [fill=\"{sentinel}\"]{{fill:var(--{name})}}\
             svg [stroke=\"{sentinel}\"]{{stroke:var(--{name})}}\n"
        );
    }
    format!(":root{{{light}}}\n@media (prefers-color-scheme:dark){{:root{{{dark}}}}}\n{rules}")
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
