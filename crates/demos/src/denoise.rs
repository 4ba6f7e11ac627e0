//! A picture with less noise, and some bias: means over pixels that look alike.
//!
//! Non-local means over two half pictures, after Rousselle, Knaus and Zwicker, *Adaptive
//! Rendering with Non-Local Means Filtering*, 2012: how alike two pixels are is told from one
//! half and used on the other, so that no noise votes for itself. The halves are the two
//! sequences of a film, whose errors are independent. What each filter did to the error is
//! estimated from the halves, too, and every place takes the one that did best there.

mod choice;
mod filter;
mod smooth;

use choice::{Candidate, best_of};
use filter::{Guide, filtered};
use traylib_math::{Grid, Rgb, Vec3};

/// Radiance of pixels, band by band.
type Picture = Grid<Vec3>;

/// Two independent pictures of the same light.
#[derive(Clone, Debug)]
pub(crate) struct Halves {
    /// The pictures.
    pub(crate) pictures: [Picture; 2],
    /// The part of all passes that each has; both make one.
    pub(crate) parts: [f32; 2],
}

/// The filters: for each the number of standard deviations by which unlike pixels differ. From
/// that which keeps most detail to that which leaves least noise.
const STRENGTHS: [f32; 3] = [0.3, 0.45, 0.7];

/// The variance of two values is known to little: it is taken from the pixels this far around.
const VARIANCE_RADIUS: usize = 1;

/// Returns the picture with less noise. It is biased: detail that looks like noise is gone.
pub(crate) fn denoise(halves: &Halves) -> Grid<Rgb> {
    let Halves { pictures: [a, b], parts } = halves;
    let whole = mix(a, b, *parts);
    // Twice the variance of the mean is as far as the halves are from it, weighted.
    let raw_variance = zip(a, b, |a, b| (a - b) * (a - b) * (parts[0] * parts[1]));
    let variance = smooth::mean(&raw_variance, VARIANCE_RADIUS);
    let [of_a, of_b] = parts.map(|part| variance.map(|&variance| variance / part));
    // Each half by the likeness of pixels in the other.
    let [by_a, by_b] = [(a, &of_a), (b, &of_b)].map(|(light, noise)| Guide { light, noise });
    let pairs = filtered(a, by_b, &STRENGTHS).into_iter().zip(filtered(b, by_a, &STRENGTHS));
    let mut candidates = vec![Candidate { picture: whole.clone(), error: variance }];
    candidates.extend(pairs.map(|(filtered_a, filtered_b)| {
        // A filtered half against the other one, less what that has of noise itself.
        let distance = |one: &Picture, other: &Picture| zip(one, other, |x, y| (x - y) * (x - y));
        let against =
            zip(&distance(&filtered_a, b), &distance(&filtered_b, a), |x, y| 0.5 * (x + y));
        let of_half = zip(&against, &raw_variance, |error, variance| error - 2.0 * variance);
        // What is left of noise in either half is halved in their mean.
        let left = distance(&filtered_a, &filtered_b);
        let error = zip(&of_half, &left, |error, left| error - 0.25 * left);
        Candidate { picture: mix(&filtered_a, &filtered_b, *parts), error }
    }));
    best_of(&candidates, &whole).map(|light| Rgb::from(light.to_array()))
}

/// The mean of two pictures, each with its part.
fn mix(a: &Picture, b: &Picture, parts: [f32; 2]) -> Picture {
    zip(a, b, |a, b| a * parts[0] + b * parts[1])
}

/// The picture of `f` of each two pixels.
fn zip(a: &Picture, b: &Picture, f: impl Fn(Vec3, Vec3) -> Vec3) -> Picture {
    let (a_values, b_values) = (a.values(), b.values());
    Grid::from_fn(a.width(), a.height(), |i| f(a_values[i], b_values[i]))
}

#[cfg(test)]
mod tests;
