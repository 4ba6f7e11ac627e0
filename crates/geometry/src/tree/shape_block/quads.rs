//! Four parallelograms.

use super::{Line, NO_ROWS, Rows, ShapeBlock, contained, cross, dot, hits_at, read, scaled, write};
use crate::Sides;
use crate::shape::ShapeKind;
use crate::tree::intersector::Hits;
use crate::tree::node::LEAF;
use crate::tree::simd::{F32x4, F64x4, Float, Simd};

/// Up to four quads; where there is none, its numbers are none.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(crate) struct QuadBlock {
    /// The cross products of the edges.
    across: Rows,
    corners: Rows,
    edges_u: Rows,
    edges_v: Rows,
    /// From where to where −u counts as inside.
    minus_u: [[f32; LEAF]; 2],
    /// From where to where v counts as inside.
    v: [[f32; LEAF]; 2],
    numbers: [u32; LEAF],
    /// One bit for each that is met from both sides.
    two_sided: u32,
}

impl QuadBlock {
    pub(crate) fn new(numbers: [u32; LEAF], kind: impl Fn(u32) -> ShapeKind) -> Self {
        let none = [[f32::NAN; LEAF]; 2];
        let mut block = Self {
            across: NO_ROWS,
            corners: NO_ROWS,
            edges_u: NO_ROWS,
            edges_v: NO_ROWS,
            minus_u: none,
            v: none,
            numbers,
            two_sided: 0,
        };
        for (lane, &number) in numbers.iter().enumerate().filter(|&(_, &n)| n != u32::MAX) {
            let ShapeKind::Quad(quad, sides) = kind(number) else { continue };
            let [edge_u, edge_v] = quad.edges();
            write(&mut block.across, lane, quad.across());
            write(&mut block.corners, lane, quad.corner().as_dvec3());
            write(&mut block.edges_u, lane, edge_u.as_dvec3());
            write(&mut block.edges_v, lane, edge_v.as_dvec3());
            let margin = quad.margin();
            block.minus_u[0][lane] = -(1.0 + margin.x);
            block.minus_u[1][lane] = margin.x;
            block.v[0][lane] = -margin.y;
            block.v[1][lane] = 1.0 + margin.y;
            block.two_sided |= u32::from(sides == Sides::Both) << lane;
        }
        block
    }
}

impl ShapeBlock for QuadBlock {
    fn numbers(&self) -> &[u32; LEAF] {
        &self.numbers
    }

    /// [`Quad::intersect`](crate::Quad::intersect) of each.
    #[inline(always)]
    fn hits<E: Simd>(&self, line: &Line<E>, limit: f32) -> Hits<LEAF> {
        let simd = line.simd;
        let across = read(simd, &self.across);
        let from_corner = line.origin_from(read(simd, &self.corners));
        let slope = dot(line.direction, across);
        let reciprocal = simd.splat_four_doubles(-1.0) / slope;
        let t = (dot(from_corner, across) * reciprocal).narrow();
        let front = slope.narrow().below(simd.splat_four(0.0));
        // Most boxes that a ray comes to are those it leaves, or hold what is not there for it.
        let in_range = contained(simd, t, limit) & (front | self.two_sided);
        if in_range == 0 {
            return hits_at(0, t);
        }
        let moment = scaled(cross(line.direction, from_corner), reciprocal);
        let minus_u = dot(moment, read(simd, &self.edges_v)).narrow();
        let v = dot(moment, read(simd, &self.edges_u)).narrow();
        let within = |x: E::F32x4, [least, most]: [[f32; LEAF]; 2]| {
            simd.load_four(least).at_most(x) & x.at_most(simd.load_four(most))
        };
        let inside = within(minus_u, self.minus_u) & within(v, self.v);
        Hits {
            mask: in_range & inside,
            t: t.to_array(),
            u: minus_u.to_array().map(|minus_u| (-minus_u).clamp(0.0, 1.0)),
            v: v.to_array().map(|v| v.clamp(0.0, 1.0)),
        }
    }
}
