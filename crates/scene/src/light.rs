//! Lights: what emits into a scene.

pub(crate) mod sky;
mod spot;

pub use sky::Sky;
pub use spot::SpotCone;

use crate::Error;
use std::f32::consts::{FRAC_1_PI, PI};
use std::sync::Arc;
use traylib_geometry::{Primitive, Ray, SurfaceSite};
use traylib_math::{AreaPdf, Rgb, SolidAnglePdf, Vec2, Vec3, warp};

/// A lamp.
#[derive(Clone, Debug)]
pub enum Light {
    /// A surface that emits the same radiance (W/m²/sr) from every point of its
    /// front side into every direction.
    Area {
        /// The surface.
        primitive: Primitive,
        /// The radiance that it emits.
        radiance: Rgb,
    },
    /// A point that emits the same intensity (W/sr) into every direction, or into
    /// those of a cone.
    Point(PointLight),
    /// The sky, which shines from infinitely far away. There is one at most, after all other lamps.
    Sky(Arc<Sky>),
}

/// A lamp without extent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Its position.
    pub position: Vec3,
    /// W/sr; of a spot light, where it is full.
    pub intensity: Rgb,
    /// The cone in which a spot light shines; `None` for every direction alike.
    pub cone: Option<SpotCone>,
}

/// A point on a lamp: the first vertex x₀ of a light path.
#[derive(Clone, Copy, Debug)]
pub struct LightPoint {
    /// Where. Of a point light in free space error and normal are zero; of one that
    /// lies in a surface they are those of the surface.
    pub site: SurfaceSite,
    /// Emitted radiance in W/m²/sr, or a point light's intensity in W/sr.
    pub emitted: Rgb,
    /// Whether the lamp is a point.
    pub is_point: bool,
    /// Whether it is a point of the sky: a direction, whose site faces whoever looks that way. Its
    /// densities are per steradian where those of other lamps are per m². Its position is
    /// where a light path starts, else it has none.
    pub is_sky: bool,
    /// The cone in which it shines, if it is a spot light.
    pub cone: Option<SpotCone>,
}

/// A start of a light path.
#[derive(Clone, Copy, Debug)]
pub struct Emission {
    /// The point at which the path starts.
    pub point: LightPoint,
    /// The unit direction it takes.
    pub direction: Vec3,
}

impl LightPoint {
    /// A point of a surface that emits this radiance.
    #[inline]
    pub(crate) fn on_surface(site: SurfaceSite, radiance: Rgb) -> Self {
        Self { site, emitted: radiance, is_point: false, is_sky: false, cone: None }
    }

    /// Returns the unit direction from a place to this point, and the square of the distance: one
    /// for the sky, whose densities know of no distance. `None` from the very point.
    #[inline]
    pub fn seen_from(&self, from: Vec3) -> Option<(Vec3, f32)> {
        if self.is_sky {
            return Some((self.toward_sky(), 1.0));
        }
        let offset = self.site.position - from;
        Some((offset.try_normalize()?, offset.length_squared()))
    }

    /// Returns the square of the distance from a place: one for the sky, as
    /// [`seen_from`](Self::seen_from) has it.
    #[inline]
    pub fn distance_squared(&self, from: Vec3) -> f32 {
        if self.is_sky { 1.0 } else { (self.site.position - from).length_squared() }
    }

    /// The cosine of the unit `direction` to the front normal, zero behind it; one
    /// for a point light and for the sky. It converts measures; light takes
    /// [`falloff`](Self::falloff).
    #[inline]
    pub fn cosine(&self, direction: Vec3) -> f32 {
        if self.is_point | self.is_sky { 1.0 } else { self.site.normal.dot(direction).max(0.0) }
    }

    /// Returns the factor on [`emitted`](Self::emitted) toward the unit `direction`: the cosine to
    /// the front normal, a spot light's falloff, or one.
    #[inline]
    pub fn falloff(&self, direction: Vec3) -> f32 {
        self.cone.map_or_else(|| self.cosine(direction), |cone| cone.falloff(direction))
    }

    /// Density of [`Light::sample_emission`] choosing `direction` here. Not for the sky, of which
    /// the lamp itself must be asked: see [`Light::direction_pdf`].
    pub fn direction_pdf(&self, direction: Vec3) -> SolidAnglePdf {
        match self.cone {
            Some(cone) => cone.pdf(direction),
            None if self.is_point => SolidAnglePdf(0.25 * FRAC_1_PI),
            None => SolidAnglePdf(warp::cosine_hemisphere_pdf(self.cosine(direction))),
        }
    }

    /// The segment to this point from one on a surface; to the sky it has no end.
    #[inline]
    pub fn segment_from(&self, site: &SurfaceSite) -> Ray {
        if self.is_sky { self.ray_to_sky(site) } else { site.segment_to(&self.site) }
    }

    #[inline(never)]
    fn ray_to_sky(&self, site: &SurfaceSite) -> Ray {
        let toward = self.toward_sky();
        Ray::new(site.ray_origin(toward), toward)
    }

    /// Returns the origin of a ray toward `direction`.
    pub fn ray_origin(&self, direction: Vec3) -> Vec3 {
        self.site.ray_origin(direction)
    }
}

