//! Light as a window shows it.

use rayon::prelude::*;
use traylib_io::picture::screen_rgb;
use traylib_math::{Grid, Rgb};

/// Pixels as a window takes them, `0RGB` from the highest byte: the same bytes as in a PNG.
pub(crate) fn screen(radiance: &Grid<Rgb>, exposure: f32) -> Vec<u32> {
    let pixel = |&light: &Rgb| {
        let [red, green, blue] = screen_rgb(light, exposure);
        u32::from_be_bytes([0, red, green, blue])
    };
    radiance.values().par_iter().with_min_len(4096).map(pixel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_have_their_bytes() {
        let radiance = Grid::from_values(2, 1, vec![Rgb::new(1.0, 0.25, 0.0), Rgb::splat(9.0)]);
        let [red, green, blue] = screen_rgb(Rgb::new(1.0, 0.25, 0.0), 2.0);
        let wanted = vec![u32::from_be_bytes([0, red, green, blue]), 0x00ff_ffff];
        assert_eq!(screen(&radiance.unwrap(), 2.0), wanted);
    }
}
