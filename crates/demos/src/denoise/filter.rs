//! Non-local means.

use super::Picture;
use rayon::prelude::*;
use std::ops::Range;
use traylib_math::{Grid, Vec3};

/// Pixels are alike if the squares around them are, this far.
const PATCH_RADIUS: usize = 2;
/// Pixels this far away count.
const WINDOW_RADIUS: i32 = 7;
/// Rows that one thread filters at a time.
const BAND: usize = 16;

/// The pictures by which the likeness of pixels is judged.
#[derive(Clone, Copy)]
pub(super) struct Guide<'a> {
    /// A picture that is independent of the one that is filtered.
    pub(super) light: &'a Picture,
    /// Its variance.
    pub(super) noise: &'a Picture,
}

/// Returns means over pixels around each that look like it, for each strength.
///
/// Two pixels p and q are as unlike as ((u_p − u_q)² − v_p − min(v_p, v_q))/(k²(v_p + v_q)) is
/// over the bands and over the squares around them, with their light u, its variance v and the
/// strength k; the weight is e to the negative of that, or one if noise explains it all
/// (Rousselle, Knaus, Zwicker 2012, equations 2 and 3).
pub(super) fn filtered(picture: &Picture, guide: Guide<'_>, strengths: &[f32]) -> Vec<Picture> {
    let (width, height) = (picture.width(), picture.height());
    let starts: Vec<usize> = (0..height).step_by(BAND).collect();
    let bands = starts
        .par_iter()
        .map(|&start| band(picture, guide, strengths, start..(start + BAND).min(height)));
    let bands: Vec<Vec<Vec<Vec3>>> = bands.collect();
    let of_strength = |index: usize| {
        let rows: Vec<Vec3> = bands.iter().flat_map(|band| band[index].iter().copied()).collect();
        Grid::from_fn(width, height, |i| rows[i])
    };
    (0..strengths.len()).map(of_strength).collect()
}

/// Some rows of it, one after the other, for each strength.
fn band(
    picture: &Picture,
    guide: Guide<'_>,
    strengths: &[f32],
    rows: Range<usize>,
) -> Vec<Vec<Vec3>> {
    let (width, height) = (picture.width(), picture.height());
    let mut sums = vec![vec![(Vec3::ZERO, 0.0_f32); rows.len() * width]; strengths.len()];
    let factors: Vec<f32> = strengths.iter().map(|strength| 1.0 / (strength * strength)).collect();
    for (dx, dy) in offsets() {
        let unlike = unlikeness(guide, &rows, dx, dy);
        for y in rows.clone() {
            let Some(other_y) = shifted(y, dy, height) else { continue };
            for x in 0..width {
                let Some(other_x) = shifted(x, dx, width) else { continue };
                let index = (y - rows.start) * width + x;
                let light = *picture.get(other_x, other_y);
                for (sums, factor) in sums.iter_mut().zip(&factors) {
                    let weight = (-factor * unlike[index].max(0.0)).exp();
                    let (sum, weights) = &mut sums[index];
                    *sum += light * weight;
                    *weights += weight;
                }
            }
        }
    }
    let mean = |(sum, weights): (Vec3, f32)| sum / weights;
    sums.into_iter().map(|sums| sums.into_iter().map(mean).collect()).collect()
}

/// From a pixel to those around it; the pixel itself is one of them.
fn offsets() -> impl Iterator<Item = (i32, i32)> {
    let along = -WINDOW_RADIUS..=WINDOW_RADIUS;
    along.clone().flat_map(move |dy| along.clone().map(move |dx| (dx, dy)))
}

/// Returns the unlikeness of each pixel of these rows to the one at this offset, for a strength of
/// one: the mean over the squares around both.
fn unlikeness(guide: Guide<'_>, rows: &Range<usize>, dx: i32, dy: i32) -> Vec<f32> {
    let (width, height) = (guide.light.width(), guide.light.height());
    // Pixel by pixel, with the rows that squares reach into.
    let reach = rows.start.saturating_sub(PATCH_RADIUS)..(rows.end + PATCH_RADIUS).min(height);
    let of_pixel = |i: usize| {
        let (x, y) = (i % width, reach.start + i / width);
        let (other_x, other_y) = (clamped(x, dx, width), clamped(y, dy, height));
        let [u, other_u] = [(x, y), (other_x, other_y)].map(|(x, y)| *guide.light.get(x, y));
        let [v, other_v] = [(x, y), (other_x, other_y)].map(|(x, y)| *guide.noise.get(x, y));
        let difference = (u - other_u) * (u - other_u) - (v + v.min(other_v));
        // Where there is no noise at all, no difference is noise.
        let scale = (v + other_v).max(Vec3::splat(f32::MIN_POSITIVE));
        (difference / scale).element_sum() / 3.0
    };
    let pixels = Grid::from_fn(width, reach.len(), of_pixel);
    let mean = super::smooth::mean(&pixels, PATCH_RADIUS);
    let first = (rows.start - reach.start) * width;
    mean.values()[first..first + rows.len() * width].to_vec()
}

/// The place at an offset, if it is inside.
fn shifted(place: usize, offset: i32, count: usize) -> Option<usize> {
    place.checked_add_signed(offset as isize).filter(|&place| place < count)
}

/// The place at an offset, or the one at the edge.
fn clamped(place: usize, offset: i32, count: usize) -> usize {
    place.saturating_add_signed(offset as isize).min(count - 1)
}
