//! Colours and numbers over a surface: one everywhere, or a picture.

use super::Importer;
use super::fields::Fields;
use crate::mitsuba::{Class, Value};
use crate::suggest::shown;
use traylib_materials::Layer;
use traylib_math::Rgb;

/// A colour, and the picture that goes before it where there is one.
pub(super) struct Paint {
    pub(super) colour: Rgb,
    pub(super) layer: Option<Layer>,
}

/// White of equal energy at all wavelengths, in our primaries: what Mitsuba 3.9.1 makes of a
/// spectrum that is 1 everywhere, where it is light.
const EQUAL_ENERGY: Rgb = Rgb::new(1.204_79, 0.948_291, 0.908_916);

/// Wavelengths, in nm, over which spectra are averaged.
const VISIBLE: [f64; 2] = [400.0, 700.0];

impl Importer<'_> {
    /// The property `name` of an object, which reflects, times a factor.
    pub(super) fn paint(
        &mut self,
        fields: &mut Fields<'_>,
        name: &str,
        usual: f32,
        factor: Rgb,
    ) -> Paint {
        let usual = Rgb::splat(usual);
        if let Some(texture) = fields.child(name) {
            let paint = self.texture(texture, factor);
            return paint.unwrap_or(Paint { colour: usual * factor, layer: None });
        }
        let given = fields.value(name).and_then(|value| self.reflected(value));
        let colour = given.unwrap_or(usual);
        if colour != colour.saturated() {
            self.pictures.counter.add("colour of a material not from 0 to 1, brought there");
        }
        Paint { colour: colour.saturated() * factor, layer: None }
    }

    /// [`paint`](Self::paint) where no picture can show: its mean counts.
    pub(super) fn even_paint(&mut self, fields: &mut Fields<'_>, name: &str, usual: f32) -> Rgb {
        let Paint { colour, layer } = self.paint(fields, name, usual, Rgb::WHITE);
        if layer.is_some() {
            let kind = shown(&fields.object.kind);
            self.pictures.counter.add(format!("picture for `{name}` of `{kind}`: its mean taken"));
        }
        colour
    }

    /// [`even_paint`](Self::even_paint) of what is a number.
    pub(super) fn share(&mut self, fields: &mut Fields<'_>, name: &str, usual: f32) -> f32 {
        self.even_paint(fields, name, usual).luminance()
    }

    /// Returns the reflectance that a value means; `None` if that cannot be told.
    pub(super) fn reflected(&mut self, value: &Value) -> Option<Rgb> {
        self.colour(value, Rgb::WHITE)
    }

    /// The light of the property `name`, 1 if it is not there.
    pub(super) fn radiance(&mut self, fields: &mut Fields<'_>, name: &str) -> Rgb {
        let white = if fields.object.is_old { Rgb::WHITE } else { EQUAL_ENERGY };
        if let Some(texture) = fields.child(name) {
            self.pictures.counter.add("picture of what a surface emits: its mean taken");
            let paint = self.texture(texture, Rgb::WHITE);
            return paint.map_or(Rgb::BLACK, |paint| paint.colour);
        }
        let Some(value) = fields.value(name) else { return white };
        let light = self.colour(value, white).unwrap_or(Rgb::BLACK);
        if light.min_band() < 0.0 {
            self.pictures.counter.add("emission that takes light away skipped");
        }
        Rgb::from(light.to_array().map(|band| band.max(0.0)))
    }

    /// The colour of a value, of which a spectrum that is even is as white as `white`.
    fn colour(&mut self, value: &Value, white: Rgb) -> Option<Rgb> {
        match value {
            Value::Number(number) => Some(Rgb::splat(*number as f32)),
            Value::Colour(colour) => Some(bands(*colour)),
            Value::Even(number) => Some(white * *number as f32),
            Value::Spectrum(samples) => {
                self.pictures
                    .counter
                    .add("spectrum by wavelengths: its mean taken for all colours");
                Some(Rgb::splat(mean(samples) as f32))
            }
            Value::OtherSpectrum => {
                self.pictures.counter.add("spectrum of a black body or in a file skipped");
                None
            }
            Value::Boolean(_) | Value::Text(_) | Value::Vector(_) | Value::Transform(_) => {
                self.pictures.counter.add("value that is no colour skipped");
                None
            }
        }
    }

    /// Counts pictures for which there is no place.
    pub(super) fn note_pictures(&mut self, fields: &mut Fields<'_>, what: &str) {
        let textures = fields.children(Class::Texture).len();
        self.pictures.counter.add_many(what, textures as u32);
    }
}

pub(super) fn bands(bands: [f64; 3]) -> Rgb {
    Rgb::from(bands.map(|band| band as f32))
}

/// The mean over visible light of what is linear between samples and 0 beyond.
fn mean(samples: &[[f64; 2]]) -> f64 {
    let at = |wavelength: f64| {
        let next = samples.partition_point(|sample| sample[0] < wavelength);
        match (next.checked_sub(1).and_then(|last| samples.get(last)), samples.get(next)) {
            (Some(&[x0, y0]), Some(&[x1, y1])) => y0 + (y1 - y0) * (wavelength - x0) / (x1 - x0),
            (None, Some(&[x1, y1])) if x1 == wavelength => y1,
            (_, None) | (None, Some(_)) => 0.0,
        }
    };
    let [first, last] = VISIBLE;
    let steps = (last - first) as u32;
    let value = |step: u32| at(first + f64::from(step) + 0.5);
    (0..steps).map(value).sum::<f64>() / f64::from(steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spectra_are_averaged_over_visible_light() {
        assert!((mean(&[[400.0, 0.0], [700.0, 1.0]]) - 0.5).abs() < 1e-12);
        assert!((mean(&[[300.0, 2.0], [800.0, 2.0]]) - 2.0).abs() < 1e-12);
        assert!((mean(&[[550.0, 1.0], [900.0, 1.0]]) - 0.5).abs() < 1e-12);
        assert_eq!((mean(&[]), mean(&[[500.0, 1.0]])), (0.0, 0.0));
    }
}
