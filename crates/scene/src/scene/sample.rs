//! Points of lamps, with what they lie on.

use super::Scene;
use crate::seat::Seat;
use crate::surfaces::Surface;
use crate::{Emission, LightId, LightPoint};
use traylib_math::{AreaPdf, Vec2, Vec3};

impl Scene {
    /// A point of a lamp to light `from` with, and its density; one for a point
    /// light. It emits what the lamp's opacity leaves of it there.
    #[expect(
        clippy::inline_always,
        reason = "its result is large: in place it is not written to memory"
    )]
    #[inline(always)]
    pub fn sample_light(&self, id: LightId, from: Vec3, u: Vec2) -> (LightPoint, AreaPdf) {
        let (mut point, pdf) = self.light(id).sample_toward(from, u);
        self.seat(id, &mut point, |_| self.light(id).coordinates_toward(from, u));
        (point, pdf)
    }

    /// A point of a lamp for a light path to start at and a direction for it to take.
    /// It emits what the lamp's opacity leaves of it there.
    #[inline]
    pub fn sample_emission(&self, id: LightId, u_point: Vec2, u_direction: Vec2) -> Emission {
        let mut emission = self.light(id).sample_emission(u_point, u_direction);
        self.seat(id, &mut emission.point, |surface| surface.sample_coordinates(u_point));
        emission
    }

    /// Gives a point of a lamp, drawn with these surface coordinates, what the lamp lies on.
    #[inline]
    fn seat(
        &self,
        id: LightId,
        point: &mut LightPoint,
        coordinates: impl FnOnce(Surface<'_>) -> Vec2,
    ) {
        match self.stage.seats.get(id.0 as usize) {
            None | Some(Seat::Plain) => {}
            Some(Seat::Masked(surface)) => {
                let surface = self.surface_of(*surface);
                point.emitted *= self.opacity(surface, coordinates(surface));
            }
            Some(Seat::Within(site)) => point.site = *site,
        }
    }

    /// Returns the part of a surface that is there at these coordinates.
    #[cold]
    fn opacity(&self, surface: Surface<'_>, at: Vec2) -> f32 {
        self.stage.materials[surface.material()].opacity(|| surface.site_of_textures(at))
    }
}
