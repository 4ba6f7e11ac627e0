//! Markers of methods, as corners around a point.

use std::f64::consts::TAU;

/// The number of marker shapes.
pub(crate) const SHAPES: usize = 5;
/// The one of other programs.
pub(crate) const DIAMOND: usize = 3;

/// Radius of the hole in a hollow marker, as a share of the marker's.
pub(crate) const HOLE: f64 = 0.6;

/// Corners of a marker, clockwise from the top, y down: circle, square, triangle,
/// diamond, triangle on its tip. All of about the same area.
pub(crate) fn corners(shape: usize, radius: f64) -> Vec<(f64, f64)> {
    match shape % SHAPES {
        0 => regular(20, radius, 0.0),
        1 => regular(4, 1.2 * radius, 0.125),
        2 => regular(3, 1.4 * radius, 0.0),
        DIAMOND => regular(4, 1.3 * radius, 0.0),
        _ => regular(3, 1.4 * radius, 0.5),
    }
}

/// A regular polygon, turned by a part of a full turn.
fn regular(sides: u32, radius: f64, turn: f64) -> Vec<(f64, f64)> {
    let corner = |k: u32| {
        let (sin, cos) = (TAU * (turn + f64::from(k) / f64::from(sides))).sin_cos();
        (radius * sin, -radius * cos)
    };
    (0..sides).map(corner).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markers_are_centred() {
        for shape in 0..SHAPES {
            let corners = corners(shape, 5.0);
            let sum = corners.iter().fold((0.0, 0.0), |(x, y), c| (x + c.0, y + c.1));
            assert!(sum.0.abs() < 1e-9 && sum.1.abs() < 1e-9, "{shape}");
        }
    }
}
