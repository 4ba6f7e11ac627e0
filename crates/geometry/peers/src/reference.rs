//! The hits of rays in double precision: slow, plain, and independent of everyone.

mod tree;

use glam::DVec3;
use traylib_geometry::{Mesh, Ray};
use tree::{Content, Node};

/// Triangles in a binary tree of boxes.
pub(crate) struct Reference {
    /// In the order of the leaves, each with its number.
    triangles: Vec<([DVec3; 3], u32)>,
    nodes: Vec<Node>,
}

/// A hit: t and the number of the triangle.
pub(crate) type Exact = (f64, u32);

impl Reference {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let corners = |t: &[u32; 3]| t.map(|i| mesh.positions()[i as usize].as_dvec3());
        let mut triangles: Vec<_> = mesh.triangles().iter().map(corners).zip(0..).collect();
        let nodes = tree::build(&mut triangles);
        Self { triangles, nodes }
    }

    /// The first hit with 0 < t < `ray.t_max`.
    pub(crate) fn nearest(&self, ray: &Ray) -> Option<Exact> {
        let line = Line::new(ray);
        let (mut nearest, mut t_max) = (None, ray.t_max as f64);
        let mut stack = vec![0];
        while let Some(index) = stack.pop() {
            let Some(node) = self.nodes.get(index) else { continue };
            if line.enters(node).is_none_or(|t| t >= t_max) {
                continue;
            }
            match node.content {
                Content::Leaf { first, count } => {
                    for (corners, number) in &self.triangles[first..first + count] {
                        if let Some(t) = line.meets(corners).filter(|&t| t < t_max) {
                            t_max = t;
                            nearest = Some((t, *number));
                        }
                    }
                }
                Content::Children { second } => {
                    stack.extend(self.farther_first(&line, [index + 1, second]));
                }
            }
        }
        nearest
    }

    fn farther_first(&self, line: &Line, [a, b]: [usize; 2]) -> [usize; 2] {
        let entry = |i: usize| line.enters(&self.nodes[i]).unwrap_or(f64::INFINITY);
        if entry(a) < entry(b) { [b, a] } else { [a, b] }
    }
}

/// A ray without its end.
struct Line {
    origin: DVec3,
    direction: DVec3,
    reciprocal: DVec3,
}

impl Line {
    fn new(ray: &Ray) -> Self {
        let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
        // No number of the `f32`s that rays are made of is as small, and its
        // reciprocal is finite: zero times it is zero.
        let sound = |x: f64| if x == 0.0 { 1e-300 } else { x };
        let reciprocal = direction.to_array().map(|x| 1.0 / sound(x)).into();
        Self { origin, direction, reciprocal }
    }

    /// Returns the t at which it enters a box; `None` if it misses.
    fn enters(&self, node: &Node) -> Option<f64> {
        let a = (node.low - self.origin) * self.reciprocal;
        let b = (node.high - self.origin) * self.reciprocal;
        let (enter, leave) = (a.min(b).max_element(), a.max(b).min_element());
        // Each has three roundings; a million times that costs nothing.
        let rounding = 1e-9 * enter.abs().max(leave.abs());
        (enter.max(0.0) <= leave + rounding).then_some(enter - rounding)
    }

    /// t of the point where it meets a triangle; Möller and Trumbore, "Fast,
    /// Minimum Storage Ray/Triangle Intersection", 1997.
    fn meets(&self, [a, b, c]: &[DVec3; 3]) -> Option<f64> {
        let (ab, ac) = (*b - *a, *c - *a);
        let across = self.direction.cross(ac);
        let reciprocal = 1.0 / ab.dot(across);
        let from_a = self.origin - *a;
        let u = from_a.dot(across) * reciprocal;
        let turned = from_a.cross(ab);
        let v = self.direction.dot(turned) * reciprocal;
        let t = ac.dot(turned) * reciprocal;
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then_some(t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::support::{rays::RaySets, room::Room};

    /// The nearest of all triangles asked one by one, for rays of every set.
    #[test]
    fn the_tree_loses_nothing() {
        let room = Room::small().unwrap();
        let reference = Reference::new(&room.mesh);
        let found = |ray: &Ray| reference.nearest(ray).map(|(t, i)| (t as f32, i));
        let sets = RaySets::new(&room, 32, found);
        for ray in [sets.primary, sets.bounces, sets.shadow].iter().flatten() {
            let line = Line::new(ray);
            let all = reference.triangles.iter().filter_map(|(corners, _)| line.meets(corners));
            let nearest = all.filter(|&t| t < ray.t_max as f64).min_by(f64::total_cmp);
            assert_eq!(reference.nearest(ray).map(|hit| hit.0), nearest, "{ray:?}");
        }
    }

    #[test]
    fn a_ray_in_the_plane_of_a_box_meets_what_is_in_it() {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Into::into);
        let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2]]).unwrap();
        let ray = Ray::new([0.0, 0.5, 3.0].into(), [0.0, -0.0, -1.0].into());
        assert_eq!(Reference::new(&mesh).nearest(&ray), Some((3.0, 0)));
        assert_eq!(Reference::new(&mesh).nearest(&Ray { t_max: 3.0, ..ray }), None);
    }
}
