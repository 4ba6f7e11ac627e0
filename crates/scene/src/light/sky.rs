//! The sky: light from infinitely far away, all around the scene.
//!
//! A point of the sky is a direction, so its densities are per steradian where those of a
//! lamp's point are per square metre. Light from one direction falls in parallel: a light path
//! starts anywhere on the shadow of the scene's box in that direction, with a density per square
//! metre where a lamp's has one per steradian. All formulas of lamps hold with both exchanged,
//! and with cosine and distance one at the sky's end of an edge.
//!
//! Pharr, Jakob and Humphreys, *Physically Based Rendering*, 4th ed., sections 12.5 and 16.3,
//! use a disk for the shadow of the box.

mod picture;
mod shadow;

pub(crate) use picture::SkyPicture;

use super::{Emission, LightPoint};
use shadow::BoxShadow;
use traylib_geometry::{Aabb, SurfaceSite};
use traylib_math::{AreaPdf, Rgb, Vec2, Vec3};

/// A lamp infinitely far away, with a radiance of its own in each direction.
#[derive(Clone, Debug)]
pub struct Sky {
    picture: SkyPicture,
    shadow: BoxShadow,
}

impl Sky {
    /// The sky of a scene within these bounds.
    pub(crate) fn new(picture: SkyPicture, bounds: &Aabb) -> Self {
        Self { picture, shadow: BoxShadow::of(bounds) }
    }

    /// The radiance that comes from the unit direction `toward` the sky, in W/(m²·sr).
    pub fn radiance(&self, toward: Vec3) -> Rgb {
        self.picture.radiance(toward)
    }

    /// The power in W that falls on the box around the scene, counted as if the box were as
    /// large from all directions; for a sky that is the same all around it is exact.
    pub fn power(&self) -> Rgb {
        self.picture.integral() * self.shadow.mean_area()
    }

    /// A direction to aim at from anywhere, as a point of the sky, with its density per
    /// steradian: by brightness.
    pub(crate) fn sample_toward(&self, u: Vec2) -> (LightPoint, AreaPdf) {
        let point = self.point(self.picture.sample(u));
        (point, AreaPdf(self.pdf(&point)))
    }

    /// The density with which a point of the sky is aimed at or starts light paths, per steradian.
    pub(crate) fn pdf(&self, point: &LightPoint) -> f32 {
        self.picture.pdf(point.emitted)
    }

    /// A direction by brightness, and a start on the shadow of the scene's box.
    pub(crate) fn sample_emission(&self, u_point: Vec2, u_direction: Vec2) -> Emission {
        let toward = self.picture.sample(u_direction);
        let mut point = self.point(toward);
        point.site.position = self.shadow.sample(toward, u_point);
        Emission { point, direction: -toward }
    }

    /// The density with which light paths that come from a direction start at any place of the
    /// box's shadow, per square metre across that direction: what
    /// [`LightPoint::direction_pdf`] is for lamps.
    pub(crate) fn shadow_pdf(&self, toward: Vec3) -> f32 {
        1.0 / self.shadow.area(toward)
    }

    /// The point of the sky in this unit direction.
    #[inline(never)]
    pub(crate) fn point(&self, toward: Vec3) -> LightPoint {
        LightPoint {
            emitted: self.picture.radiance(toward),
            is_sky: true,
            ..LightPoint::on_surface(site(toward), Rgb::BLACK)
        }
    }
}

/// The sky as a surface seen in this unit direction: it faces whoever looks. There is no place
/// that far away; the direction stands for it.
pub(crate) fn site(toward: Vec3) -> SurfaceSite {
    SurfaceSite { position: toward, error: Vec3::ZERO, normal: -toward }
}

impl LightPoint {
    /// Returns the unit direction from anywhere to a point of the sky.
    pub(crate) fn toward_sky(&self) -> Vec3 {
        -self.site.normal
    }
}

#[cfg(test)]
mod tests;
