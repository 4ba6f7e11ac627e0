//! The camera.

use super::Importer;
use super::fields::Fields;
use crate::MAX_PIXELS;
use crate::import::model_camera::{Fov, ModelCamera};
use crate::mitsuba::Class;
use traylib_math::glam::{DAffine3, DVec3};

/// Width and height of a film that does not say it.
const FILM: (u32, u32) = (768, 576);
/// The lens that is taken where no angle is given: its length in mm over the diagonal of 35 mm
/// film, half of it.
const LENS: f64 = 50.0;
const HALF_DIAGONAL: f64 = 21.633_307_652_783_937;

impl Importer<'_> {
    pub(super) fn sensor(&mut self, object: usize) {
        if self.content.camera.is_some() {
            self.pictures.counter.add("camera beside the first skipped");
            return;
        }
        let mut fields = Fields::of(self.document, object);
        match fields.object.kind.as_str() {
            "perspective" => {}
            "thinlens" => {
                fields.ignore(&["aperture_radius", "focus_distance"]);
                self.pictures.counter.add("camera with a lens taken for a pinhole");
            }
            _ => return self.skipped(object),
        }
        fields.ignore(&["near_clip", "far_clip", "shutter_open", "shutter_close"]);
        self.note_shift(&mut fields);
        let film = fields.children(Class::Film).first().map_or(FILM, |&film| self.film(film));
        let samples = fields.children(Class::Sampler).first().copied();
        self.content.samples = samples.and_then(|sampler| self.samples(sampler));
        let place = fields.place();
        let fov = fov(&mut fields, film);
        self.content.camera = self.camera(&place, fov, film);
        fields.finish(self.pictures.counter);
    }

    fn note_shift(&mut self, fields: &mut Fields<'_>) {
        for name in ["principal_point_offset_x", "principal_point_offset_y"] {
            if fields.number(name).is_some_and(|offset| offset != 0.0) {
                self.pictures
                    .counter
                    .add("shift of the picture (`principal_point_offset`) skipped");
            }
        }
    }

    fn camera(&mut self, place: &DAffine3, fov: Fov, film: (u32, u32)) -> Option<ModelCamera> {
        let [up, forward] = [DVec3::Y, DVec3::Z].map(|axis| place.transform_vector3(axis));
        let forward = forward.try_normalize();
        let (Some(forward), Some(up)) = (forward, up.try_normalize()) else {
            self.pictures.counter.add("camera that looks nowhere skipped");
            return None;
        };
        if place.matrix3.determinant() < 0.0 {
            self.pictures.counter.add("camera that mirrors its picture: shown as it is");
        }
        let position = place.translation;
        // As far as it is from the origin: nearer points would lose the direction in rounding.
        let far = position.abs().max_element();
        let target = position + forward * if far > 0.0 { far } else { 1.0 };
        let [position, target, up] = [position, target, up].map(narrow);
        let (resolution, aspect) = (Some(film), None);
        Some(ModelCamera { position, target, up, fov, aspect, resolution })
    }

    /// The width and height of a film.
    fn film(&mut self, object: usize) -> (u32, u32) {
        let mut fields = Fields::of(self.document, object);
        let mut side =
            |name, usual: u32| fields.number(name).map_or(usual, |side| side as u32).max(1);
        let (width, height) = (side("width", FILM.0), side("height", FILM.1));
        if fields.object.properties.iter().any(|property| property.name.starts_with("crop_")) {
            self.pictures
                .counter
                .add("part of the picture (`crop_…`) skipped: all of it is rendered");
        }
        if u64::from(width) * u64::from(height) > MAX_PIXELS {
            self.pictures.counter.add("film of more than 2^28 pixels: its size skipped");
            return FILM;
        }
        (width, height)
    }

    fn samples(&self, object: usize) -> Option<u32> {
        let count = Fields::of(self.document, object).number("sample_count")?;
        (1.0..=f64::from(u32::MAX)).contains(&count).then_some(count as u32)
    }
}

/// The angle of view, by `fov` along `fov_axis`, or by a lens in front of 35 mm film.
fn fov(fields: &mut Fields<'_>, (width, height): (u32, u32)) -> Fov {
    let aspect = f64::from(width) / f64::from(height);
    let lens = fields
        .text("focal_length")
        .and_then(|text| text.trim_end_matches("mm").trim().parse().ok());
    let axis = fields.text("fov_axis").unwrap_or("x");
    let Some(degrees) = fields.number("fov") else {
        let lens = lens.filter(|lens: &f64| *lens > 0.0).unwrap_or(LENS);
        return diagonal(HALF_DIAGONAL / lens, aspect);
    };
    match axis {
        "y" => Fov::Vertical(degrees as f32),
        "smaller" if width > height => Fov::Vertical(degrees as f32),
        "larger" if width < height => Fov::Vertical(degrees as f32),
        "diagonal" => diagonal((0.5 * degrees).to_radians().tan(), aspect),
        _ => Fov::Horizontal(degrees as f32),
    }
}

/// From the tangent of half the angle between two opposite corners.
fn diagonal(tangent: f64, aspect: f64) -> Fov {
    let along_x = tangent * aspect / aspect.hypot(1.0);
    Fov::Horizontal((2.0 * along_x.atan()).to_degrees() as f32)
}

fn narrow(v: DVec3) -> traylib_math::Vec3 {
    v.as_vec3()
}
