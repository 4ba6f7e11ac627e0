//! Polygons into triangles that share their corners.

use super::smoothing;
use crate::import::model::arrays::Arrays;
use crate::obj::{Corner, Document, Face, Index};
use crate::polygon;
use std::collections::{BTreeMap, HashMap};
use traylib_math::Vec3;

/// The properties by which triangles are kept together: material, and whether their corners have
/// texture coordinates and normals.
pub(super) type Key = (Option<u32>, bool, bool);

/// The normal of a corner.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Normal {
    None,
    /// One of the file's.
    Given(u32),
    /// The normal of a smoothing group there.
    Smooth(u32),
    /// The normal of this face.
    Flat(u32),
}

/// A corner that others may share: position, texture coordinates, normal.
type Shared = (u32, Option<u32>, Normal);

/// Collects polygons into meshes, one for each [`Key`].
pub(super) struct Welder<'a> {
    document: &'a Document,
    /// The normals of smoothing groups, by position and group.
    smooth: HashMap<(u32, u32), Vec3>,
    meshes: BTreeMap<Key, Welded>,
    /// Faces so far.
    faces: u32,
}

/// A mesh under way, and the numbers of its corners.
#[derive(Default)]
struct Welded {
    arrays: Arrays,
    numbers: HashMap<Shared, u32>,
}

impl<'a> Welder<'a> {
    pub(super) fn new(document: &'a Document) -> Self {
        let smooth = smoothing::normals(document);
        Self { document, smooth, meshes: BTreeMap::new(), faces: 0 }
    }

    /// Adds a polygon as triangles.
    pub(super) fn add(&mut self, face: &Face) {
        let corners = self.document.corners_of(face);
        let has_uvs = corners.iter().all(|corner| corner.uv.is_some());
        let has_normals =
            face.smoothing != 0 || corners.iter().any(|corner| corner.normal.is_some());
        let number = self.faces;
        self.faces += 1;
        let outline = || corners.iter().map(|corner| position(self.document, corner).as_dvec3());
        let front = polygon::newell(outline());
        let triangles = match corners.len() {
            3 => vec![[0, 1, 2]],
            _ => polygon::cut(outline(), front),
        };
        let welded = self.meshes.entry((face.material, has_uvs, has_normals)).or_default();
        let mut shared = |corner: &Corner| {
            let uv = corner.uv.filter(|_| has_uvs).map(Index::get);
            let normal = match (has_normals, corner.normal, face.smoothing) {
                (false, ..) => Normal::None,
                (true, Some(index), _) => Normal::Given(index.get()),
                (true, None, 0) => Normal::Flat(number),
                (true, None, group) => Normal::Smooth(group),
            };
            let key = (corner.position, uv, normal);
            welded.number(key, self.document, |normal| match normal {
                Normal::None => None,
                Normal::Given(index) => Some(self.document.normals[index as usize]),
                Normal::Smooth(group) => {
                    Some(self.smooth.get(&(corner.position, group)).copied().unwrap_or_default())
                }
                Normal::Flat(_) => Some(front.normalize_or_zero().as_vec3()),
            })
        };
        let numbers: Vec<u32> = corners.iter().map(&mut shared).collect();
        let triangles = triangles.into_iter().map(|t| t.map(|corner| numbers[corner]));
        welded.arrays.triangles.extend(triangles);
    }

    pub(super) fn finish(self) -> BTreeMap<Key, Arrays> {
        self.meshes.into_iter().map(|(key, welded)| (key, welded.arrays)).collect()
    }
}

impl Welded {
    /// Returns the number of a corner, which is added if it is new, with its normal.
    fn number(
        &mut self,
        shared: Shared,
        document: &Document,
        normal_of: impl FnOnce(Normal) -> Option<Vec3>,
    ) -> u32 {
        let arrays = &mut self.arrays;
        *self.numbers.entry(shared).or_insert_with(|| {
            let (position, uv, normal) = shared;
            arrays.positions.push(document.positions[position as usize]);
            arrays.uvs.extend(uv.map(|index| document.uvs[index as usize]));
            arrays.normals.extend(normal_of(normal));
            arrays.positions.len() as u32 - 1
        })
    }
}

fn position(document: &Document, corner: &Corner) -> Vec3 {
    document.positions[corner.position as usize]
}
