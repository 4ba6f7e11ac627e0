//! Finds surfaces for which one side makes no difference.
//!
//! A straight line between two points outside of a closed surface goes in as often as it
//! comes out. So it meets as many fronts from either end, and where each lets the same
//! part through, the same light arrives. This holds while nothing is inside: no surface,
//! no lamp, no camera.

use super::{Described, bends_or_scatters};
use std::collections::HashMap;
use traylib_geometry::{Aabb, Mesh, Primitive, Vec3};
use traylib_scene::ObjectShape;

/// Comparisons of one box with another, after which nobody looks any more.
const MOST_WORK: usize = 1 << 26;

/// All things that may be inside of something.
pub(super) struct Surroundings<'a> {
    items: &'a [Described<'a>],
    bounds: Vec<Aabb>,
    points: Vec<Vec3>,
    work: usize,
}

impl<'a> Surroundings<'a> {
    pub(super) fn new(items: &'a [Described<'a>], points: Vec<Vec3>) -> Self {
        let bounds = items.iter().map(|described| Aabb::around(described.item.extremes()));
        Self { items, bounds: bounds.collect(), points, work: MOST_WORK }
    }

    /// Tells whether both ends of every line see the same of this item; `false` where that
    /// would take long to find out.
    pub(super) fn is_harmless(&mut self, index: usize) -> bool {
        let Described { item, material, .. } = self.items[index];
        let is_even = !material.has_opacity() && !bends_or_scatters(&material.model);
        is_even && is_closed(&item.shape) && self.is_empty_within(index)
    }

    fn is_empty_within(&mut self, index: usize) -> bool {
        let within = self.bounds[index];
        !self.points.iter().any(|&point| within.contains(point))
            && (0..self.items.len()).all(|other| other == index || self.is_outside(other, &within))
    }

    fn is_outside(&mut self, other: usize, within: &Aabb) -> bool {
        let mut is_allowed = || self.work.checked_sub(1).map(|left| self.work = left).is_some();
        if !is_allowed() {
            return false;
        }
        let apart = |primitive: Primitive| is_allowed() && is_apart(&primitive, within);
        !overlap(&self.bounds[other], within)
            || self.items[other].item.primitives().map(|sided| sided.primitive).all(apart)
    }
}

fn overlap(a: &Aabb, b: &Aabb) -> bool {
    a.min.cmple(b.max).all() && b.min.cmple(a.max).all()
}

/// Tells whether a surface has no point in a box. A sphere is also apart if the box is inside.
fn is_apart(primitive: &Primitive, within: &Aabb) -> bool {
    let is_around = |centre: Vec3, radius: f32| {
        let farthest = (within.min - centre).abs().max((within.max - centre).abs());
        farthest.length() < radius
    };
    if let Primitive::Sphere(sphere) = primitive
        && is_around(sphere.centre(), sphere.radius())
    {
        return true;
    }
    !overlap(&primitive.bounds(), within)
}

fn is_closed(shape: &ObjectShape) -> bool {
    match shape {
        ObjectShape::Primitive(primitive) => matches!(primitive, Primitive::Sphere(_)),
        ObjectShape::Mesh(mesh) => is_closed_mesh(mesh),
    }
}

/// Tells whether each edge is gone along as often one way as the other. Corners are the same
/// if they are at the same place.
pub(in crate::import) fn is_closed_mesh(mesh: &Mesh) -> bool {
    let mut edges: HashMap<[[u32; 3]; 2], i64> = HashMap::new();
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|corner| place(mesh.positions()[corner as usize]));
        for [from, to] in [[a, b], [b, c], [c, a]] {
            if from < to {
                *edges.entry([from, to]).or_default() += 1;
            } else {
                *edges.entry([to, from]).or_default() -= 1;
            }
        }
    }
    edges.into_values().all(|surplus| surplus == 0)
}

/// The bits of a position; both zeros are one.
fn place(position: Vec3) -> [u32; 3] {
    (position + Vec3::ZERO).to_array().map(f32::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron; corner 0 is there twice.
    fn tetrahedron(triangles: &[[u32; 3]]) -> Mesh {
        let positions = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z, -Vec3::ZERO];
        Mesh::new(positions, triangles.to_vec()).unwrap()
    }

    #[test]
    fn a_mesh_is_closed_if_its_edges_meet() {
        let closed = [[0, 2, 1], [4, 1, 3], [0, 3, 2], [1, 2, 3]];
        assert!(is_closed_mesh(&tetrahedron(&closed)));
        assert!(!is_closed_mesh(&tetrahedron(&closed[1..])));
        let turned = [[0, 1, 2], [4, 1, 3], [0, 3, 2], [1, 2, 3]];
        assert!(!is_closed_mesh(&tetrahedron(&turned)));
    }
}
