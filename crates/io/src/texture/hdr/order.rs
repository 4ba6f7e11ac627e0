//! In which order pixels are stored.
//!
//! `-Y 300 +X 400` stands for 300 scan lines, y decreasing from one to the next, of
//! 400 pixels, x increasing along each. y points up. Eight such lines are possible.

use super::reader::Reader;
use crate::texture::TextureError;

/// An axis of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Axis {
    /// To the right.
    X,
    /// Upward.
    Y,
}

/// A way along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Way {
    axis: Axis,
    increasing: bool,
    pixels: u32,
}

impl Way {
    fn parse(sign: &str, pixels: &str) -> Option<Self> {
        let (axis, increasing) = match sign {
            "+X" => (Axis::X, true),
            "-X" => (Axis::X, false),
            "+Y" => (Axis::Y, true),
            "-Y" => (Axis::Y, false),
            _ => return None,
        };
        Some(Self { axis, increasing, pixels: pixels.parse().ok()? })
    }

    /// The column, or the row from the top, of the n-th pixel on this way.
    fn place(self, n: usize) -> usize {
        let from_the_start = match self.axis {
            Axis::X => self.increasing,
            Axis::Y => !self.increasing,
        };
        if from_the_start { n } else { self.pixels as usize - 1 - n }
    }
}

/// From one scan line to the next, and along each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Order {
    lines: Way,
    along: Way,
}

impl Order {
    pub(super) fn read(reader: &mut Reader<'_>) -> Result<Self, TextureError> {
        let at = reader.at();
        let line = str::from_utf8(reader.line()?).unwrap_or_default();
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let order = match words[..] {
            [a, m, b, n] => Way::parse(a, m).zip(Way::parse(b, n)),
            _ => None,
        };
        let what = "wanted is the size as `-Y 300 +X 400`";
        let order = order.filter(|(lines, along)| lines.axis != along.axis);
        order.map(|(lines, along)| Self { lines, along }).ok_or(TextureError::Radiance { at, what })
    }

    /// Width and height of the picture.
    pub(super) fn size(self) -> [u32; 2] {
        match self.lines.axis {
            Axis::X => [self.lines.pixels, self.along.pixels],
            Axis::Y => [self.along.pixels, self.lines.pixels],
        }
    }

    /// Scan lines.
    pub(super) fn count(self) -> usize {
        self.lines.pixels as usize
    }

    /// Pixels of each.
    pub(super) fn length(self) -> usize {
        self.along.pixels as usize
    }

    /// Column and row, from the top, of a pixel of a scan line.
    pub(super) fn place(self, line: usize, along: usize) -> [usize; 2] {
        let (line, along) = (self.lines.place(line), self.along.place(along));
        match self.lines.axis {
            Axis::X => [line, along],
            Axis::Y => [along, line],
        }
    }
}
