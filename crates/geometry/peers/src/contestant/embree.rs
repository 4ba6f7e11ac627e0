//! Embree 4, if the machine has it.
#![allow(unsafe_code, reason = "Embree is spoken to in C")]

mod library;

use super::{Built, Contestant, Found};
use library::{Library, RayHit, Scene};
use traylib_geometry::Ray;

/// Builders and modes, as the library numbers them.
const MEDIUM: u32 = 1;
const HIGH: u32 = 2;
const FAST: u32 = 0;
const ROBUST: u32 = 1 << 2;

/// Nobody, without a library.
pub(super) fn all() -> Vec<Contestant> {
    let Some(library) = Library::find() else {
        return Vec::new();
    };
    // In robust mode it builds the same tree for either quality.
    let settings = [
        ("Embree, medium, fast", MEDIUM, FAST),
        ("Embree, high, fast", HIGH, FAST),
        ("Embree, medium, robust", MEDIUM, ROBUST),
    ];
    let contestant = |(name, quality, flags)| {
        Contestant::new(name, move |mesh| Scene::new(library, mesh, quality, flags))
    };
    settings.map(contestant).into()
}

impl Built for Scene {
    fn nearest(&mut self, rays: &[Ray], found: &mut [Found]) {
        for (ray, found) in rays.iter().zip(found) {
            let mut query = RayHit::new(ray);
            self.intersect(&mut query);
            *found = query.found();
        }
    }

    fn any_hit(&mut self, rays: &[Ray], found: &mut [bool]) {
        for (ray, found) in rays.iter().zip(found) {
            *found = self.occluded(&mut RayHit::new(ray));
        }
    }

    fn bytes_elsewhere(&self) -> usize {
        self.bytes()
    }
}
