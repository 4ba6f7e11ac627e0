//! What lamps lie on: their own surface with its opacity, or, of point lights, the
//! surface of something else.

use crate::scene::LightId;
use crate::surfaces::Surfaces;
use crate::{Emission, LightPoint, Scene};
use traylib_geometry::{ShapeList, SurfaceSite};
use traylib_math::{AreaPdf, Defect, Vec2, Vec3, planted};

/// What a lamp lies on.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Seat {
    /// Nothing that matters: a surface that is there all over, or free space.
    Plain,
    /// The lamp is this surface of the scene, parts of which may not be there.
    Masked(u32),
    /// A point light that lies in a surface up to rounding. It shines on both sides:
    /// neither hides it.
    Within(SurfaceSite),
}

impl Seat {
    /// The seat of a point light among these surfaces.
    pub(crate) fn of_point(position: Vec3, surfaces: &Surfaces) -> Self {
        if planted(Defect::PointInSurfaceLost) {
            return Self::Plain;
        }
        touching(position, surfaces).next().map_or(Self::Plain, Self::Within)
    }
}

/// The surfaces in which a point lies up to rounding.
pub(crate) fn touching(position: Vec3, surfaces: &Surfaces) -> impl Iterator<Item = SurfaceSite> {
    // Most shapes are nowhere near.
    let is_near = move |&index: &usize| {
        let bounds = surfaces.bounds(index);
        let rounding = (position.abs() + bounds.extent()) * (64.0 * f32::EPSILON);
        bounds.grown(rounding).contains(position)
    };
    let site = move |index: usize| surfaces.get(index as u32).primitive()?.touching(position);
    (0..surfaces.count()).filter(is_near).filter_map(site)
}

impl Scene {
    /// A point of a lamp to light `from` with, and its density; one for a point
    /// light. It emits what the lamp's opacity leaves of it there.
    #[inline]
    pub fn sample_light(&self, id: LightId, from: Vec3, u: Vec2) -> (LightPoint, AreaPdf) {
        let (mut point, pdf) = self.light(id).sample_toward(from, u);
        self.seat(id, &mut point, u);
        (point, pdf)
    }

    /// A point of a lamp for a light path to start at and a direction for it to take.
    /// It emits what the lamp's opacity leaves of it there.
    #[inline]
    pub fn sample_emission(&self, id: LightId, u_point: Vec2, u_direction: Vec2) -> Emission {
        let mut emission = self.light(id).sample_emission(u_point, u_direction);
        self.seat(id, &mut emission.point, u_point);
        emission
    }

    /// Gives the point that `u` made of a lamp what the lamp lies on.
    #[inline]
    fn seat(&self, id: LightId, point: &mut LightPoint, u: Vec2) {
        match self.stage.seats.get(id.0 as usize) {
            None | Some(Seat::Plain) => {}
            Some(Seat::Masked(surface)) => point.emitted *= self.coverage_of_sample(*surface, u),
            Some(Seat::Within(site)) => point.site = *site,
        }
    }

    /// How much of a surface is there at the point that
    /// [`Primitive::sample_area`](traylib_geometry::Primitive::sample_area) makes of
    /// `u`. What has texture coordinates is sampled by area in every technique.
    fn coverage_of_sample(&self, index: u32, u: Vec2) -> f32 {
        if planted(Defect::LampOpacityForgotten) {
            return 1.0;
        }
        let surface = self.stage.tree.shapes().get(index);
        let at = surface.sample_coordinates(u);
        self.stage.materials[surface.material()].opacity(|| surface.site_of_textures(at))
    }
}
