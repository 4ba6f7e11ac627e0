//! Point lights in ideal mirrors: images that no direction meets, and that can be joined
//! with a surface all the same.

use super::mirror::Mirror;
use crate::surfaces::{Surface, Surfaces};
use crate::{Light, LightId};
use traylib_materials::Material;
use traylib_math::DiscreteDistribution;

/// Of so many pairs of mirror and light or fewer all are looked at from a point, of more only
/// one that is drawn.
const MOST_PAIRS: usize = 32;
/// No mirror and no light is drawn much more rarely than this part of its share if all were
/// alike.
const RAREST: f64 = 1.0 / 16.0;

/// Every ideal mirror whose images are where geometry has them, and every point light.
#[derive(Debug)]
pub(crate) struct MirroredPoints {
    mirrors: Vec<NumberedMirror>,
    mirror_by_area: DiscreteDistribution,
    lights: Vec<LightId>,
    light_by_power: DiscreteDistribution,
}

/// A mirror, and which of the scene's surfaces it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NumberedMirror {
    pub(crate) mirror: Mirror,
    pub(crate) surface: u32,
}

impl MirroredPoints {
    /// Finds the pairs of a scene, if there are any.
    pub(super) fn new(
        surfaces: &Surfaces,
        materials: &[Material],
        lights: &[Light],
    ) -> Option<Self> {
        let is_point = |(_, light): &(u32, &Light)| light.is_point();
        let (lights, powers): (Vec<LightId>, Vec<f32>) = (0..)
            .zip(lights)
            .filter(is_point)
            .map(|(index, light)| (LightId(index), light.power().luminance()))
            .unzip();
        let light_by_power = DiscreteDistribution::with_floor(&powers, RAREST)?;
        let numbered = |(number, surface): (u32, Surface<'_>)| {
            let mirror = ideal_mirror(surface, materials)?;
            Some(NumberedMirror { mirror, surface: number })
        };
        let mirrors: Vec<NumberedMirror> = (0..).zip(surfaces.all()).filter_map(numbered).collect();
        let areas: Vec<f32> = mirrors.iter().map(|numbered| numbered.mirror.area).collect();
        let mirror_by_area = DiscreteDistribution::with_floor(&areas, RAREST)?;
        Some(Self { mirrors, mirror_by_area, lights, light_by_power })
    }

    /// How many pairs are looked at.
    pub(crate) fn tries(&self) -> usize {
        if self.tries_all() { self.mirrors.len() * self.lights.len() } else { 1 }
    }

    fn tries_all(&self) -> bool {
        self.mirrors.len() * self.lights.len() <= MOST_PAIRS
    }

    /// A pair to look at, and the chance to do so; `u` is uniform.
    pub(crate) fn pair(&self, look: usize, u: [f64; 2]) -> (NumberedMirror, LightId, f32) {
        let count = self.lights.len();
        if self.tries_all() {
            return (self.mirrors[look / count], self.lights[look % count], 1.0);
        }
        // By how much light there may be: many mirrors are parts of one as a rule.
        let (mirror, of_mirrors) = self.mirror_by_area.choose(u[0]);
        let (light, of_lights) = self.light_by_power.choose(u[1]);
        (self.mirrors[mirror], self.lights[light], of_mirrors * of_lights)
    }

    /// The mirror that is this surface, and the chance to look at its pair with this light;
    /// `None` of what is none, or no such light.
    pub(crate) fn pair_of(&self, surface: u32, light: LightId) -> Option<(Mirror, f32)> {
        // Both lists are in order.
        let mirror = self.mirrors.binary_search_by_key(&surface, |it| it.surface).ok()?;
        let light = self.lights.binary_search_by_key(&light.0, |it| it.0).ok()?;
        let chance = if self.tries_all() {
            1.0
        } else {
            self.mirror_by_area.probability(mirror) * self.light_by_power.probability(light)
        };
        Some((self.mirrors[mirror].mirror, chance))
    }
}

/// A surface as an ideal mirror. Relief bends its images as smooth normals do.
fn ideal_mirror(surface: Surface<'_>, materials: &[Material]) -> Option<Mirror> {
    let has_relief =
        materials[surface.material()].maps.as_ref().is_some_and(|maps| maps.bump.is_some());
    super::mirror(surface, materials).filter(|mirror| mirror.is_ideal() && !has_relief)
}
