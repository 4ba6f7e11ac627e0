//! Vectors in double precision, for what is computed once and used often.
//!
//! A product of two f32 differences is exact in f64, so the normal of the
//! thinnest triangle is right to the last bit of its f32 result; in single
//! precision a sliver of aspect 10⁵ would have a normal off by a percent.

use crate::Vec3;

/// A vector in double precision.
pub(crate) type Wide = [f64; 3];

/// The vector, unchanged.
pub(crate) fn wide(v: Vec3) -> Wide {
    v.to_array().map(f64::from)
}

/// The vector times a factor, rounded.
pub(crate) fn narrow(v: Wide, factor: f64) -> Vec3 {
    Vec3::from_array(v.map(|c| (c * factor) as f32))
}

/// a − b.
pub(crate) fn difference(a: Vec3, b: Vec3) -> Wide {
    let (a, b) = (wide(a), wide(b));
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a × b.
pub(crate) fn cross(a: Wide, b: Wide) -> Wide {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// |v|².
pub(crate) fn length_squared(v: Wide) -> f64 {
    v[0] * v[0] + v[1] * v[1] + v[2] * v[2]
}

/// The unit vector along `v`, rounded; `None` for zero and what is not finite.
pub(crate) fn unit(v: Wide) -> Option<Vec3> {
    let length = length_squared(v).sqrt();
    length.is_normal().then(|| narrow(v, 1.0 / length))
}
