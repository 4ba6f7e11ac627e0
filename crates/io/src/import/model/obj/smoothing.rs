//! Normals of smoothing groups.
//!
//! Faces of one group join smoothly wherever they share a position. The normal there is the
//! mean of the unit normals of these faces, each weighted by its angle. Faces of no group
//! are flat.

use crate::obj::{Corner, Document, Face};
use crate::polygon::newell;
use std::collections::HashMap;
use traylib_math::Vec3;
use traylib_math::glam::DVec3;

/// Tells whether a face's normals are those of its group.
pub(super) fn is_smoothed(face: &Face, corners: &[Corner]) -> bool {
    face.smoothing != 0 && corners.iter().any(|corner| corner.normal.is_none())
}

/// Computes a unit normal for each position and group that meet.
pub(super) fn normals(document: &Document) -> HashMap<(u32, u32), Vec3> {
    let mut sums: HashMap<(u32, u32), DVec3> = HashMap::new();
    for face in &document.faces {
        let corners = document.corners_of(face);
        if !is_smoothed(face, corners) {
            continue;
        }
        let at = |index: usize| {
            document.positions[corners[index % corners.len()].position as usize].as_dvec3()
        };
        let front = newell((0..corners.len()).map(at)).normalize_or_zero();
        for (index, corner) in corners.iter().enumerate() {
            let here = at(index);
            let [next, last] = [index + 1, index + corners.len() - 1].map(|other| at(other) - here);
            let angle = next.cross(last).length().atan2(next.dot(last));
            *sums.entry((corner.position, face.smoothing)).or_default() += front * angle;
        }
    }
    let unit = |(key, sum): (_, DVec3)| (key, sum.normalize_or_zero().as_vec3());
    sums.into_iter().map(unit).collect()
}
