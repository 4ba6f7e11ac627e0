//! Polygons into triangles by cutting off ears.

use super::projection::turn;
use traylib_math::glam::DVec2;

/// The fitness of a corner for being cut off, best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Fitness {
    /// Its triangle is inside, and no corner of the rest touches it.
    Ear,
    /// The way to it and back are one: nothing is lost.
    Spike,
    /// Others touch its triangle's border, as at seams.
    Touched,
    /// On a straight line between its neighbours.
    Straight,
    /// Others are in its triangle.
    Blocked,
    /// The polygon is outside of its triangle.
    Reflex,
}

/// Cuts a polygon, counter-clockwise as a whole, into triangles that are.
///
/// Corners may repeat and edges coincide, as where seams join holes. A simple
/// polygon of n corners that has no straight ones gives n − 2 triangles;
/// triangles without area are left out. Anything else gives some triangles:
/// there is always a best corner to cut off.
pub(super) fn cut(points: &[DVec2]) -> Vec<[usize; 3]> {
    let mut ring = Ring::new(points);
    let mut triangles = Vec::with_capacity(points.len().saturating_sub(2));
    let mut start = 0;
    for _ in 2..points.len() {
        let corner = ring.fittest(start);
        let (before, after) = (ring.before[corner], ring.after[corner]);
        if turn(points[before], points[corner], points[after]) > 0.0 {
            triangles.push([before, corner, after]);
        }
        ring.remove(corner);
        // Going on elsewhere makes fewer slivers than a fan.
        start = ring.after[after];
    }
    triangles
}

/// The rest of a polygon, as a doubly linked ring.
struct Ring<'a> {
    points: &'a [DVec2],
    before: Vec<usize>,
    after: Vec<usize>,
    fitness: Vec<Fitness>,
    /// Twice the area that rounding may make of none.
    rounding: f64,
}

impl<'a> Ring<'a> {
    fn new(points: &'a [DVec2]) -> Self {
        let count = points.len();
        let mut ring = Self {
            points,
            before: (0..count).map(|index| (index + count - 1) % count).collect(),
            after: (0..count).map(|index| (index + 1) % count).collect(),
            fitness: vec![Fitness::Ear; count],
            rounding: rounding(points),
        };
        if count > 3 {
            for corner in 0..count {
                ring.fitness[corner] = ring.judge(corner);
            }
        }
        ring
    }

    /// Finds the first of the fittest corners from `start` on.
    fn fittest(&self, start: usize) -> usize {
        let (mut best, mut corner) = (start, start);
        while self.fitness[best] != Fitness::Ear {
            corner = self.after[corner];
            if corner == start {
                break;
            }
            if self.fitness[corner] < self.fitness[best] {
                best = corner;
            }
        }
        best
    }

    /// In a simple polygon no corner but the neighbours changes: what cuts into
    /// a triangle from outside is no ear itself.
    fn remove(&mut self, corner: usize) {
        let (before, after) = (self.before[corner], self.after[corner]);
        self.after[before] = after;
        self.before[after] = before;
        for neighbour in [before, after] {
            self.fitness[neighbour] = self.judge(neighbour);
        }
    }

    fn judge(&self, corner: usize) -> Fitness {
        let neighbours = [self.before[corner], self.after[corner]];
        let [a, b, c] = [neighbours[0], corner, neighbours[1]].map(|index| self.points[index]);
        let area = turn(a, b, c);
        if a == c || a == b || b == c {
            return Fitness::Spike;
        }
        if area.abs() <= self.rounding {
            return if (a - b).dot(c - b) > 0.0 { Fitness::Spike } else { Fitness::Straight };
        }
        if area < 0.0 { Fitness::Reflex } else { self.obstacles(neighbours, [a, b, c]) }
    }

    /// Judges what the other corners do to a triangle.
    fn obstacles(&self, [first, last]: [usize; 2], [a, b, c]: [DVec2; 3]) -> Fitness {
        let mut fitness = Fitness::Ear;
        let mut corner = self.after[last];
        while corner != first && corner != last {
            let point = self.points[corner];
            let inward = turn(c, a, point);
            if inward < -self.rounding {
                // Beyond the side that the cut makes, as most are.
                corner = self.after[corner];
                continue;
            }
            let depth = turn(a, b, point).min(turn(b, c, point)).min(inward);
            if depth > self.rounding {
                return Fitness::Blocked;
            }
            if point == b && self.leads_into(corner, [a, b, c]) {
                return Fitness::Blocked;
            }
            // The other end of a seam is at the triangle's own corner.
            if depth >= -self.rounding && point != a && point != b && point != c {
                fitness = Fitness::Touched;
            }
            corner = self.after[corner];
        }
        fitness
    }

    /// Tells whether an edge goes from a corner at the tip of a triangle into it. It
    /// may cross to the other side without any corner inside.
    fn leads_into(&self, corner: usize, [a, b, c]: [DVec2; 3]) -> bool {
        [self.before[corner], self.after[corner]].into_iter().any(|neighbour| {
            let point = self.points[neighbour];
            turn(a, b, point) > self.rounding && turn(b, c, point) > self.rounding
        })
    }
}

/// Coordinates are off by a few of their last bits after a transform, so twice
/// an area by that times the extent. 10⁻¹⁴ is 45 times the last bit.
fn rounding(points: &[DVec2]) -> f64 {
    let Some(&first) = points.first() else { return 0.0 };
    let magnitude = points.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element()));
    let extent = points.iter().fold(0.0, |most: f64, p| most.max((*p - first).abs().max_element()));
    1e-14 * magnitude * extent
}
