//! A ray prepared for tests of boxes and triangles.

use crate::Ray;
use crate::watertight::Shear;

/// All that a walk needs to know of its ray, computed once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Prepared<'a> {
    pub(crate) ray: &'a Ray,
    pub(crate) boxes: BoxRay,
    pub(crate) shear: Shear,
}

impl<'a> Prepared<'a> {
    #[inline(always)]
    pub(crate) fn new(ray: &'a Ray) -> Self {
        Self { ray, boxes: BoxRay::new(ray), shear: Shear::along(&ray.direction) }
    }
}

/// Distances to near planes are made smaller and those to far planes larger by a
/// few roundings, which covers both the rounding here and, since errors of an
/// intersection grow with its distance too, that of the shapes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoxRay {
    pub(crate) origin: [f32; 3],
    /// From a distance along an axis to t, for near and for far planes.
    pub(crate) near: [f32; 3],
    pub(crate) far: [f32; 3],
    /// Which row of a node holds the near plane of each axis; the far one is its
    /// neighbour. Kernels read at these places unchecked: they are below six.
    pub(crate) near_row: [usize; 3],
    /// See [`Node::order`](super::node::Node).
    pub(crate) octant: usize,
}

impl BoxRay {
    pub(crate) const NEARER: f32 = 1.0 - 4.0 * f32::EPSILON;
    pub(crate) const FARTHER: f32 = 1.0 + 4.0 * f32::EPSILON;

    #[inline]
    pub(crate) fn new(ray: &Ray) -> Self {
        let reciprocal = ray.direction.recip();
        // The reciprocal of −0 is negative: sign and order agree.
        let backward = reciprocal.to_array().map(|r| r < 0.0);
        Self {
            origin: ray.origin.to_array(),
            near: (reciprocal * Self::NEARER).to_array(),
            far: (reciprocal * Self::FARTHER).to_array(),
            near_row: std::array::from_fn(|axis| 2 * axis + usize::from(backward[axis])),
            octant: usize::from(backward[0])
                | usize::from(backward[1]) << 1
                | usize::from(backward[2]) << 2,
        }
    }
}
