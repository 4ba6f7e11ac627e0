//! bvh: a binary tree. Its iterators cannot be told of the best hit so far, so its
//! nodes are walked here, nearer child first, which is faster.

use super::{Built, Contestant, Found};
use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::{Bvh, BvhNode};
use nalgebra::{Point3, Vector3};
use traylib_geometry::{Mesh, Ray, Vec3};

pub(super) fn new() -> Contestant {
    Contestant::new("bvh", |mesh| Ok(Tree::new(mesh)))
}

struct Tree {
    bvh: Bvh<f32, 3>,
    triangles: Vec<Triangle>,
}

struct Triangle {
    corners: [Vec3; 3],
    node: usize,
}

fn point(v: Vec3) -> Point3<f32> {
    Point3::new(v.x, v.y, v.z)
}

impl Bounded<f32, 3> for Triangle {
    fn aabb(&self) -> Aabb<f32, 3> {
        let [a, b, c] = self.corners;
        Aabb::with_bounds(point(a.min(b).min(c)), point(a.max(b).max(c)))
    }
}

impl BHShape<f32, 3> for Triangle {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Triangle {
    /// t of the point where a ray meets it from either side; the library's own test
    /// knows one side only. Möller and Trumbore, 1997.
    #[inline]
    fn meets(&self, ray: &Ray, t_max: f32) -> Option<f32> {
        let [a, b, c] = self.corners;
        let (ab, ac) = (b - a, c - a);
        let across = ray.direction.cross(ac);
        let reciprocal = 1.0 / ab.dot(across);
        let from_a = ray.origin - a;
        let u = from_a.dot(across) * reciprocal;
        let turned = from_a.cross(ab);
        let v = ray.direction.dot(turned) * reciprocal;
        let t = ac.dot(turned) * reciprocal;
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < t_max).then_some(t)
    }
}

impl Tree {
    fn new(mesh: &Mesh) -> Self {
        let corners = |t: &[u32; 3]| t.map(|i| mesh.positions()[i as usize]);
        let triangle = |t| Triangle { corners: corners(t), node: 0 };
        let mut triangles: Vec<_> = mesh.triangles().iter().map(triangle).collect();
        let bvh = Bvh::build_par(&mut triangles);
        Self { bvh, triangles }
    }

    /// The nearest hit, or any: the first that is found.
    fn walk(&self, ray: &Ray, any: bool, stack: &mut Vec<(f32, usize)>) -> Found {
        let line = translated(ray);
        let mut nearest = Found { t: ray.t_max, ..Found::NOTHING };
        stack.clear();
        stack.push((0.0, 0));
        while let Some((enter, index)) = stack.pop() {
            if enter >= nearest.t {
                continue;
            }
            match &self.bvh.nodes[index] {
                BvhNode::Leaf { shape_index, .. } => {
                    if let Some(t) = self.triangles[*shape_index].meets(ray, nearest.t) {
                        nearest = Found { t, primitive: *shape_index as u32 };
                        if any {
                            break;
                        }
                    }
                }
                BvhNode::Node {
                    child_l_index, child_l_aabb, child_r_index, child_r_aabb, ..
                } => {
                    let enter = |aabb| line.intersection_slice_for_aabb(aabb).map(|t| t.0);
                    let left = enter(child_l_aabb).map(|t| (t, *child_l_index));
                    let right = enter(child_r_aabb).map(|t| (t, *child_r_index));
                    push(stack, left, right);
                }
            }
        }
        if nearest.primitive == u32::MAX { Found::NOTHING } else { nearest }
    }
}

/// The nearer one on top.
fn push(stack: &mut Vec<(f32, usize)>, a: Option<(f32, usize)>, b: Option<(f32, usize)>) {
    match (a, b) {
        (Some(a), Some(b)) if a.0 < b.0 => stack.extend([b, a]),
        _ => stack.extend(a.into_iter().chain(b)),
    }
}

/// Converts a ray, but not by the library's `new`, which would make the direction unit and so
/// change t.
fn translated(ray: &Ray) -> bvh::ray::Ray<f32, 3> {
    let direction = Vector3::from(ray.direction.to_array());
    let inv_direction = direction.map(|x| 1.0 / x);
    bvh::ray::Ray { origin: point(ray.origin), direction, inv_direction }
}

impl Built for Tree {
    fn nearest(&mut self, rays: &[Ray], found: &mut [Found]) {
        let mut stack = Vec::new();
        for (ray, found) in rays.iter().zip(found) {
            *found = self.walk(ray, false, &mut stack);
        }
    }

    fn any_hit(&mut self, rays: &[Ray], found: &mut [bool]) {
        let mut stack = Vec::new();
        for (ray, found) in rays.iter().zip(found) {
            *found = self.walk(ray, true, &mut stack) != Found::NOTHING;
        }
    }
}
