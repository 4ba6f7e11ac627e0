//! A model and what lies over it.

use crate::{Maps, Site, SurfaceModel};
use traylib_math::{Rgb, Vec2, Vec3};

/// The material of a surface: how it scatters light, how much of it passes straight through as if
/// the surface were not there, and its textures.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The model by which light is scattered, where a texture does not say otherwise.
    pub model: SurfaceModel,
    /// The part of the light that passes straight through, in 0..1: a pane of
    /// clear glass, which is too thin to shift what is behind it. Together with
    /// what the model scatters it is at most one.
    pub through: Rgb,
    /// Its textures, if it has any.
    pub maps: Option<Box<Maps>>,
}

/// A material at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shading {
    /// The model by which light is scattered where the surface is.
    pub model: SurfaceModel,
    /// The part of the surface that is there, in 0..1.
    pub opacity: f32,
    /// The part of the light that passes straight through, also where the
    /// surface is not.
    pub through: Rgb,
    /// Unit shading normal.
    pub normal: Vec3,
}

impl From<SurfaceModel> for Material {
    fn from(model: SurfaceModel) -> Self {
        Self { model, through: Rgb::BLACK, maps: None }
    }
}

impl Material {
    /// Tells whether light can pass straight through somewhere.
    pub fn is_see_through(&self) -> bool {
        !self.through.is_black() || self.has_opacity()
    }

    /// Tells whether parts of the surface may not be there.
    pub fn has_opacity(&self) -> bool {
        self.maps.as_ref().is_some_and(|maps| maps.opacity.is_some())
    }

    /// Tells whether it has pictures, of colour or of opacity.
    pub fn has_pictures(&self) -> bool {
        self.maps.as_ref().is_some_and(|maps| maps.have_pictures())
    }

    /// Tells whether it has a bump map.
    pub fn has_bumps(&self) -> bool {
        self.maps.as_ref().is_some_and(|maps| maps.bump.is_some())
    }

    /// The material with the mean of each picture in its place, of colour as of opacity: no more
    /// than a model where a picture has no end, which takes no look-up any more. Bump maps stay.
    #[must_use]
    pub fn averaged(&self) -> Self {
        let Some(maps) = &self.maps else { return self.clone() };
        let [even, rest] = maps.averaged();
        Self { model: even.apply(self.model, Vec2::ZERO), ..self.clone() }.with_maps(rest)
    }

    /// The material without its bump map.
    #[must_use]
    pub fn without_bumps(&self) -> Self {
        let Some(maps) = &self.maps else { return self.clone() };
        self.clone().with_maps(Maps { bump: None, ..Maps::clone(maps) })
    }

    fn with_maps(self, maps: Maps) -> Self {
        Self { maps: (maps != Maps::default()).then(|| Box::new(maps)), ..self }
    }

    /// Returns the part of the surface that is there at a place, in 0..1.
    pub fn opacity(&self, site: impl FnOnce() -> Option<Site>) -> f32 {
        let Some(maps) = self.maps.as_ref().filter(|maps| maps.opacity.is_some()) else {
            return 1.0;
        };
        site().map_or(1.0, |site| maps.opacity(site.uv))
    }

    /// The part of the light that passes straight through at a place, as in
    /// [`Shading::through`].
    #[inline]
    pub fn through_at(&self, site: impl FnOnce() -> Option<Site>) -> Rgb {
        self.through_where(self.opacity(site))
    }

    fn through_where(&self, opacity: f32) -> Rgb {
        self.through * opacity + Rgb::splat(1.0 - opacity)
    }

    /// The material at a place whose unit shading normal without a bump map is
    /// `normal`.
    #[inline]
    pub fn at(&self, normal: Vec3, site: impl FnOnce() -> Option<Site>) -> Shading {
        let plain = Shading { model: self.model, opacity: 1.0, through: self.through, normal };
        let Some(maps) = &self.maps else { return plain };
        let Some(site) = site() else { return plain };
        let opacity = maps.opacity(site.uv);
        Shading {
            model: maps.apply(self.model, site.uv),
            opacity,
            through: self.through_where(opacity),
            normal: maps.shading_normal(normal, &site),
        }
    }
}
