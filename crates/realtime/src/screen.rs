//! Light as a window shows it.

use rayon::prelude::*;
use traylib_io::picture::screen_rgb;
use traylib_math::{Grid, Rgb};
use traylib_scene::Film;

/// A film as a picture of so many columns and rows, and its pixels as a window takes them.
pub(crate) fn develop(
    film: &Film,
    (width, height): (u32, u32),
    exposure: f32,
) -> (Grid<Rgb>, Vec<u32>) {
    let (width, height) = (width as usize, height as usize);
    let (mut radiance, mut pixels) =
        (Grid::filled(width, height, Rgb::BLACK), vec![0; width * height]);
    let lights = radiance.values_mut().par_chunks_mut(PART).zip(pixels.par_chunks_mut(PART));
    lights.enumerate().for_each(|(part, (lights, pixels))| {
        for (index, (light, pixel)) in (part * PART..).zip(lights.iter_mut().zip(pixels)) {
            *light = film.develop_pixel(index);
            *pixel = shown(*light, exposure);
        }
    });
    (radiance, pixels)
}

/// Pixels that a thread takes at a time.
const PART: usize = 8192;

/// A pixel as a window takes it, `0RGB` from the highest byte: the same bytes as in a PNG.
fn shown(light: Rgb, exposure: f32) -> u32 {
    let [red, green, blue] = screen_rgb(light, exposure);
    u32::from_be_bytes([0, red, green, blue])
}

#[cfg(test)]
mod tests {
    use super::*;
    use traylib_scene::PassImage;

    #[test]
    fn a_film_is_developed_as_ever_and_shown_as_in_files() {
        let (width, height) = (200, 100);
        let mut pass = PassImage::new(width, height);
        (0..width * height).for_each(|pixel| pass.add(pixel, Rgb::splat(pixel as f32 * 1e-4)));
        let mut film = Film::new(width, height);
        film.add_pass(0, pass);
        let (radiance, pixels) = develop(&film, (width, height), 0.5);
        assert_eq!(radiance, film.develop());
        let shown = radiance.values().iter().map(|&light| {
            let [red, green, blue] = screen_rgb(light, 0.5);
            u32::from(red) << 16 | u32::from(green) << 8 | u32::from(blue)
        });
        assert!(shown.eq(pixels));
    }
}
