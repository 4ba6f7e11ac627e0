//! Many shapes with numbers.

use super::{Shape, ShapeHit, ShapeKind};
use crate::{Aabb, Ray};

/// Shapes numbered from zero, in whatever form their owner keeps them: a list of
/// [`Shape`]s is one, and so is what draws some from meshes and some from elsewhere.
pub trait ShapeList: Send + Sync {
    /// Returns the number of shapes.
    fn count(&self) -> usize;

    /// [`Shape::bounds`] of one of them.
    fn bounds(&self, index: usize) -> Aabb;

    /// [`Shape::intersect`] of one that is [`ShapeKind::Other`].
    fn intersect(&self, index: usize, ray: &Ray) -> Option<ShapeHit>;

    /// [`Shape::kind`] of one of them.
    fn kind(&self, index: usize) -> ShapeKind;
}

impl<S: Shape> ShapeList for Vec<S> {
    fn count(&self) -> usize {
        self.len()
    }

    fn bounds(&self, index: usize) -> Aabb {
        self[index].bounds()
    }

    #[inline]
    fn intersect(&self, index: usize, ray: &Ray) -> Option<ShapeHit> {
        self[index].intersect(ray)
    }

    fn kind(&self, index: usize) -> ShapeKind {
        self[index].kind()
    }
}
