//! Polygons into triangles that share their corners.

use super::smoothing;
use crate::import::model::arrays::Arrays;
use crate::obj::{Corner, Document, Face};
use crate::polygon;
use std::collections::{BTreeMap, HashMap};
use traylib_math::Vec3;

/// What triangles are kept together by: material, and whether their corners have texture
/// coordinates and normals.
pub(super) type Key = (Option<u32>, bool, bool);

/// What the normal of a corner is.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Normal {
    None,
    /// One of the file's.
    Given(u32),
    /// That of a smoothing group there.
    Smooth(u32),
    /// That of this face.
    Flat(u32),
}

/// A corner that others may share: position, texture coordinates, normal.
type Shared = (u32, Option<u32>, Normal);

pub(super) struct Welder<'a> {
    document: &'a Document,
    smooth: HashMap<(u32, u32), Vec3>,
    meshes: BTreeMap<Key, (Arrays, HashMap<Shared, u32>)>,
    /// Faces so far.
    faces: u32,
}

impl<'a> Welder<'a> {
    pub(super) fn new(document: &'a Document) -> Self {
        let smooth = smoothing::normals(document);
        Self { document, smooth, meshes: BTreeMap::new(), faces: 0 }
    }

    pub(super) fn add(&mut self, face: &Face) {
        let corners = self.document.corners_of(face);
        let has_uvs = corners.iter().all(|corner| corner.uv.is_some());
        let has_normals =
            face.smoothing != 0 || corners.iter().any(|corner| corner.normal.is_some());
        let number = self.faces;
        self.faces += 1;
        let position = |corner: &Corner| self.document.positions[corner.position as usize];
        let outline = || corners.iter().map(|corner| position(corner).as_dvec3());
        let front = polygon::newell(outline());
        let triangles = match corners.len() {
            3 => vec![[0, 1, 2]],
            _ => polygon::cut(outline(), front),
        };
        let (arrays, numbers) =
            self.meshes.entry((face.material, has_uvs, has_normals)).or_default();
        let mut shared = |corner: &Corner| {
            let uv = corner.uv.filter(|_| has_uvs).map(crate::obj::Index::get);
            let normal = match (has_normals, corner.normal, face.smoothing) {
                (false, ..) => Normal::None,
                (true, Some(index), _) => Normal::Given(index.get()),
                (true, None, 0) => Normal::Flat(number),
                (true, None, group) => Normal::Smooth(group),
            };
            *numbers.entry((corner.position, uv, normal)).or_insert_with(|| {
                arrays.positions.push(position(corner));
                arrays.uvs.extend(uv.map(|index| self.document.uvs[index as usize]));
                arrays.normals.extend(match normal {
                    Normal::None => None,
                    Normal::Given(index) => Some(self.document.normals[index as usize]),
                    Normal::Smooth(group) => Some(
                        self.smooth.get(&(corner.position, group)).copied().unwrap_or_default(),
                    ),
                    Normal::Flat(_) => Some(front.normalize_or_zero().as_vec3()),
                });
                arrays.positions.len() as u32 - 1
            })
        };
        let numbers: Vec<u32> = corners.iter().map(&mut shared).collect();
        arrays.triangles.extend(triangles.into_iter().map(|t| t.map(|corner| numbers[corner])));
    }

    pub(super) fn finish(self) -> BTreeMap<Key, Arrays> {
        self.meshes.into_iter().map(|(key, (arrays, _))| (key, arrays)).collect()
    }
}
