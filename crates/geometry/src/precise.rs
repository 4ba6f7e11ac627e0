//! Vectors in double precision, for what is computed once and used often.
//!
//! A product of two f32 differences is exact in f64, so the normal of the
//! thinnest triangle is right to the last bit of its f32 result; in single
//! precision a sliver of aspect 10⁵ would have a normal off by a percent.

use crate::Vec3;

pub(crate) use traylib_math::glam::DVec3;

/// a − b.
pub(crate) fn difference(a: Vec3, b: Vec3) -> DVec3 {
    a.as_dvec3() - b.as_dvec3()
}

/// The unit vector along `v`, rounded; `None` for zero and what is not finite.
pub(crate) fn unit(v: DVec3) -> Option<Vec3> {
    let length = v.length();
    length.is_normal().then(|| (v * (1.0 / length)).as_vec3())
}
