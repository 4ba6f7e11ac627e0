//! A diffuse colour and a highlight, with maps over them, as one of our materials.

use super::pictures::Pictures;
use std::sync::Arc;
use traylib_materials::{Error, Lambert, Layer, Maps, Material, Phong, SurfaceModel, Texture};
use traylib_math::{Grid, Rgb};

/// The sharpest lobe there is.
pub(super) const SHARPEST: f32 = 1e6;

/// The appearance of a surface, which the formats describe each in its own words.
pub(super) struct Appearance {
    pub(super) diffuse: Rgb,
    pub(super) specular: Rgb,
    /// The exponent of the specular lobe about the mirror direction.
    pub(super) exponent: f32,
    /// The opacity, from 0 to 1; light passes the rest straight.
    pub(super) share: f32,
    /// The maps that are rendered.
    pub(super) maps: Maps,
}

impl Appearance {
    /// Makes it a material: Phong with kd, ks and n, or Lambert where there is no highlight.
    /// Where kd + ks exceeds one, both are divided by the largest band of the sum.
    ///
    /// # Errors
    /// A number makes no material.
    pub(super) fn material(self, pictures: &mut Pictures<'_>) -> Result<Material, Error> {
        // A picture of opacity says the same where there are others.
        let clear = if self.maps == Maps::default() { 1.0 - self.share } else { 0.0 };
        let sum = (self.diffuse + self.specular).max_band();
        if sum > 1.0 {
            pictures.counter.add("material reflecting more than arrives, scaled down");
        }
        let model = self.model(sum.max(1.0), 1.0 - clear)?;
        Ok(Material { model, through: Rgb::splat(clear), maps: self.maps(pictures) })
    }

    /// The model of which this share is there, after a division of its colours.
    fn model(&self, divisor: f32, share: f32) -> Result<SurfaceModel, Error> {
        let scaled = |part: Rgb| part / divisor * share;
        let (diffuse, specular) = (scaled(self.diffuse), scaled(self.specular));
        Ok(if specular.is_black() {
            SurfaceModel::Lambert(Lambert::new(diffuse)?)
        } else {
            SurfaceModel::Phong(Phong::new(diffuse, specular, self.exponent)?)
        })
    }

    /// Its maps, if it has any.
    fn maps(self, pictures: &Pictures<'_>) -> Option<Box<Maps>> {
        let Self { mut maps, share, .. } = self;
        if maps == Maps::default() {
            return None;
        }
        // Textures replace colours, so that what is behind cannot be taken off them.
        if maps.opacity.is_none() && share < 1.0 {
            maps.opacity = even(share);
        }
        maps.opacity = maps.opacity.and_then(|layer| pictures.textures.opacity(layer));
        Some(Box::new(maps))
    }
}

/// A layer that is the same everywhere.
pub(super) fn even(value: f32) -> Option<Layer> {
    let texture = Texture::new(Grid::filled(1, 1, Rgb::splat(value)))?;
    Some(Layer::new(Arc::new(texture)))
}
