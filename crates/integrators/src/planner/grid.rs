//! A film in equal cells.

/// Cells of a film, one for each probe.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    pub(super) columns: u32,
    pub(super) rows: u32,
    pub(super) width: u32,
    pub(super) height: u32,
}

impl Grid {
    /// The first pixel of a part of `0..whole`, of which there are `parts`.
    pub(super) fn edge(part: u32, parts: u32, whole: u32) -> u32 {
        (u64::from(part) * u64::from(whole) / u64::from(parts)) as u32
    }

    /// The part that a place lies in.
    fn part(place: u32, parts: u32, whole: u32) -> u32 {
        (((u64::from(place) + 1) * u64::from(parts) - 1) / u64::from(whole)) as u32
    }

    /// The number of the cell that a row-major pixel lies in.
    pub(super) fn cell(self, pixel: u32) -> usize {
        let Self { columns, rows, width, height } = self;
        let column = Self::part(pixel % width, columns, width);
        (Self::part(pixel / width, rows, height) * columns + column) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_lies_between_the_edges_of_its_part() {
        for (whole, parts) in [(10, 3), (7, 7), (640, 37), (5, 1)] {
            for place in 0..whole {
                let part = Grid::part(place, parts, whole);
                let edges = [part, part + 1].map(|part| Grid::edge(part, parts, whole));
                assert!((edges[0]..edges[1]).contains(&place), "{place} of {whole} in {parts}");
            }
        }
    }
}
