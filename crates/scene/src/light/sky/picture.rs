//! Radiance by direction, and directions by brightness.

use std::f64::consts::{PI, TAU};
use traylib_math::{Grid, Rgb, Vec2, Vec3};

/// A picture of all directions, one radiance a texel.
///
/// With up = +y, column and row (u, v) in [0, 1)² from the top left corner are the direction
/// of polar angle πv from up and azimuth φ = 2π(u − ½) − turn, clockwise seen from above and
/// counted from −z:
///
/// d = (sin πv·sin φ, cos πv, −sin πv·cos φ).
///
/// Who looks along −z with y up sees the middle of the picture, its right half to the right.
/// A texel is drawn in proportion to luminance times solid angle, and all directions within it
/// alike: the density is everywhere in proportion to the luminance.
#[derive(Clone, Debug)]
pub(crate) struct SkyPicture {
    radiance: Grid<Rgb>,
    /// Radians, counter-clockwise seen from above.
    turn: f32,
    /// Cosines of the polar angle of the rows' edges, from the top.
    edges: Vec<f64>,
    /// Chance of a row up to and including this one.
    rows: Vec<f64>,
    /// Within its row, the chance of a texel up to and including this one.
    columns: Vec<f64>,
    /// The integral of the weight over all directions: a texel's weight over it is its density per
    /// steradian.
    total: f64,
}

impl SkyPicture {
    /// A picture, turned about y by so many radians, counter-clockwise seen from above;
    /// `None` if all of it is black, or it has no texel. Radiance is finite and not negative.
    pub(crate) fn new(radiance: Grid<Rgb>, turn: f32) -> Option<Self> {
        let (width, height) = (radiance.width(), radiance.height());
        let edge = |row: usize| (PI * row as f64 / height as f64).cos();
        let edges: Vec<f64> = (0..=height).map(edge).collect();
        let weights = radiance.values().iter().map(|&light| weight(light));
        let mut columns: Vec<f64> = weights.collect();
        let mut rows = Vec::with_capacity(height);
        let mut total = 0.0;
        for (row, texels) in columns.chunks_mut(width.max(1)).enumerate() {
            let texel_angle = TAU * (edges[row] - edges[row + 1]) / width as f64;
            total += accumulate(texels) * texel_angle;
            rows.push(total);
        }
        let sound = total > 0.0 && total.is_finite();
        normalise(&mut rows, total);
        sound.then_some(Self { radiance, turn, edges, rows, columns, total })
    }

    /// The radiance from a unit direction.
    pub(crate) fn radiance(&self, toward: Vec3) -> Rgb {
        let (column, row) = self.texel(toward);
        *self.radiance.get(column, row)
    }

    /// The density of [`sample`](Self::sample) at a unit direction from which this radiance
    /// comes, per steradian: zero only where it is black.
    pub(crate) fn pdf(&self, radiance: Rgb) -> f32 {
        let weight = weight(radiance);
        let pdf = (weight / self.total) as f32;
        if weight > 0.0 { pdf.max(f32::MIN_POSITIVE) } else { 0.0 }
    }

    /// The integral of radiance over all directions.
    pub(crate) fn integral(&self) -> Rgb {
        let width = self.radiance.width();
        let mut sum = [0.0; 3];
        for (row, texels) in self.radiance.values().chunks(width).enumerate() {
            let texel_angle = TAU * (self.edges[row] - self.edges[row + 1]) / width as f64;
            for texel in texels {
                for (sum, band) in sum.iter_mut().zip(texel.to_array()) {
                    *sum += f64::from(band) * texel_angle;
                }
            }
        }
        Rgb::from(sum.map(|band| band as f32))
    }

