//! Directions around an axis, in double precision.

use glam::DVec3;

/// A right-handed orthonormal basis whose first vector is along `axis`, of any
/// length but zero.
pub fn frame(axis: DVec3) -> [DVec3; 3] {
    let axis = axis.normalize();
    let u = axis.any_orthonormal_vector();
    [axis, u, axis.cross(u)]
}
