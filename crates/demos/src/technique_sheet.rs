//! All techniques on one picture, as Veach lays them out (*Robust Monte Carlo Methods for Light
//! Transport Simulation*, 1997, chapter 10).

use std::collections::BTreeMap;
use traylib_integrators::Technique;
use traylib_math::{Grid, Rgb};

/// Longer paths have no row.
const LONGEST: usize = 10;

/// Pictures are made smaller until a sheet is no broader than this, in pixels.
const BROADEST: usize = 2400;

/// Pixels around each picture.
const GAP: usize = 4;

/// A sheet: its pictures stand in rows by the number of edges of their paths, from 1 at the top,
/// and in columns by the number of vertices from the light, from 0 at the left.
struct Sheet<'a> {
    /// The pictures that are added up in a place, by row and column from 0.
    cells: BTreeMap<(usize, usize), Vec<&'a Grid<Rgb>>>,
    /// Columns and rows of pixels of all pictures.
    size: [usize; 2],
    /// So many of their pixels become one, each way.
    reduction: usize,
}

/// The sheet of the pictures of techniques by layer, weighted or raw, `between` them this light;
/// `None` if there are none. What is joined with point lights by way of mirrors counts where its
/// vertices do.
pub(crate) fn sheet(
    layers: &BTreeMap<u16, Grid<Rgb>>,
    is_weighted: bool,
    between: Rgb,
) -> Option<Grid<Rgb>> {
    let mut cells: BTreeMap<(usize, usize), Vec<&Grid<Rgb>>> = BTreeMap::new();
    for (&layer, picture) in layers {
        let Technique { s, t, weighted, by_mirror: _ } = Technique::of_layer(layer);
        let (s, edges) = (usize::from(s), (usize::from(s) + usize::from(t)).saturating_sub(1));
        if weighted == is_weighted && (1..=LONGEST).contains(&edges) {
            cells.entry((edges - 1, s)).or_default().push(picture);
        }
    }
    let first = *cells.values().next()?.first()?;
    let size = [first.width(), first.height()];
    let columns = cells.keys().map(|&(_, column)| column + 1).max()?;
    let rows = cells.keys().map(|&(row, _)| row + 1).max()?;
    let breadth = |reduction: usize| columns * (size[0].div_ceil(reduction) + GAP) + GAP;
    let reduction = (1..size[0]).find(|&by| breadth(by) <= BROADEST).unwrap_or(size[0]);
    let sheet = Sheet { cells, size, reduction };
    let [width, height] = size.map(|side| side.div_ceil(reduction) + GAP);
    let (width, height) = (columns * width + GAP, rows * height + GAP);
    let pixel = |index| sheet.light([index % width, index / width]).unwrap_or(between);
    Some(Grid::from_fn(width, height, pixel))
}

impl Sheet<'_> {
    /// The light of a pixel; `None` between the pictures.
    fn light(&self, place: [usize; 2]) -> Option<Rgb> {
        let [column, row] = [0, 1].map(|axis| self.split(place[axis], axis));
        let ((column, x), (row, y)) = (column?, row?);
        let pictures = self.cells.get(&(row, column))?;
        Some(pictures.iter().map(|picture| self.mean(picture, [x, y])).sum())
    }

    /// The number of a picture along an axis, and the place in it.
    fn split(&self, place: usize, axis: usize) -> Option<(usize, usize)> {
        let side = self.size[axis].div_ceil(self.reduction);
        let place = place.checked_sub(GAP)?;
        let (number, within) = (place / (side + GAP), place % (side + GAP));
        (within < side).then_some((number, within))
    }

    /// The mean of the pixels that become one.
    fn mean(&self, picture: &Grid<Rgb>, place: [usize; 2]) -> Rgb {
        let [columns, rows] = [0, 1].map(|axis| {
            let start = place[axis] * self.reduction;
            start..(start + self.reduction).min(self.size[axis])
        });
        let count = (columns.len() * rows.len()) as f32;
        let pixels = rows.flat_map(|y| columns.clone().map(move |x| *picture.get(x, y)));
        pixels.sum::<Rgb>() * (1.0 / count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Layers have the bits s, t, weighted from above, and by mirror above all.
    fn layer(s: u16, t: u16, by_mirror: bool) -> u16 {
        u16::from(by_mirror) << 15 | s << 8 | t << 1 | 1
    }

    fn grey(size: [usize; 2], value: f32) -> Grid<Rgb> {
        Grid::filled(size[0], size[1], Rgb::splat(value))
    }

    #[test]
    fn rows_are_lengths_and_columns_are_vertices_from_the_light() {
        let size = [3, 2];
        let layers = [
            (layer(0, 2, false), grey(size, 1.0)),
            (layer(0, 3, false), grey(size, 2.0)),
            (layer(2, 1, false), grey(size, 3.0)),
            (layer(2, 1, true), grey(size, 0.5)),
            // Raw, and too long.
            (layer(1, 1, false) - 1, grey(size, 9.0)),
            (layer(6, 6, false), grey(size, 9.0)),
        ];
        let sheet = sheet(&layers.into_iter().collect(), true, Rgb::splat(-1.0)).unwrap();
        assert_eq!((sheet.width(), sheet.height()), (3 * 7 + 4, 2 * 6 + 4));
        let at = |column: usize, row: usize| sheet.get(4 + 7 * column + 2, 4 + 6 * row + 1).g;
        assert_eq!([at(0, 0), at(1, 0), at(2, 0)], [1.0, -1.0, -1.0]);
        assert_eq!([at(0, 1), at(1, 1), at(2, 1)], [2.0, -1.0, 3.5]);
        let lit = sheet.values().iter().filter(|light| light.g >= 0.0).count();
        assert_eq!(lit, 3 * 6);
    }

    /// Three of 2000 columns become one, the last of what is left.
    #[test]
    fn large_pictures_are_made_smaller() {
        let ramp = |index: usize| Rgb::splat((index % 2000) as f32);
        let layers = [(layer(2, 1, false), Grid::from_fn(2000, 4, ramp))];
        let sheet = sheet(&layers.into_iter().collect(), true, Rgb::BLACK).unwrap();
        assert_eq!(sheet.width(), 3 * (667 + 4) + 4);
        let left = 4 + 2 * (667 + 4);
        let row = |x: usize| sheet.get(left + x, 4 + 2 + 4).g;
        for (x, mean) in [(0, 1.0), (1, 4.0), (666, 1998.5)] {
            assert!((row(x) - mean).abs() < 1e-3, "{x}: {}", row(x));
        }
    }

    #[test]
    fn nothing_has_no_sheet() {
        assert!(sheet(&BTreeMap::new(), true, Rgb::BLACK).is_none());
    }
}
