//! Triangles of a mesh.

use super::accessor::Arrays;
use super::budget::Budget;
use super::{Cause, Error, Primitive, WarningKind, json};
use crate::warning_counts::WarningCounts;
use traylib_math::{Vec2, Vec3};

/// Reads primitives.
pub(super) struct Reader<'a, 'b> {
    pub(super) arrays: &'b Arrays<'a>,
    pub(super) vertices: &'b mut Budget,
    pub(super) warnings: &'b mut WarningCounts<WarningKind>,
}

impl Reader<'_, '_> {
    /// Reads a primitive whose material wants this set of texture coordinates; `None` of what has
    /// no triangles.
    pub(super) fn primitive(
        &mut self,
        primitive: &json::Primitive,
        place: &str,
        set: u32,
    ) -> Result<Option<Primitive>, Error> {
        if primitive.mode < 4 {
            self.warnings.add(WarningKind::PointsOrLines);
            return Ok(None);
        }
        let Some(&position) = primitive.attributes.get("POSITION") else { return Ok(None) };
        let here = |cause| Error::at(place, cause);
        self.vertices.take(self.arrays.count(position, place)?).map_err(here)?;
        let positions: Vec<Vec3> = self.vectors(position, place)?;
        if !positions.iter().all(|position| position.is_finite()) {
            return Err(Error::at(format!("accessors[{position}]"), Cause::NotFinite));
        }
        let count = positions.len();
        let normals = self.attribute(primitive, "NORMAL", count, place)?;
        let uvs = self.uvs(primitive, &format!("TEXCOORD_{set}"), count, place)?;
        if primitive.attributes.keys().any(|name| name.starts_with("COLOR_")) {
            self.warnings.add_many(WarningKind::VertexColour, count);
        }
        self.warnings.add_many(WarningKind::MorphTarget, primitive.targets.len());
        let triangles = self.triangles(primitive, place, count)?;
        let material = primitive.material.map(|material| material as usize);
        Ok(Some(Primitive { material, positions, normals, uvs, triangles }))
    }

    fn vectors(&self, accessor: u64, place: &str) -> Result<Vec<Vec3>, Error> {
        let vectors = self.arrays.vectors::<3>(accessor, place)?;
        Ok(vectors.into_iter().map(Vec3::from).collect())
    }

    fn attribute(
        &mut self,
        primitive: &json::Primitive,
        name: &str,
        wanted: usize,
        place: &str,
    ) -> Result<Vec<Vec3>, Error> {
        let Some(&accessor) = primitive.attributes.get(name) else { return Ok(Vec::new()) };
        self.check_count(accessor, wanted, place)?;
        let mut normals = self.vectors(accessor, place)?;
        for normal in normals.iter_mut().filter(|normal| !normal.is_finite()) {
            *normal = Vec3::ZERO;
            self.warnings.add(WarningKind::NormalNotFinite);
        }
        Ok(normals)
    }

    fn uvs(
        &mut self,
        primitive: &json::Primitive,
        name: &str,
        wanted: usize,
        place: &str,
    ) -> Result<Vec<Vec2>, Error> {
        let Some(&accessor) = primitive.attributes.get(name) else { return Ok(Vec::new()) };
        self.check_count(accessor, wanted, place)?;
        let vectors = self.arrays.vectors::<2>(accessor, place)?;
        let mut uvs: Vec<Vec2> = vectors.into_iter().map(Vec2::from).collect();
        for uv in uvs.iter_mut().filter(|uv| !uv.is_finite()) {
            *uv = Vec2::ZERO;
            self.warnings.add(WarningKind::UvNotFinite);
        }
        Ok(uvs)
    }

    fn check_count(&self, accessor: u64, wanted: usize, place: &str) -> Result<(), Error> {
        let given = self.arrays.count(accessor, place)?;
        if given == wanted as u64 {
            return Ok(());
        }
        let given = usize::try_from(given).unwrap_or(usize::MAX);
        Err(Error::at(place, Cause::Count { given, wanted }))
    }

    fn triangles(
        &self,
        primitive: &json::Primitive,
        place: &str,
        count: usize,
    ) -> Result<Vec<[u32; 3]>, Error> {
        let Some(accessor) = primitive.indices else {
            return arranged(primitive.mode, count, |index| index as u32)
                .map_err(|cause| Error::at(place, cause));
        };
        let indices = self.arrays.indices(accessor, place)?;
        if let Some(&index) = indices.iter().find(|&&index| index as usize >= count) {
            let cause = Cause::OutOfRange { what: "vertex", index: index.into(), count };
            return Err(Error::at(format!("accessors[{accessor}]"), cause));
        }
        arranged(primitive.mode, indices.len(), |index| indices[index])
            .map_err(|cause| Error::at(place, cause))
    }
}

/// Makes triangles of corners in threes, as a strip, or around the first.
fn arranged(
    mode: u64,
    count: usize,
    corner: impl Fn(usize) -> u32,
) -> Result<Vec<[u32; 3]>, Cause> {
    let further = count.saturating_sub(2);
    Ok(match mode {
        4 => (0..count / 3).map(|i| [0, 1, 2].map(|place| corner(3 * i + place))).collect(),
        5 => (0..further).map(|i| [i, i + 1 + i % 2, i + 2 - i % 2].map(&corner)).collect(),
        6 => (0..further).map(|i| [i + 1, i + 2, 0].map(&corner)).collect(),
        _ => return Err(Cause::Kind("a `mode` from 0 to 6")),
    })
}
