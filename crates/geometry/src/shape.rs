//! The trait that shapes implement, and the shapes that scenes are made of.

mod cone;
mod disk;
mod even_pdf;
mod facing;
mod kind;
mod list;
mod quad;
mod solid_angle;
mod sphere;
mod triangle;

pub use cone::Cone;
pub use disk::Disk;
pub(crate) use even_pdf::even_pdf;
pub use facing::Facing;
pub use kind::{ShapeKind, SidedTriangle};
pub use list::ShapeList;
pub use quad::Quad;
pub(crate) use solid_angle::{SphericalRectangle, SphericalTriangle};
pub use sphere::Sphere;
pub use triangle::Triangle;

use crate::precise::DVec3;
use crate::{Aabb, Error, Ray, ShapeHit, Vec3};

/// A shape that a [`Bvh`](crate::Bvh) can hold.
pub trait Shape: Send + Sync {
    /// A box that holds the whole shape, rounding included.
    fn bounds(&self) -> Aabb;

    /// The first hit with 0 < t < `ray.t_max`.
    fn intersect(&self, ray: &Ray) -> Option<ShapeHit>;

    /// Returns the kind of shape that it is to a tree, which asks [`intersect`](Self::intersect) of
    /// [`ShapeKind::Other`] alone.
    fn kind(&self) -> ShapeKind {
        ShapeKind::Other
    }
}

impl<S: Shape + ?Sized> Shape for Box<S> {
    fn bounds(&self) -> Aabb {
        (**self).bounds()
    }

    fn intersect(&self, ray: &Ray) -> Option<ShapeHit> {
        (**self).intersect(ray)
    }

    fn kind(&self) -> ShapeKind {
        (**self).kind()
    }
}

/// The sides on which a ray may meet a surface. The front is the side the normal points to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sides {
    /// On either side.
    #[default]
    Both,
    /// On the front only: from behind, rays pass through.
    Front,
}

impl Sides {
    /// Tells whether a ray counts that meets the surface with this cosine (up to a positive factor)
    /// between its direction and the front normal.
    #[inline]
    pub(crate) fn admit(self, direction_dot_normal: f32) -> bool {
        self == Self::Both || direction_dot_normal < 0.0
    }
}

/// Shapes met from both sides when no sides are named, each with what it is to a tree.
macro_rules! shape_from_both_sides {
    ($($name:ty: $kind:expr),*) => {$(
        impl Shape for $name {
            #[inline]
            fn bounds(&self) -> Aabb {
                self.bounds()
            }

            #[inline]
            fn intersect(&self, ray: &Ray) -> Option<ShapeHit> {
                self.intersect(ray, Sides::Both)
            }

            fn kind(&self) -> ShapeKind {
                let kind: fn(Self, Sides) -> ShapeKind = $kind;
                kind(*self, Sides::Both)
            }
        }
    )*};
}

pub(crate) use shape_from_both_sides;

shape_from_both_sides!(
    Cone: |_, _| ShapeKind::Other,
    Disk: ShapeKind::Disk,
    Quad: ShapeKind::Quad,
    Sphere: ShapeKind::Sphere,
    Triangle: |triangle, sides| ShapeKind::Triangle(triangle.sided(sides))
);

/// Refuses areas that are zero or whose reciprocal is not a number.
fn sound_area(area: f64) -> Result<f32, Error> {
    let area = area as f32;
    if area.is_normal() { Ok(area) } else { Err(Error::NoArea) }
}

/// Refuses coordinates that are not finite.
fn all_finite(vectors: &[Vec3]) -> Result<(), Error> {
    if vectors.iter().all(|v| v.is_finite()) { Ok(()) } else { Err(Error::NotFinite) }
}

/// Returns the greatest distance by which a point moves out of a surface bent with `radius` if its
/// position is rounded along it, thrice: when it is made, and twice when a ray is lifted off it. It
/// counts on wires and beads far from the origin.
fn bend(position: DVec3, radius: f64) -> f32 {
    const THRICE: f64 = 3.0 * 0.5 * f32::EPSILON as f64;
    let aside_squared = THRICE * THRICE * position.length_squared();
    let reach = (radius * radius + aside_squared).sqrt() + radius;
    if reach > 0.0 { (aside_squared / reach) as f32 } else { 0.0 }
}

#[cfg(test)]
mod tests;
