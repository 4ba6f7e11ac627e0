//! The comparison of a scene that was written with what is read back.

use super::PartObject;
use crate::import::SceneParts;
use traylib_geometry::Mesh;
use traylib_scene::ObjectShape;

/// Counts the differences: objects, materials, lights, or all there is of one of them.
pub(super) fn differences(before: &SceneParts, after: &SceneParts) -> u32 {
    let camera = u32::from(before.camera != after.camera || before.settings != after.settings);
    // What files of meshes bring themselves stands behind ours.
    let materials = before.materials.iter().zip(&after.materials);
    let materials = materials.filter(|((_, a), (_, b))| a != b).count();
    let objects = before.objects.iter().zip(&after.objects);
    let objects = objects.filter(|(a, b)| !is_same(a, b)).count();
    let lights = before.lights.iter().zip(&after.lights);
    let lights = lights.filter(|(a, b)| a != b).count();
    let missing = before.objects.len().abs_diff(after.objects.len())
        + before.lights.len().abs_diff(after.lights.len())
        + before.materials.len().saturating_sub(after.materials.len());
    let sky = u32::from(before.sky != after.sky);
    camera + sky + (materials + objects + lights + missing) as u32
}

fn is_same(a: &PartObject, b: &PartObject) -> bool {
    let shape = match (&a.shape, &b.shape) {
        (ObjectShape::Primitive(a), ObjectShape::Primitive(b)) => a == b,
        (ObjectShape::Mesh(a), ObjectShape::Mesh(b)) => is_same_mesh(a, b),
        (ObjectShape::Primitive(_), ObjectShape::Mesh(_))
        | (ObjectShape::Mesh(_), ObjectShape::Primitive(_)) => false,
    };
    shape && a.sides == b.sides && a.material == b.material && a.emission == b.emission
}

fn is_same_mesh(a: &Mesh, b: &Mesh) -> bool {
    a.positions() == b.positions()
        && a.triangles() == b.triangles()
        && a.normals() == b.normals()
        && a.uvs() == b.uvs()
}
