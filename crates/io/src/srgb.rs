//! The sRGB curve (IEC 61966-2-1).

/// Codes a linear value in [0, 1] for a screen, by the curve of sRGB.
pub(crate) fn encode(linear: f32) -> f32 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// The linear value that a screen shows when told this.
pub(crate) fn decode(coded: f32) -> f32 {
    if coded <= 0.040_45 { coded / 12.92 } else { ((coded + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_has_its_known_points_and_an_inverse() {
        assert_eq!((encode(0.0), decode(0.0)), (0.0, 0.0));
        assert!((decode(0.5) - 0.214_041_14).abs() < 1e-6);
        for byte in 0..=255_u8 {
            let coded = f32::from(byte) / 255.0;
            assert!((encode(decode(coded)) - coded).abs() < 1e-6, "{byte}");
        }
    }
}
