//! Counting points of the unit square.

/// A point of the unit square.
pub type At = [f64; 2];

/// Square cells on each side.
pub const SIDE: usize = 32;

/// Counts of the cells of the unit square, row by row along the second
/// coordinate, then of what lies outside in cells of its own.
#[derive(Clone, Debug)]
pub struct Counts {
    /// `SIDE`² cells and the others.
    pub cells: Vec<u64>,
}

impl Counts {
    /// No points yet; with `others` cells beside the square.
    pub fn new(others: usize) -> Self {
        Self { cells: vec![0; SIDE * SIDE + others] }
    }

    /// Counts a point of the square. Rounding may bring it on the border or a
    /// little beyond.
    ///
    /// # Panics
    /// If it lies further out.
    pub fn add(&mut self, point: At) {
        let near = |x: &f64| (x - 0.5).abs() < 0.5 + 1e-3;
        assert!(point.iter().all(near), "{point:?}");
        let cell = |x: f64| ((x * SIDE as f64).max(0.0) as usize).min(SIDE - 1);
        self.cells[cell(point[1]) * SIDE + cell(point[0])] += 1;
    }

    /// Counts a sample that is not in the square.
    pub fn add_other(&mut self, which: usize) {
        self.cells[SIDE * SIDE + which] += 1;
    }
}

/// The probabilities of the cells where all points are alike.
pub fn even() -> Vec<f64> {
    vec![1.0 / (SIDE * SIDE) as f64; SIDE * SIDE]
}

/// The probabilities of the cells for this density on the unit square, by the
/// midpoint rule on 128 × 8 points a cell: a sphere from near is seen with a
/// density that is steep along the first coordinate.
pub fn probabilities(density: impl Fn(At) -> f64) -> Vec<f64> {
    const FINE: [usize; 2] = [128, 8];
    let steps = FINE.map(|fine| SIDE * fine);
    let mut cells = vec![0.0; SIDE * SIDE];
    for y in 0..steps[1] {
        for x in 0..steps[0] {
            let middle = [(x, steps[0]), (y, steps[1])].map(|(i, n)| (i as f64 + 0.5) / n as f64);
            cells[y / FINE[1] * SIDE + x / FINE[0]] += density(middle);
        }
    }
    let points = (steps[0] * steps[1]) as f64;
    cells.into_iter().map(|sum| sum / points).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_where_their_points_are() {
        let mut counts = Counts::new(1);
        counts.add([0.99, 0.01]);
        counts.add([1.0, -1e-9]);
        counts.add_other(0);
        assert_eq!(counts.cells[SIDE - 1], 2);
        assert_eq!(counts.cells[SIDE * SIDE], 1);
        let density = |point: At| if point[0] > 0.5 && point[1] < 0.5 { 4.0 } else { 0.0 };
        let cells = probabilities(density);
        assert!((cells[SIDE - 1] - 4.0 * even()[0]).abs() < 1e-12);
        assert_eq!(cells[0], 0.0);
    }

    #[test]
    #[should_panic(expected = "1.01")]
    fn points_outside_are_a_mistake() {
        Counts::new(0).add([1.01, 0.5]);
    }
}
