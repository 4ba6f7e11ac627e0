//! This crate: watertight, fast, and in batches.

use super::{Built, Contestant, Found};
use traylib_geometry::{Bvh, Hit, Mesh, Options, Precision, Ray};

pub(super) fn all() -> Vec<Contestant> {
    vec![
        Contestant::new("ours, watertight", |mesh| tree(mesh, Precision::Watertight).map(Single)),
        Contestant::new("ours, fast", |mesh| tree(mesh, Precision::Fast).map(Single)),
        Contestant::new("ours, batch", |mesh| {
            tree(mesh, Precision::Watertight).map(|bvh| Batch { bvh, hits: Vec::new() })
        }),
    ]
}

fn tree(mesh: &Mesh, precision: Precision) -> Result<Bvh, String> {
    let options = Options { precision, ..Options::default() };
    Bvh::build_with(mesh, options).map_err(|error| error.to_string())
}

fn found(hit: Option<Hit>) -> Found {
    hit.map_or(Found::NOTHING, |hit| Found { t: hit.t, primitive: hit.primitive })
}

/// One call a ray.
struct Single(Bvh);

impl Built for Single {
    fn nearest(&mut self, rays: &[Ray], answers: &mut [Found]) {
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = found(self.0.nearest(ray));
        }
    }

    fn any_hit(&mut self, rays: &[Ray], answers: &mut [bool]) {
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = self.0.any_hit(ray);
        }
    }
}

/// One call for all rays.
struct Batch {
    bvh: Bvh,
    hits: Vec<Option<Hit>>,
}

impl Built for Batch {
    fn nearest(&mut self, rays: &[Ray], answers: &mut [Found]) {
        self.hits.resize(rays.len(), None);
        self.bvh.nearest_each(rays, &mut self.hits);
        for (hit, answer) in self.hits.iter().zip(answers) {
            *answer = found(*hit);
        }
    }

    fn any_hit(&mut self, rays: &[Ray], answers: &mut [bool]) {
        self.bvh.any_hit_each(rays, answers);
    }
}
