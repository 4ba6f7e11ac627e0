//! What lamps lie on: their own surface with its opacity, or, of point lights, the
//! surface of something else.

use crate::scene::LightId;
use crate::{Emission, LightPoint, Scene};
use traylib_geometry::{SidedPrimitive, SurfaceSite};
use traylib_math::{AreaPdf, Defect, Vec2, Vec3, planted};

/// What a lamp lies on.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Seat {
    /// The lamp is this surface of the scene.
    Surface(u32),
    /// A point light in free space.
    Free,
    /// A point light that lies in a surface up to rounding. It shines on both sides:
    /// neither hides it.
    Within(SurfaceSite),
}

impl Seat {
    /// The seat of a point light among these shapes.
    pub(crate) fn of_point(position: Vec3, shapes: &[SidedPrimitive]) -> Self {
        if planted(Defect::PointInSurfaceLost) {
            return Self::Free;
        }
        // Most shapes are nowhere near.
        let is_near = |shape: &&SidedPrimitive| {
            let bounds = shape.primitive.bounds();
            let rounding = (position.abs() + bounds.extent()) * (64.0 * f32::EPSILON);
            bounds.grown(rounding).contains(position)
        };
        let touching = |shape: &SidedPrimitive| shape.primitive.touching(position);
        shapes.iter().filter(is_near).find_map(touching).map_or(Self::Free, Self::Within)
    }
}

impl Scene {
    /// A point of a lamp to light `from` with, and its density; one for a point
    /// light. It emits what the lamp's opacity leaves of it there.
    pub fn sample_light(&self, id: LightId, from: Vec3, u: Vec2) -> (LightPoint, AreaPdf) {
        let (point, pdf) = self.light(id).sample_toward(from, u);
        (self.seated(id, point, u), pdf)
    }

    /// A point of a lamp for a light path to start at and a direction for it to take.
    /// It emits what the lamp's opacity leaves of it there.
    pub fn sample_emission(&self, id: LightId, u_point: Vec2, u_direction: Vec2) -> Emission {
        let Emission { point, direction } = self.light(id).sample_emission(u_point, u_direction);
        Emission { point: self.seated(id, point, u_point), direction }
    }

    /// The point that `u` made of a lamp, with what the lamp lies on.
    fn seated(&self, id: LightId, point: LightPoint, u: Vec2) -> LightPoint {
        match self.seats[id.0 as usize] {
            Seat::Surface(surface) => {
                let coverage = self.coverage_of_sample(surface, u);
                LightPoint { emitted: point.emitted * coverage, ..point }
            }
            Seat::Free => point,
            Seat::Within(site) => LightPoint { site, ..point },
        }
    }

    /// How much of a surface is there at the point that
    /// [`Primitive::sample_area`](traylib_geometry::Primitive::sample_area) makes of
    /// `u`. What has texture coordinates is sampled by area in every technique.
    fn coverage_of_sample(&self, index: u32, u: Vec2) -> f32 {
        let surface = &self.surfaces[index as usize];
        let material = &self.materials[surface.material as usize];
        let forgotten = planted(Defect::LampOpacityForgotten);
        if !material.has_opacity() || forgotten {
            return 1.0;
        }
        let at = self.primitive(index).sample_coordinates(u);
        material.coverage(|| self.site_of_textures(index, at))
    }
}
