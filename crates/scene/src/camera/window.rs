//! A part of the film.

/// A rectangle of a frame's pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FilmWindow {
    /// The frame's column in which its first column is.
    pub x: u32,
    /// The frame's row in which its first row is.
    pub y: u32,
    /// Columns of pixels.
    pub width: u32,
    /// Rows of pixels.
    pub height: u32,
}

impl FilmWindow {
    /// All of a frame of this size.
    pub fn whole(width: u32, height: u32) -> Self {
        Self { x: 0, y: 0, width, height }
    }

    /// Tells whether it has pixels, and only such as a frame of this size has.
    pub(super) fn is_inside(self, width: u32, height: u32) -> bool {
        let fits = |first: u32, count: u32, all: u32| {
            count > 0 && first.checked_add(count).is_some_and(|end| end <= all)
        };
        fits(self.x, self.width, width) && fits(self.y, self.height, height)
    }
}
