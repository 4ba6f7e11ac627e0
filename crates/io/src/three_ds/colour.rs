//! Colours and percentages, which are chunks of their own inside others.

use super::chunk::Reader;
use super::{WarningKind, Warnings};
use traylib_math::Rgb;

/// The first plain colour inside a chunk, else the first of those meant for
/// output in a gamma-corrected pipeline. Each band is in 0..1.
pub(super) fn colour(mut reader: Reader<'_>, warnings: &mut Warnings) -> Option<Rgb> {
    let mut second_choice = None;
    while let Some((id, body)) = reader.next_chunk(warnings) {
        let Some(value) = colour_of(id, body) else { continue };
        if !value.is_finite() {
            warnings.add(WarningKind::ColourNotFinite);
            continue;
        }
        let value = Rgb::from(value.to_array().map(|band| band.clamp(0.0, 1.0)));
        if matches!(id, 0x0010 | 0x0011) {
            return Some(value);
        }
        second_choice = second_choice.or(Some(value));
    }
    second_choice
}

fn colour_of(id: u16, mut body: Reader<'_>) -> Option<Rgb> {
    match id {
        0x0010 | 0x0013 => body.floats().map(|bands: [f32; 3]| Rgb::from(bands)),
        0x0011 | 0x0012 => bytes(&mut body),
        _ => None,
    }
}

/// A colour of three bytes.
pub(super) fn bytes(reader: &mut Reader<'_>) -> Option<Rgb> {
    let mut band = || reader.byte().map(|b| f32::from(b) / 255.0);
    Some(Rgb::new(band()?, band()?, band()?))
}

/// The first percentage inside a chunk, as a fraction in 0..1.
pub(super) fn fraction(mut reader: Reader<'_>, warnings: &mut Warnings) -> Option<f32> {
    while let Some((id, body)) = reader.next_chunk(warnings) {
        if let Some(value) = fraction_of(id, body) {
            return Some(value);
        }
    }
    None
}

/// A percentage, if the chunk is one.
pub(super) fn fraction_of(id: u16, mut body: Reader<'_>) -> Option<f32> {
    let value = match id {
        0x0030 => body.u16().map(|stored| f32::from(stored.cast_signed()) / 100.0),
        // Some writers store percent here too.
        0x0031 => body.f32().map(|stored| if stored > 1.0 { stored / 100.0 } else { stored }),
        _ => None,
    };
    value.filter(|value| value.is_finite()).map(|value| value.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plain_colour_wins_over_the_corrected_one() {
        let bytes = [0x12, 0, 9, 0, 0, 0, 9, 9, 9, 0x11, 0, 9, 0, 0, 0, 255, 0, 51];
        let decoded = |bytes| colour(Reader::new(bytes), &mut Warnings::default());
        assert_eq!(decoded(&bytes), Some(Rgb::new(1.0, 0.0, 0.2)));
        // Without the second colour the first is all there is.
        assert_eq!(decoded(&bytes[..9]), Some(Rgb::splat(9.0 / 255.0)));
        assert_eq!(decoded(&[]), None);
    }

    #[test]
    fn percentages_come_as_integers_or_floats() {
        let decoded = |bytes: &[u8]| fraction(Reader::new(bytes), &mut Warnings::default());
        assert_eq!(decoded(&[0x30, 0, 8, 0, 0, 0, 25, 0]), Some(0.25));
        let cases = [(0.5_f32, Some(0.5)), (40.0, Some(0.4)), (-1.0, Some(0.0)), (f32::NAN, None)];
        for (stored, expected) in cases {
            let float = [&[0x31, 0, 10, 0, 0, 0][..], &stored.to_le_bytes()].concat();
            assert_eq!(decoded(&float), expected, "{stored}");
        }
    }
}
