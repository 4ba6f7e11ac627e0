//! parry3d: a mesh of its own kind. It has no question for any hit; the nearest has
//! to do.

use super::{Built, Contestant, Found};
use parry3d::math::Vector;
use parry3d::shape::{CompositeShapeRef, TriMesh};
use traylib_geometry::{Ray, Vec3};

pub(super) fn new() -> Contestant {
    Contestant::new("parry3d", |mesh| {
        let positions = mesh.positions().iter().map(|&p| vector(p)).collect();
        TriMesh::new(positions, mesh.triangles().to_vec()).map_err(|error| error.to_string())
    })
}

fn vector(v: Vec3) -> Vector {
    Vector::new(v.x, v.y, v.z)
}

fn nearest(mesh: &TriMesh, ray: &Ray) -> Found {
    let line = parry3d::query::Ray::new(vector(ray.origin), vector(ray.direction));
    let hit = CompositeShapeRef(mesh).cast_local_ray(&line, ray.t_max, false);
    hit.map_or(Found::NOTHING, |(primitive, t)| Found { t, primitive })
}

impl Built for TriMesh {
    fn nearest(&mut self, rays: &[Ray], found: &mut [Found]) {
        for (ray, found) in rays.iter().zip(found) {
            *found = nearest(self, ray);
        }
    }

    fn any_hit(&mut self, rays: &[Ray], found: &mut [bool]) {
        for (ray, found) in rays.iter().zip(found) {
            *found = nearest(self, ray) != Found::NOTHING;
        }
    }
}
