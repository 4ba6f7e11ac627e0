//! Meshes put together of boxes and bent sheets.

use traylib_geometry::glam::BVec3;
use traylib_geometry::{Error, Mesh, Vec3};

/// Positions and triangles so far.
#[derive(Debug, Default)]
pub(crate) struct Surfaces {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Surfaces {
    /// A box between its lowest and its highest corner: twelve triangles.
    pub(crate) fn cuboid(&mut self, low: Vec3, high: Vec3) {
        let first = self.positions.len() as u32;
        let corner = |i: u32| Vec3::select(corner_mask(i), high, low);
        self.positions.extend((0..8).map(corner));
        // Corners of one face, by the bits of their numbers: x 1, y 2, z 4.
        for [a, b, c, d] in
            [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]
        {
            self.triangles.extend([[a, b, c], [a, c, d]].map(|t| t.map(|i| first + i)));
        }
    }

    /// A surface over the unit square, of `cells` along u and v.
    pub(crate) fn sheet(&mut self, cells: [u32; 2], at: impl Fn(f32, f32) -> Vec3) {
        self.grid(cells, cells[0] + 1, at);
    }

    /// A surface that closes along u: its last column is its first.
    pub(crate) fn ring(&mut self, cells: [u32; 2], at: impl Fn(f32, f32) -> Vec3) {
        self.grid(cells, cells[0], at);
    }

    fn grid(&mut self, cells: [u32; 2], columns: u32, at: impl Fn(f32, f32) -> Vec3) {
        let [n, m] = cells;
        let first = self.positions.len() as u32;
        for row in 0..=m {
            let v = row as f32 / m as f32;
            self.positions.extend((0..columns).map(|column| at(column as f32 / n as f32, v)));
        }
        let index = |column: u32, row: u32| first + row * columns + column % columns;
        for (column, row) in (0..m).flat_map(|row| (0..n).map(move |column| (column, row))) {
            let [a, b] = [index(column, row), index(column + 1, row)];
            let [c, d] = [index(column + 1, row + 1), index(column, row + 1)];
            self.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }

    /// The mesh of them all.
    pub(crate) fn mesh(self) -> Result<Mesh, Error> {
        Mesh::new(self.positions, self.triangles)
    }
}

/// Returns which coordinates of a box's corner `i` are those of the highest corner.
fn corner_mask(i: u32) -> BVec3 {
    BVec3::new(i & 1 != 0, i & 2 != 0, i & 4 != 0)
}
