//! Row-major two-dimensional arrays.

/// `width × height` values, row 0 first (the top row of a picture), each row
/// from left to right.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid<T> {
    width: usize,
    values: Vec<T>,
}

impl<T: Clone> Grid<T> {
    /// A grid with `value` everywhere.
    pub fn filled(width: usize, height: usize, value: T) -> Self {
        Self { width, values: vec![value; width * height] }
    }
}

impl<T> Grid<T> {
    /// A grid of the given values in row-major order; `None` if they are not
    /// `width × height`.
    pub fn from_values(width: usize, height: usize, values: Vec<T>) -> Option<Self> {
        (values.len() == width * height).then_some(Self { width, values })
    }

    /// A grid of `f` of each row-major index.
    pub fn from_fn(width: usize, height: usize, f: impl FnMut(usize) -> T) -> Self {
        Self { width, values: (0..width * height).map(f).collect() }
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.values.len().checked_div(self.width).unwrap_or(0)
    }

    /// The value in column `x`, row `y`.
    ///
    /// # Panics
    /// If the place is outside the grid.
    pub fn get(&self, x: usize, y: usize) -> &T {
        assert!(x < self.width, "column {x} of {}", self.width);
        &self.values[y * self.width + x]
    }

    /// All values, row by row.
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// All values, row by row, to be changed.
    pub fn values_mut(&mut self) -> &mut [T] {
        &mut self.values
    }

    /// A grid of `f` of each value.
    pub fn map<U>(&self, f: impl FnMut(&T) -> U) -> Grid<U> {
        Grid { width: self.width, values: self.values.iter().map(f).collect() }
    }

    /// Maps every value where both grids do not fit into memory: what is done with is given back on
    /// the way, if the allocator can shrink in place what is large, as those of Linux do.
    pub fn into_map<U>(mut self, mut f: impl FnMut(T) -> U) -> Grid<U> {
        /// Values after which memory is given back.
        const PART: usize = 1 << 20;
        let mut values = Vec::with_capacity(self.values.len());
        // From the back, where a vector can shrink.
        while let Some(value) = self.values.pop() {
            values.push(f(value));
            if self.values.len().is_multiple_of(PART) {
                self.values.shrink_to_fit();
            }
        }
        values.reverse();
        Grid { width: self.width, values }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_come_first() {
        let grid = Grid::from_values(3, 2, vec![0, 1, 2, 3, 4, 5]).unwrap();
        assert_eq!((grid.width(), grid.height()), (3, 2));
        assert_eq!(*grid.get(1, 1), 4);
        assert_eq!(*grid.map(|v| v * 10).get(2, 0), 20);
        assert_eq!(grid.clone().into_map(|v| v * 10), grid.map(|v| v * 10));
    }

    #[test]
    fn a_wrong_number_of_values_is_refused() {
        assert!(Grid::from_values(3, 2, vec![0; 5]).is_none());
    }
}
