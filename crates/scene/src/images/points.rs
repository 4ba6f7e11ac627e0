//! Point lights in ideal mirrors: images that no direction meets, and that can be joined
//! with a surface all the same.

use super::mirror::Mirror;
use super::reflection::Reflection;
use crate::surfaces::{Surface, Surfaces};
use crate::{Light, LightId};
use traylib_materials::Material;
use traylib_math::{DiscreteDistribution, Vec3};

/// The number of pairs of mirror and light that are all looked at from a point; of more only one
/// is, which is drawn.
const MOST_PAIRS: usize = 32;
/// No mirror and no light is drawn much more rarely than this part of its share if all were
/// alike.
const RAREST: f64 = 1.0 / 16.0;

/// Every ideal mirror whose images are where geometry has them, and every point light.
#[derive(Debug)]
pub(crate) struct MirroredPoints {
    mirrors: Vec<NumberedMirror>,
    mirror_by_area: DiscreteDistribution,
    /// Each seen in a flat one; none where [`MOST_PAIRS`] would not hold them all.
    rows: Vec<MirrorPath>,
    lights: Vec<LightId>,
    light_by_power: DiscreteDistribution,
}

/// One mirror, or two of which one is seen in the other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MirrorPath {
    /// The mirror that the surface sees.
    pub(crate) seen: NumberedMirror,
    /// The mirror that is seen in it, if not the light itself.
    pub(crate) shown: Option<NumberedMirror>,
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
        let rows = rows(&mirrors, MOST_PAIRS / lights.len());
        Some(Self { mirrors, mirror_by_area, rows, lights, light_by_power })
    }

    /// Returns the number of images that are looked at.
    pub(crate) fn tries(&self) -> usize {
        self.pairs_tried() + self.rows.len() * self.lights.len()
    }

    /// Returns how many of those are in one mirror.
    fn pairs_tried(&self) -> usize {
        if self.tries_all() { self.mirrors.len() * self.lights.len() } else { 1 }
    }

    fn tries_all(&self) -> bool {
        self.mirrors.len() * self.lights.len() <= MOST_PAIRS
    }

    /// An image to look at, and the chance to do so; `u` is uniform.
    pub(crate) fn image(&self, attempt: usize, u: [f64; 2]) -> (MirrorPath, LightId, f32) {
        let count = self.lights.len();
        if let Some(attempt) = attempt.checked_sub(self.pairs_tried()) {
            return (self.rows[attempt / count], self.lights[attempt % count], 1.0);
        }
        let (mirror, light, chance) = self.pair(attempt, u);
        (MirrorPath { seen: mirror, shown: None }, light, chance)
    }

    fn pair(&self, attempt: usize, u: [f64; 2]) -> (NumberedMirror, LightId, f32) {
        let count = self.lights.len();
        if self.tries_all() {
            return (self.mirrors[attempt / count], self.lights[attempt % count], 1.0);
        }
        // By how much light there may be: many mirrors are parts of one as a rule.
        let (mirror, of_mirrors) = self.mirror_by_area.choose(u[0]);
        let (light, of_lights) = self.light_by_power.choose(u[1]);
        (self.mirrors[mirror], self.lights[light], of_mirrors * of_lights)
    }

    /// The path by these surfaces, from the light on, and the chance to look for this light in
    /// it; `None` of what is none, or no such light.
    pub(crate) fn path_of(&self, surfaces: &[u32], light: LightId) -> Option<(MirrorPath, f32)> {
        match *surfaces {
            [only] => self.pair_of(only, light),
            [shown, seen] => {
                let is_there = |path: &&MirrorPath| {
                    path.seen.surface == seen && path.shown.is_some_and(|it| it.surface == shown)
                };
                self.rows.iter().find(is_there).map(|path| (*path, 1.0))
            }
            _ => None,
        }
    }

    fn pair_of(&self, surface: u32, light: LightId) -> Option<(MirrorPath, f32)> {
        // Both lists are in order.
        let mirror = self.mirrors.binary_search_by_key(&surface, |it| it.surface).ok()?;
        let light = self.lights.binary_search_by_key(&light.0, |it| it.0).ok()?;
        let chance = if self.tries_all() {
            1.0
        } else {
            self.mirror_by_area.probability(mirror) * self.light_by_power.probability(light)
        };
        Some((MirrorPath { seen: self.mirrors[mirror], shown: None }, chance))
    }
}

/// All mirrors as flat ones show them, if there are no more than this.
fn rows(mirrors: &[NumberedMirror], most: usize) -> Vec<MirrorPath> {
    // Of very many mirrors nobody needs all pairs.
    if mirrors.len() > MOST_PAIRS {
        return Vec::new();
    }
    let shown_in = |seen: NumberedMirror| {
        let others = mirrors.iter().filter(move |other| seen.mirror.may_show_mirror(&other.mirror));
        others.map(move |&other| MirrorPath { seen, shown: Some(other) })
    };
    let rows: Vec<MirrorPath> = mirrors.iter().copied().flat_map(shown_in).collect();
    if rows.len() <= most { rows } else { Vec::new() }
}

impl MirrorPath {
    /// Returns how light of a point arrives at another by this path, wherever mirrors end.
    pub(crate) fn reflection(&self, from: Vec3, light: Vec3) -> Option<Reflection> {
        match &self.shown {
            None => self.seen.mirror.reflection(from, light),
            Some(shown) => self.seen.mirror.reflection_of_reflection(&shown.mirror, from, light),
        }
    }
}

/// A surface as an ideal mirror. A bump map bends its images as smooth normals do.
fn ideal_mirror(surface: Surface<'_>, materials: &[Material]) -> Option<Mirror> {
    let is_bumped =
        materials[surface.material()].maps.as_ref().is_some_and(|maps| maps.bump.is_some());
    super::mirror(surface, materials).filter(|mirror| mirror.is_ideal() && !is_bumped)
}
