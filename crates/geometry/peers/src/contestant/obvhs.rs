//! obvhs: eight quantised boxes a node, by two of its builders.

use super::{Built, Contestant, Found};
use obvhs::BvhBuildParams;
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh_from_tris};
use obvhs::ray::RayHit;
use obvhs::triangle::Triangle;
use std::time::Duration;
use traylib_geometry::{Mesh, Ray};

pub(super) fn all() -> Vec<Contestant> {
    let medium = |mesh: &Mesh| Ok(Tree::new(mesh, BvhBuildParams::medium_build()));
    let very_slow = |mesh: &Mesh| Ok(Tree::new(mesh, BvhBuildParams::very_slow_build()));
    vec![
        Contestant::new("obvhs CWBVH, medium", medium),
        Contestant::new("obvhs CWBVH, very slow", very_slow),
    ]
}

/// Triangles in the order of the leaves, as the library's example has them: so
/// they are found without asking for their numbers.
struct Tree {
    bvh: CwBvh,
    triangles: Vec<Triangle>,
}

impl Tree {
    fn new(mesh: &Mesh, parameters: BvhBuildParams) -> Self {
        let corner = |i: u32| mesh.positions()[i as usize].into();
        let triangle =
            |&[a, b, c]: &[u32; 3]| Triangle { v0: corner(a), v1: corner(b), v2: corner(c) };
        let triangles: Vec<_> = mesh.triangles().iter().map(triangle).collect();
        let bvh = build_cwbvh_from_tris(&triangles, parameters, &mut Duration::default());
        let triangles = bvh.primitive_indices.iter().map(|&i| triangles[i as usize]).collect();
        Self { bvh, triangles }
    }

    fn nearest(&self, ray: &Ray) -> Found {
        let mut hit = RayHit::none();
        let meets = |ray: &obvhs::ray::Ray, i: usize| self.triangles[i].intersect(ray);
        if !self.bvh.ray_traverse(translated(ray), &mut hit, meets) {
            return Found::NOTHING;
        }
        let primitive = self.bvh.primitive_indices[hit.primitive_id as usize];
        Found { t: hit.t, primitive }
    }
}

fn translated(ray: &Ray) -> obvhs::ray::Ray {
    obvhs::ray::Ray::new(ray.origin.into(), ray.direction.into(), 0.0, ray.t_max)
}

impl Built for Tree {
    fn nearest(&mut self, rays: &[Ray], found: &mut [Found]) {
        for (ray, found) in rays.iter().zip(found) {
            *found = Self::nearest(self, ray);
        }
    }

    fn any_hit(&mut self, rays: &[Ray], found: &mut [bool]) {
        for (ray, found) in rays.iter().zip(found) {
            let meets = |ray: &obvhs::ray::Ray, i: usize| self.triangles[i].intersect(ray);
            *found = !self.bvh.ray_traverse_miss(translated(ray), meets);
        }
    }
}
