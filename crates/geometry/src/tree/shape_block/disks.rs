//! Four disks or rings.

use super::{Line, NO_ROWS, Rows, ShapeBlock, contained, dot, hits_at, read, write};
use crate::Sides;
use crate::shape::ShapeKind;
use crate::tree::intersector::Hits;
use crate::tree::node::LEAF;
use crate::tree::simd::{F64x4, Float, Simd};

/// Up to four disks; where there is none, its numbers are none.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct DiskBlock {
    /// From which to which square of the distance to the centre they reach.
    squares: [[f64; LEAF]; 2],
    centres: Rows,
    normals: Rows,
    numbers: [u32; LEAF],
    /// One bit for each that is met from both sides.
    two_sided: u32,
}

impl DiskBlock {
    pub(crate) fn new(numbers: [u32; LEAF], kind: impl Fn(u32) -> ShapeKind) -> Self {
        let mut block = Self {
            squares: [[f64::NAN; LEAF]; 2],
            centres: NO_ROWS,
            normals: NO_ROWS,
            numbers,
            two_sided: 0,
        };
        for (lane, &number) in numbers.iter().enumerate().filter(|&(_, &n)| n != u32::MAX) {
            let ShapeKind::Disk(disk, sides) = kind(number) else { continue };
            for (row, square) in block.squares.iter_mut().zip(disk.reach_squared()) {
                row[lane] = square;
            }
            write(&mut block.centres, lane, disk.centre().as_dvec3());
            write(&mut block.normals, lane, disk.normal().as_dvec3());
            block.two_sided |= u32::from(sides == Sides::Both) << lane;
        }
        block
    }
}

impl ShapeBlock for DiskBlock {
    fn numbers(&self) -> &[u32; LEAF] {
        &self.numbers
    }

    /// [`Disk::intersect`](crate::Disk::intersect) of each.
    #[inline(always)]
    fn hits<E: Simd>(&self, line: &Line<E>, limit: f32) -> Hits<LEAF> {
        let simd = line.simd;
        let normals = read(simd, &self.normals);
        let slope = dot(line.direction, normals);
        let from_centre = line.origin_from(read(simd, &self.centres));
        let exact = dot(from_centre, normals) * simd.splat_four_doubles(-1.0) / slope;
        let t = exact.narrow();
        let front = slope.narrow().below(simd.splat_four(0.0));
        let in_range = contained(simd, t, limit) & (front | self.two_sided);
        if in_range == 0 {
            return hits_at(0, t);
        }
        let [x, y, z] = line.direction.map(|d| exact * d);
        let [from_x, from_y, from_z] = from_centre;
        let place = [from_x + x, from_y + y, from_z + z];
        let square = dot(place, place);
        let [least, most] = self.squares.map(|row| simd.load_four_doubles(row));
        let inside = least.at_most(square) & square.at_most(most);
        hits_at(in_range & inside, t)
    }
}