    /// A unit direction by brightness, for `u` uniform on the unit square.
    pub(crate) fn sample(&self, u: Vec2) -> Vec3 {
        let width = self.radiance.width();
        // One number for row and polar angle, one for column and azimuth: what is left of
        // each is uniform again.
        let (row, down) = choose(&self.rows, f64::from(u.y));
        let texels = &self.columns[row * width..][..width];
        let (column, right) = choose(texels, f64::from(u.x));
        let (top, bottom) = (self.edges[row], self.edges[row + 1]);
        let cosine = top - down * (top - bottom);
        let sine = ((1.0 - cosine) * (1.0 + cosine)).max(0.0).sqrt();
        let across = (column as f64 + right) / width as f64;
        let (sin, cos) = (TAU * (across - 0.5) - f64::from(self.turn)).sin_cos();
        Vec3::new((sine * sin) as f32, cosine as f32, (-sine * cos) as f32)
    }

    /// Column and row of a unit direction.
    fn texel(&self, toward: Vec3) -> (usize, usize) {
        let (width, height) = (self.radiance.width(), self.radiance.height());
        let Vec3 { x, y, z } = toward;
        // Exact near the poles, too, where an arc cosine is not.
        let down = x.hypot(z).atan2(y) / std::f32::consts::PI;
        let around = (x.atan2(-z) + self.turn) / std::f32::consts::TAU + 0.5;
        let place = |part: f32, count: usize| ((part * count as f32) as usize).min(count - 1);
        (place(around - around.floor(), width), place(down, height))
    }
}

/// Returns the weight by which a texel is drawn: its luminance, not zero where there is light.
fn weight(light: Rgb) -> f64 {
    let luminance = f64::from(light.luminance());
    if light.is_black() { 0.0 } else { luminance.max(f64::from(f32::MIN_POSITIVE)) }
}

/// Turns weights into running sums over all of them, and returns that.
fn accumulate(weights: &mut [f64]) -> f64 {
    let mut sum = 0.0;
    for weight in &mut *weights {
        sum += *weight;
        *weight = sum;
    }
    normalise(weights, sum);
    sum
}

/// Divides running sums by the last of them, so that they end with one.
fn normalise(sums: &mut [f64], total: f64) {
    for sum in sums {
        // Rounding must not leave a gap below one: what has reached the total is one.
        *sum = if *sum >= total { 1.0 } else { *sum / total };
    }
}

/// Returns how many of these rising sums, which end with one, are no more than `u`.
///
/// Large pictures do not fit into caches, and most of a sky is nearly even: the search begins
/// where an even one has its end, and doubles its steps from there.
fn count_up_to(sums: &[f64], u: f64) -> usize {
    let mut probe = ((u * sums.len() as f64) as usize).min(sums.len() - 1);
    let (mut low, mut high, mut step) = (0, sums.len(), 1);
    if sums[probe] <= u {
        while let Some(&sum) = sums.get(probe + step) {
            if sum > u {
                high = probe + step;
                break;
            }
            probe += step;
            step *= 2;
        }
        low = probe + 1;
    } else {
        while probe >= step {
            if sums[probe - step] <= u {
                low = probe - step + 1;
                break;
            }
            probe -= step;
            step *= 2;
        }
        high = probe;
    }
    low + sums[low..high].partition_point(|&sum| sum <= u)
}

/// The index that `u`, uniform on [0, 1), chooses, and what is left of that number.
fn choose(cumulative: &[f64], u: f64) -> (usize, f64) {
    let index = count_up_to(cumulative, u).min(cumulative.len() - 1);
    let before = if index == 0 { 0.0 } else { cumulative[index - 1] };
    let part = (u - before) / (cumulative[index] - before);
    (index, part.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Even, steep at each end and in the middle, with sums that repeat.
    #[test]
    fn a_search_from_a_guess_finds_what_a_whole_one_does() {
        let steep = |at: usize| (0..100).map(move |i| if i < at { 1e-3 * i as f64 } else { 1.0 });
        let even: Vec<f64> = (1..=64).map(|i| f64::from(i) / 64.0).collect();
        let lists = [even, vec![1.0], steep(1).collect(), steep(50).collect(), steep(99).collect()];
        for sums in lists {
            let between = (0..1000).map(|i| f64::from(i) / 1000.0);
            let at = sums.iter().copied().filter(|&sum| sum < 1.0);
            for u in between.chain(at) {
                let whole = sums.partition_point(|&sum| sum <= u);
                assert_eq!(count_up_to(&sums, u), whole, "{u} of {sums:?}");
            }
        }
    }
}
