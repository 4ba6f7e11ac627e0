//! Pictures to look colours up in.

use std::fmt;
use traylib_math::{Fnv, Grid, Rgb, Vec2};

/// The values beyond the edges of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tiling {
    /// The picture again.
    #[default]
    Repeat,
    /// The picture again, every other time mirrored.
    Mirror,
    /// Nothing.
    Once,
}

/// A picture of linear values over the unit square: u grows to the right, v
/// upward, and (0, 0) is the bottom left corner of the picture.
#[derive(Clone, PartialEq)]
pub struct Texture {
    /// Row 0 is at the top.
    pixels: Grid<Rgb>,
}

/// Its size, and a hash of its pixels, which are too many to print.
impl fmt::Debug for Texture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut hash = Fnv::default();
        let bands = self.pixels.values().iter().flat_map(|pixel| pixel.to_array());
        bands.for_each(|band| hash.add(&band.to_bits().to_le_bytes()));
        let size = [self.pixels.width(), self.pixels.height()];
        f.debug_struct("Texture").field("size", &size).field("hash", &hash.finish()).finish()
    }
}

impl Texture {
    /// The picture of these pixels, row 0 at the top; `None` if there are none.
    pub fn new(pixels: Grid<Rgb>) -> Option<Self> {
        (pixels.width() > 0 && pixels.height() > 0).then_some(Self { pixels })
    }

    /// All pixels, row 0 at the top.
    pub fn pixels(&self) -> &Grid<Rgb> {
        &self.pixels
    }

    /// The mean of all pixels.
    pub fn mean(&self) -> Rgb {
        let values = self.pixels.values();
        let sum = values.iter().fold([0.0; 3], |sum: [f64; 3], pixel| {
            let pixel = pixel.to_array();
            [0, 1, 2].map(|band| sum[band] + f64::from(pixel[band]))
        });
        Rgb::from(sum.map(|band| (band / values.len() as f64) as f32))
    }

    /// One pixel in place of all, of their mean.
    pub(crate) fn averaged(&self) -> Self {
        Self { pixels: Grid::filled(1, 1, self.mean()) }
    }

    /// Width and height of a pixel.
    pub fn pixel_size(&self) -> Vec2 {
        Vec2::new(1.0 / self.pixels.width() as f32, 1.0 / self.pixels.height() as f32)
    }

    /// The value at `uv`, linear between the middles of the four pixels around
    /// it; `None` beyond the edges of a picture that is there once, and for
    /// coordinates that are not finite.
    pub fn lookup(&self, uv: Vec2, tiling: Tiling) -> Option<Rgb> {
        let inside = uv.cmpge(Vec2::ZERO).all() && uv.cmple(Vec2::ONE).all();
        if !uv.is_finite() || (tiling == Tiling::Once && !inside) {
            return None;
        }
        let (x0, x1, right) = neighbours(uv.x, self.pixels.width(), tiling);
        let (y0, y1, down) = neighbours(1.0 - uv.y, self.pixels.height(), tiling);
        let row = |y| *self.pixels.get(x0, y) * (1.0 - right) + *self.pixels.get(x1, y) * right;
        Some(row(y0) * (1.0 - down) + row(y1) * down)
    }
}

/// The two of `count` pixels along an axis whose middles are around `place`,
/// and how far it is from the first to the second.
fn neighbours(place: f32, count: usize, tiling: Tiling) -> (usize, usize, f32) {
    let along = place * count as f32 - 0.5;
    let below = along.floor();
    let index = |place: f32| tiled(place, count, tiling);
    (index(below), index(below + 1.0), along - below)
}

/// The pixel that shows at a whole number of pixels from the first.
fn tiled(place: f32, count: usize, tiling: Tiling) -> usize {
    let n = count as f32;
    let inside = match tiling {
        Tiling::Repeat => place.rem_euclid(n),
        Tiling::Mirror => {
            let twice = place.rem_euclid(2.0 * n);
            twice.min(2.0 * n - 1.0 - twice)
        }
        Tiling::Once => place,
    };
    (inside.max(0.0) as usize).min(count - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two columns, dark and bright, of two rows each, the upper red.
    fn quarters() -> Texture {
        let pixels = [0.0, 1.0, 0.0, 1.0].iter().enumerate();
        let colours = pixels.map(|(i, &g)| Rgb::new(if i < 2 { 1.0 } else { 0.0 }, g, 0.0));
        Texture::new(Grid::from_values(2, 2, colours.collect()).unwrap()).unwrap()
    }

    #[test]
    fn middles_of_pixels_are_exact_and_between_is_linear() {
        let at = |u, v| quarters().lookup(Vec2::new(u, v), Tiling::Repeat).unwrap();
        assert_eq!(at(0.25, 0.75), Rgb::new(1.0, 0.0, 0.0));
        assert_eq!(at(0.75, 0.25), Rgb::new(0.0, 1.0, 0.0));
        assert_eq!(at(0.5, 0.5), Rgb::new(0.5, 0.5, 0.0));
    }

    #[test]
    fn the_mean_is_that_of_all_pixels() {
        assert_eq!(quarters().mean(), Rgb::new(0.5, 0.5, 0.0));
    }

    #[test]
    fn beyond_the_edges_it_repeats_mirrors_or_ends() {
        let at = |u, tiling| quarters().lookup(Vec2::new(u, 0.25), tiling).map(|c| c.g);
        assert_eq!([at(1.25, Tiling::Repeat), at(-0.25, Tiling::Repeat)], [Some(0.0), Some(1.0)]);
        assert_eq!([at(1.25, Tiling::Mirror), at(-0.25, Tiling::Mirror)], [Some(1.0), Some(0.0)]);
        assert_eq!([at(1.25, Tiling::Once), at(-0.25, Tiling::Once)], [None, None]);
        // Across the edge: the other side of it, the same pixel, the same pixel.
        let edge = [Tiling::Repeat, Tiling::Mirror, Tiling::Once].map(|tiling| at(1.0, tiling));
        assert_eq!(edge, [Some(0.5), Some(1.0), Some(1.0)]);
    }

    #[test]
    fn far_away_and_nowhere_are_safe() {
        for u in [1e30, -1e30, f32::INFINITY, f32::NAN] {
            for tiling in [Tiling::Repeat, Tiling::Mirror, Tiling::Once] {
                let found = quarters().lookup(Vec2::new(u, 0.5), tiling);
                assert!(found.is_none_or(Rgb::is_finite), "{u}");
            }
        }
    }
}
