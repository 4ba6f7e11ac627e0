//! Light from all around.
//!
//! Mitsuba's picture of a sky has its first and its last row on the poles, its columns between
//! multiples of 360° over the width, and is linear between texels. Ours has texels that are the
//! same all over. So ours is made anew from that: with as many texels as the file's, and more if
//! these are few.

use super::Importer;
use super::fields::Fields;
use crate::import::sky_light::SkyLight;
use crate::suggest::shown;
use std::f64::consts::{PI, TAU};
use traylib_math::glam::{DMat3, DVec3};
use traylib_math::{Grid, Rgb};

/// Columns and rows that ours has at least: with less, texels would be seen as steps in a mirror.
const FEWEST: [usize; 2] = [512, 256];
/// The tolerance within which the columns of a place are unit vectors at right angles.
const TOLERANCE: f64 = 1e-5;
/// The turn in degrees from our pictures to Mitsuba's, whose left edge is where −z points.
const TURN: f64 = 180.0;

impl Importer<'_> {
    /// The same light from everywhere.
    pub(super) fn constant(&mut self, fields: &mut Fields<'_>) {
        // What changes nothing about it.
        fields.ignore(&["to_world", "sampling_weight"]);
        let radiance = self.radiance(fields, "radiance");
        self.add_sky(SkyLight::constant(radiance));
    }

    /// A picture of the light from everywhere.
    pub(super) fn environment(&mut self, fields: &mut Fields<'_>) {
        // How Mitsuba samples it.
        fields.ignore(&["sampling_weight", "mis_compensation"]);
        let scale = fields.number("scale").unwrap_or(1.0) as f32;
        let place = fields.place().matrix3;
        let Some(name) = fields.text("filename") else {
            self.pictures.counter.add("emitter `envmap` without a `filename` skipped");
            return;
        };
        if !(scale >= 0.0 && scale.is_finite()) {
            self.pictures.counter.add("emitter `envmap` that takes light away skipped");
            return;
        }
        let Some(location) = self.beside.find(name) else {
            self.pictures.counter.add(format!("sky `{}` not found, skipped", shown(name)));
            return;
        };
        match self.pictures.textures.load_light(&location, scale) {
            Ok(light) => {
                let rotation = self.rotation(place);
                self.add_sky(sky(&light, rotation));
            }
            Err(cause) => self.pictures.counter.add(cause),
        }
    }

    /// A place without its scale, which Mitsuba's own pictures make no sense with.
    fn rotation(&mut self, place: DMat3) -> DMat3 {
        let is_rotation =
            |place: DMat3| (place * place.transpose()).abs_diff_eq(DMat3::IDENTITY, TOLERANCE);
        if is_rotation(place) {
            return place;
        }
        let [x, y, z] = [place.x_axis, place.y_axis, place.z_axis].map(DVec3::normalize_or_zero);
        let unscaled = DMat3::from_cols(x, y, z);
        let (kept, what) = if is_rotation(unscaled) {
            (unscaled, "scale of an `envmap` skipped")
        } else {
            (DMat3::IDENTITY, "skewed `to_world` of an `envmap` skipped")
        };
        self.pictures.counter.add(what);
        kept
    }

    fn add_sky(&mut self, sky: SkyLight) {
        if self.content.sky.is_some() {
            self.pictures.counter.add("second sky skipped");
        } else if sky.radiance.values().iter().all(|light| light.is_finite()) {
            self.content.sky = Some(sky);
        } else {
            self.pictures.counter.add("light beyond single precision skipped");
        }
    }
}

/// Our sky of one of Mitsuba's, in the place that `rotation`, which may mirror, gives it.
fn sky(light: &Grid<Rgb>, rotation: DMat3) -> SkyLight {
    let (turn, rest) = about_up(rotation);
    let [columns, rows] = FEWEST;
    let factor = columns.div_ceil(light.width().max(1)).min(rows.div_ceil(light.height().max(1)));
    let (width, height) = (light.width() * factor, light.height() * factor);
    let back = rest.transpose();
    let mut radiance = Grid::filled(width, height, Rgb::BLACK);
    for (index, texel) in radiance.values_mut().iter_mut().enumerate() {
        let (column, row) = (index % width, index / width);
        let u = (column as f64 + 0.5) / width as f64;
        let v = (row as f64 + 0.5) / height as f64;
        let (u, v) = if rest == DMat3::IDENTITY { (u, v) } else { place(back * direction(u, v)) };
        *texel = at(light, u, v);
    }
    SkyLight { radiance, turn_degrees: (TURN + turn).rem_euclid(360.0) as f32 }
}

/// Degrees about y, counter-clockwise seen from above, and what is done before that turn.
fn about_up(rotation: DMat3) -> (f64, DMat3) {
    let is_turn = rotation.y_axis.abs_diff_eq(DVec3::Y, TOLERANCE) && rotation.determinant() > 0.0;
    if is_turn {
        let angle = f64::atan2(-rotation.x_axis.z, rotation.x_axis.x);
        (angle.to_degrees(), DMat3::IDENTITY)
    } else {
        (0.0, rotation)
    }
}

/// The direction of a place in Mitsuba's picture.
fn direction(u: f64, v: f64) -> DVec3 {
    let ((sin_v, cos_v), (sin_u, cos_u)) = ((PI * v).sin_cos(), (TAU * u).sin_cos());
    DVec3::new(sin_u * sin_v, cos_v, -cos_u * sin_v)
}

/// The place of a direction in Mitsuba's picture.
fn place(direction: DVec3) -> (f64, f64) {
    let DVec3 { x, y, z } = direction;
    (x.atan2(-z) / TAU, x.hypot(z).atan2(y) / PI)
}

/// Mitsuba's radiance at a place of its picture: linear between the four texels around.
fn at(light: &Grid<Rgb>, u: f64, v: f64) -> Rgb {
    let (width, height) = (light.width(), light.height());
    let across = (u * width as f64 - 0.5).rem_euclid(width as f64);
    let down = (v * (height - 1) as f64).clamp(0.0, (height - 1) as f64);
    let (column, row) = ((across as usize).min(width - 1), down as usize);
    let (right, below) = ((column + 1) % width, (row + 1).min(height - 1));
    let (x, y) = ((across - column as f64) as f32, (down - row as f64) as f32);
    let between = |row| *light.get(column, row) * (1.0 - x) + *light.get(right, row) * x;
    between(row) * (1.0 - y) + between(below) * y
}

#[cfg(test)]
mod tests;
