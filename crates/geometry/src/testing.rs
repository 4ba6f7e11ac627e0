//! Random shapes and closed meshes for tests.

pub(crate) mod shape;

use crate::{Facing, Mesh, Primitive, Triangle, Vec2, Vec3};
use shape::Measures;
use std::collections::HashMap;
use traylib_math::{Sampler, warp};

/// A seeded source of shapes.
pub(crate) struct Random(Sampler);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(Sampler::numbered(seed, 0))
    }

    /// Uniform on [0, 1).
    pub(crate) fn number(&mut self) -> f32 {
        self.0.next_1d()
    }

    pub(crate) fn square(&mut self) -> Vec2 {
        self.0.next_2d()
    }

    /// Uniform in the cube from −1 to 1.
    pub(crate) fn point(&mut self) -> Vec3 {
        let mut coordinate = || 2.0 * self.0.next_1d() - 1.0;
        Vec3::new(coordinate(), coordinate(), coordinate())
    }

    pub(crate) fn direction(&mut self) -> Vec3 {
        warp::uniform_sphere(self.square())
    }

    /// Between 1 and `ratio`, all orders of magnitude alike.
    pub(crate) fn magnitude(&mut self, ratio: f32) -> f32 {
        ratio.powf(self.number())
    }

    /// A shape of size about one near `place`.
    pub(crate) fn primitive(&mut self, place: Vec3) -> Primitive {
        let centre = place + self.point();
        let (along, aside) = (self.point(), self.point());
        let radius = 0.1 + 0.5 * self.number();
        self.one_of(centre, along, aside, radius)
    }

    /// A shape near `place` whose edges differ in length by up to 10⁵.
    pub(crate) fn sliver(&mut self, place: Vec3) -> Primitive {
        let centre = place + self.point();
        let thin = self.magnitude(1e-5);
        let (along, aside) = (self.point(), self.point() * thin);
        self.one_of(centre, along, aside, thin)
    }

    fn one_of(&mut self, centre: Vec3, along: Vec3, aside: Vec3, radius: f32) -> Primitive {
        let facing = if self.number() < 0.5 { Facing::Outward } else { Facing::Inward };
        let (kind, part) = (self.number(), self.number());
        let mut forms = Measures { centre, along, aside, radius, part, facing }.forms();
        let shape = forms.swap_remove((kind * forms.len() as f32) as usize);
        // Far from the origin a sliver's corners can round onto a line.
        shape.unwrap_or_else(|_| self.primitive(centre))
    }
}

/// The triangles of a mesh in which all have an area.
pub(crate) fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    (0..mesh.triangle_count()).map(|i| mesh.triangle(i).unwrap()).collect()
}

/// A closed ball of radius one: an icosahedron whose triangles are split in
/// four `levels` times.
pub(crate) fn icosphere(levels: u32) -> Mesh {
    let (mut positions, mut faces) = icosahedron();
    for _ in 0..levels {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                positions.push((positions[a as usize] + positions[b as usize]).normalize());
                positions.len() as u32 - 1
            })
        };
        faces = faces
            .into_iter()
            .flat_map(|[a, b, c]| {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
            })
            .collect();
    }
    Mesh::new(positions, faces).unwrap()
}

/// Twelve corners on three golden rectangles; faces are the triples at the
/// shortest distance from each other, turned outward.
fn icosahedron() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let golden = f32::midpoint(1.0, 5.0_f32.sqrt());
    let mut corners = Vec::new();
    for (one, long) in [(1.0, golden), (1.0, -golden), (-1.0, golden), (-1.0, -golden)] {
        corners.extend([
            Vec3::new(0.0, one, long),
            Vec3::new(one, long, 0.0),
            Vec3::new(long, 0.0, one),
        ]);
    }
    let near = |i: usize, j: usize| (corners[i].distance(corners[j]) - 2.0).abs() < 1e-3;
    let mut faces = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if near(i, j) && near(j, k) && near(k, i) {
                    let (a, b, c) = (corners[i], corners[j], corners[k]);
                    let outward = (b - a).cross(c - a).dot(a) > 0.0;
                    let (j, k) = if outward { (j, k) } else { (k, j) };
                    faces.push([i as u32, j as u32, k as u32]);
                }
            }
        }
    }
    (corners.into_iter().map(Vec3::normalize).collect(), faces)
}

/// A closed box from −1 to 1, twelve triangles.
pub(crate) fn cube() -> Mesh {
    let sign = |bit: u32| if bit == 0 { -1.0 } else { 1.0 };
    let corner = |i: u32| Vec3::new(sign(i & 1), sign(i & 2), sign(i & 4));
    let sides =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Mesh::new((0..8).map(corner).collect(), faces).unwrap()
}
