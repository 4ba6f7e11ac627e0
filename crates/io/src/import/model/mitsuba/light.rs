//! Lights that are not shapes.

use super::Importer;
use super::fields::Fields;
use traylib_math::glam::DVec3;
use traylib_scene::{PointLight, SpotCone};

/// The cutoff angle of a spot light that gives none, in degrees.
const CUTOFF: f64 = 20.0;

impl Importer<'_> {
    pub(super) fn light(&mut self, object: usize) {
        let mut fields = Fields::of(self.document, object);
        match fields.object.kind.as_str() {
            "point" => self.point(&mut fields),
            "spot" => self.spot(&mut fields),
            "constant" => self.constant(&mut fields),
            "envmap" => self.environment(&mut fields),
            _ => {
                self.skipped(object);
                return;
            }
        }
        fields.finish(self.pictures.counter);
    }

    fn point(&mut self, fields: &mut Fields<'_>) {
        let place = fields.place();
        let position = fields.vector("position").map_or(place.translation, DVec3::from);
        let intensity = self.radiance(fields, "intensity");
        self.add_light(PointLight { position: position.as_vec3(), intensity, cone: None });
    }

    /// Mitsuba's light falls off with the angle, ours by a smooth step of it, between the same two.
    fn spot(&mut self, fields: &mut Fields<'_>) {
        let place = fields.place();
        let intensity = self.radiance(fields, "intensity");
        let dark = fields.number("cutoff_angle").unwrap_or(CUTOFF);
        let full = fields.number("beam_width").unwrap_or(0.75 * dark);
        if full < dark {
            self.pictures.counter.add("spot light: its edge is a smooth step of the angle here");
        }
        self.note_pictures(fields, "picture in a spot light skipped");
        let axis = place.transform_vector3(DVec3::Z).as_vec3();
        let [full, dark] = [full, dark].map(|angle| angle.to_radians().cos() as f32);
        match SpotCone::new(axis, full, dark) {
            Ok(cone) => {
                let position = place.translation.as_vec3();
                self.add_light(PointLight { position, intensity, cone: Some(cone) });
            }
            Err(_) => self.pictures.counter.add("spot light that shines nowhere skipped"),
        }
    }

    fn add_light(&mut self, light: PointLight) {
        if light.position.is_finite() && light.intensity.is_finite() {
            self.content.lights.push(light);
        } else {
            self.pictures.counter.add("light beyond single precision skipped");
        }
    }
}
