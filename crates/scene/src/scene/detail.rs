//! The scene with less detail on its surfaces, to see what the detail is worth.

use super::{Scene, Stage};
use crate::Error;
use crate::images::MirroredLights;
use crate::seat::seats;
use crate::surfaces::{Surface, Surfaces};
use std::sync::Arc;
use traylib_geometry::Bvh;
use traylib_materials::Material;
use traylib_math::Vec2;

/// A detail of surfaces that a scene may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// Pictures of colour and of opacity.
    Pictures,
    /// Bump maps, which tilt normals.
    Bumps,
    /// Normals between the corners of a mesh that are not those of its triangles.
    SmoothNormals,
}

impl Detail {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Pictures, Self::Bumps, Self::SmoothNormals];
}

impl Scene {
    /// Tells whether any of its surfaces has such a detail: a material that no surface shows has
    /// none.
    pub fn has(&self, detail: Detail) -> bool {
        let Stage { tree, materials, .. } = &*self.stage;
        let material = |surface: &Surface<'_>| &materials[surface.material()];
        tree.shapes().all().any(|surface| match detail {
            Detail::Pictures => material(&surface).has_pictures() && takes_pictures(&surface),
            Detail::Bumps => {
                let site = surface.site_of_textures(Vec2::ZERO);
                material(&surface).has_bumps() && site.is_some_and(|site| site.tangents.is_some())
            }
            Detail::SmoothNormals => surface.is_bent(),
        })
    }

    /// Returns the scene without such details, with the same camera, lamps and shapes: the mean of
    /// each picture in its place, no bumps, or the normals of the geometry alone.
    ///
    /// Pictures stay on a material of which some shape takes none, as a ball: it would not have
    /// had their mean either.
    ///
    /// # Errors
    /// [`Error::Geometry`] if there is no room for the shapes once more.
    pub fn without(&self, detail: Detail) -> Result<Self, Error> {
        let old = &*self.stage;
        let (surfaces, materials) = (old.tree.shapes().clone(), &old.materials);
        let (surfaces, materials) = match detail {
            Detail::Pictures => {
                let averaged = averaged(&surfaces, materials);
                (surfaces, averaged)
            }
            Detail::Bumps => (surfaces, materials.iter().map(Material::without_bumps).collect()),
            Detail::SmoothNormals => (surfaces.without_smooth_normals()?, materials.clone()),
        };
        let tree = Bvh::of_shapes(surfaces)?;
        let stage = Stage {
            see_through: materials.iter().any(Material::is_see_through),
            lights: old.lights.clone(),
            has_points: old.has_points,
            seats: seats(&old.lights, &materials, tree.shapes()),
            lifted_lights: old.lifted_lights,
            light_by_power: old.light_by_power.clone(),
            light_for_point: old.light_for_point.clone(),
            mirrored_lights: MirroredLights::new(tree.shapes(), &materials, &old.lights),
            tree,
            materials,
        };
        Ok(Self { stage: Arc::new(stage), ..self.clone() })
    }
}

/// Tells whether pictures lie on the surface.
fn takes_pictures(surface: &Surface<'_>) -> bool {
    surface.site_of_textures(Vec2::ZERO).is_some()
}

/// The materials with the mean of each picture, as far as all shapes take them.
fn averaged(surfaces: &Surfaces, materials: &[Material]) -> Vec<Material> {
    let mut averaged: Vec<Material> = materials.iter().map(Material::averaged).collect();
    for surface in surfaces.all().filter(|surface| !takes_pictures(surface)) {
        averaged[surface.material()].clone_from(&materials[surface.material()]);
    }
    averaged
}

#[cfg(test)]
mod tests;