impl Light {
    /// Emitted power in W.
    pub fn power(&self) -> Rgb {
        match self {
            Self::Area { primitive, radiance } => *radiance * (PI * primitive.area()),
            Self::Point(light) => light.intensity * light.solid_angle(),
            Self::Sky(sky) => sky.power(),
        }
    }

    /// The greatest intensity into any direction, as luminance in W/sr; of a lamp
    /// that is a cone up to 2 % less. The sky, which is no nearer to one place than to
    /// another, has none.
    pub(crate) fn intensity(&self) -> f64 {
        match self {
            Self::Area { primitive, radiance } => {
                f64::from(radiance.luminance()) * f64::from(primitive.largest_shadow())
            }
            Self::Point(light) => f64::from(light.intensity.luminance()),
            Self::Sky(_) => 0.0,
        }
    }

    /// Whether points of the lamp can light others of its front.
    pub fn lights_itself(&self) -> bool {
        match self {
            Self::Area { primitive, .. } => primitive.faces_itself(),
            Self::Point(_) | Self::Sky(_) => false,
        }
    }

    /// Whether the lamp is a point, which no ray can hit.
    pub fn is_point(&self) -> bool {
        matches!(self, Self::Point(_))
    }

    /// A point for a light path to start at and a direction for it to take.
    pub fn sample_emission(&self, u_point: Vec2, u_direction: Vec2) -> Emission {
        match self {
            Self::Area { primitive, radiance } => {
                let site = primitive.sample_area(u_point);
                let direction = warp::cosine_hemisphere(site.normal, u_direction);
                Emission { point: LightPoint::on_surface(site, *radiance), direction }
            }
            Self::Point(light) => {
                Emission { point: light.point(), direction: light.sample_direction(u_direction) }
            }
            Self::Sky(sky) => sky.sample_emission(u_point, u_direction),
        }
    }

    /// Density with which [`sample_emission`](Self::sample_emission) starts at this
    /// point of this lamp (F₀ without the choice of the lamp); one for a point light, per
    /// steradian for the sky.
    pub fn emission_pdf(&self, point: &LightPoint) -> AreaPdf {
        match self {
            Self::Area { primitive, .. } => AreaPdf(1.0 / primitive.area()),
            Self::Point(_) => AreaPdf(1.0),
            Self::Sky(sky) => AreaPdf(sky.pdf(point)),
        }
    }

    /// Density with which [`sample_emission`](Self::sample_emission), once it has started at
    /// `point`, chooses `direction`. The sky chooses a place across its only direction instead,
    /// per square metre.
    #[inline]
    pub fn direction_pdf(&self, point: &LightPoint, direction: Vec3) -> SolidAnglePdf {
        match self {
            Self::Area { .. } | Self::Point(_) => point.direction_pdf(direction),
            Self::Sky(sky) => SolidAnglePdf(sky.shadow_pdf(point.toward_sky())),
        }
    }

    /// A point of the lamp to light `from` with, and its density; one for a
    /// point light, per steradian for the sky.
    #[inline]
    pub fn sample_toward(&self, from: Vec3, u: Vec2) -> (LightPoint, AreaPdf) {
        match self {
            Self::Area { primitive, radiance } => {
                let (site, pdf) = primitive.sample_toward(from, u);
                (LightPoint::on_surface(site, *radiance), pdf)
            }
            Self::Point(light) => (light.point(), AreaPdf(1.0)),
            Self::Sky(sky) => sky.sample_toward(u),
        }
    }

    /// The surface coordinates of the point that [`sample_toward`](Self::sample_toward)
    /// makes of `u`: zero on what has none.
    pub(crate) fn coordinates_toward(&self, from: Vec3, u: Vec2) -> Vec2 {
        match self {
            Self::Area { primitive, .. } => primitive.coordinates_toward(from, u),
            Self::Point(_) | Self::Sky(_) => Vec2::ZERO,
        }
    }

    /// Density with which [`sample_toward`](Self::sample_toward) chooses `point`
    /// of this lamp for `from`.
    pub fn toward_pdf(&self, from: Vec3, point: &LightPoint) -> AreaPdf {
        match self {
            Self::Area { primitive, .. } => {
                primitive.pdf_toward(from, point.site.position, point.site.normal)
            }
            Self::Point(_) => AreaPdf(1.0),
            Self::Sky(sky) => AreaPdf(sky.pdf(point)),
        }
    }
}

impl PointLight {
    fn point(&self) -> LightPoint {
        let site = SurfaceSite { position: self.position, error: Vec3::ZERO, normal: Vec3::ZERO };
        LightPoint { site, emitted: self.intensity, is_point: true, is_sky: false, cone: self.cone }
    }

    fn sample_direction(&self, u: Vec2) -> Vec3 {
        self.cone.map_or_else(|| warp::uniform_sphere(u), |cone| cone.sample(u))
    }

    /// Power over intensity, in steradians.
    fn solid_angle(&self) -> f32 {
        self.cone.map_or(4.0 * PI, |cone| cone.solid_angle())
    }
}

/// Refuses light that is negative or not a number.
pub(crate) fn check_emission(what: &'static str, value: Rgb) -> Result<(), Error> {
    let sound = value.is_finite() && value.min_band() >= 0.0;
    if sound { Ok(()) } else { Err(Error::Emission { what, value: value.to_array() }) }
}
