//! Shapes that lie in one place up to rounding, and how to tell and to end it.

use super::Primitive;
use crate::{Error, Ray, Sides, SurfaceSite, Vec2, Vec3};

/// The number of bounds on error by which two shapes may be apart and still lie in one place: one
/// for the rounding of each, and as much for the decimal numbers that they were made of.
const BOUNDS: f32 = 4.0;

impl SurfaceSite {
    /// A ray along the normal through everything that lies in one place with this point
    /// of a surface, rounding included.
    pub fn through(&self) -> Ray {
        let reach = BOUNDS * self.height();
        Ray { t_max: 2.0 * reach, ..Ray::new(self.position - self.normal * reach, self.normal) }
    }
}

impl Primitive {
    /// The site of a point that lies on the surface up to rounding: its error reaches off
    /// the surface on either side. `None` for a point that does not lie there.
    pub fn touching(&self, point: Vec3) -> Option<SurfaceSite> {
        let site = SurfaceSite { position: point, ..self.site_near(point) };
        self.intersect(&site.through(), Sides::Both)?;
        Some(site.with_error((BOUNDS + 1.0) * site.height()))
    }

    /// The shape lifted off its front by so many times what makes two shapes lie in one
    /// place: flat ones moved, round ones widened or narrowed.
    ///
    /// # Errors
    /// Those of the shape, where rounding leaves nothing of it.
    pub fn lifted(&self, times: f32) -> Result<Self, Error> {
        let bounds = self.bounds();
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        // At least the height of any site, whose normal's coordinates sum up to √3.
        let height = f32::EPSILON * (8.0 * largest + 16.0 * bounds.extent().max_element());
        let height = 2.0 * BOUNDS * times * height;
        let offset = self.sample_area(Vec2::splat(0.5)).normal * height;
        self.lifted_by(height, offset)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;
    use crate::testing::shape::thickness;

    #[test]
    fn points_of_a_surface_touch_it() {
        let mut random = Random::new(41);
        for i in 0..20_000 {
            let place = if i % 2 == 0 { Vec3::ZERO } else { 1e3 * random.point() };
            let shape = random.primitive(place);
            let inside = Vec2::splat(0.05) + 0.9 * random.square();
            let on = shape.sample_area(inside);
            let touching = shape.touching(on.position);
            assert!(touching.is_some(), "{shape:?} {on:?}");
            // Far from the origin a thin cone has its other side there.
            let off = on.position + on.normal * 40.0 * on.height();
            assert!(i % 2 == 1 || shape.touching(off).is_none(), "{shape:?} {on:?}");
        }
    }

    /// Seen along the normal, the lifted one comes first.
    #[test]
    fn what_is_lifted_lies_in_front() {
        let mut random = Random::new(42);
        for i in 0..20_000 {
            let place = if i % 2 == 0 { Vec3::ZERO } else { 1e2 * random.point() };
            let shape = random.primitive(place);
            let Ok(lifted) = shape.lifted(1.0) else {
                // Of what is that thin nothing is left.
                assert!(thickness(&shape) < 1e-4 * (1.0 + f64::from(place.length())), "{shape:?}");
                continue;
            };
            let on = shape.sample_area(Vec2::splat(0.05) + 0.9 * random.square());
            let down = Ray::new(on.position + 1e-2 * on.normal, -on.normal);
            let t = |shape: &Primitive| shape.intersect(&down, Sides::Front).map(|hit| hit.t);
            let (Some(before), Some(after)) = (t(&shape), t(&lifted)) else { continue };
            assert!(after < before, "{shape:?} {lifted:?}");
            assert!(before - after < 1e-4 * (1.0 + place.length()), "{shape:?} {lifted:?}");
        }
    }
}
