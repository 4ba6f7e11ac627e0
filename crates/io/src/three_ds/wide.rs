//! Vectors in double precision, so that faces of any size have a normal.

use traylib_math::Vec3;

pub(super) type Wide = [f64; 3];

pub(super) fn widen(a: Vec3) -> Wide {
    a.to_array().map(f64::from)
}

/// b − a.
pub(super) fn difference(a: Vec3, b: Vec3) -> Wide {
    let (a, b) = (widen(a), widen(b));
    std::array::from_fn(|i| b[i] - a[i])
}

pub(super) fn cross(a: Wide, b: Wide) -> Wide {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn dot(a: Wide, b: Wide) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn add(a: Wide, b: Wide) -> Wide {
    std::array::from_fn(|i| a[i] + b[i])
}

pub(super) fn times(a: Wide, factor: f64) -> Wide {
    a.map(|x| x * factor)
}

/// The vector with length one; `None` if it has no direction.
pub(super) fn unit(a: Wide) -> Option<Wide> {
    let length = dot(a, a).sqrt();
    (length > 0.0 && length.is_finite()).then(|| times(a, 1.0 / length))
}

/// The angle between two vectors in radians.
pub(super) fn angle(a: Wide, b: Wide) -> f64 {
    let normal = cross(a, b);
    dot(normal, normal).sqrt().atan2(dot(a, b))
}

/// Rounded to single precision.
pub(super) fn narrow(a: Wide) -> Vec3 {
    Vec3::from(a.map(|x| x as f32))
}
