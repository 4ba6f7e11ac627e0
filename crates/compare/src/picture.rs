//! Pictures in double precision, in which they are computed with, and in single, in
//! which they are kept and shown.

use traylib_math::{Grid, Rgb};

/// A picture in linear radiance.
pub type Picture = Grid<[f64; 3]>;

/// The mean of the bands.
pub fn grey(bands: &[f64; 3]) -> f64 {
    bands.iter().sum::<f64>() / 3.0
}

/// Rounds a picture to single precision, as it is kept in files.
pub fn single(picture: &Picture) -> Grid<Rgb> {
    picture.map(|light| Rgb::from(light.map(|band| band as f32)))
}

/// Widens a picture to double precision, as it is computed with.
pub fn double(picture: &Grid<Rgb>) -> Picture {
    picture.map(|light| light.to_array().map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_single_stays_as_it_is() {
        let picture = Grid::filled(2, 1, Rgb::new(0.1, 1e-30, 7e8));
        assert_eq!(single(&double(&picture)), picture);
    }
}
