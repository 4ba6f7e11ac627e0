//! Pictures on surfaces.

use super::Importer;
use super::fields::Fields;
use super::paint::Paint;
use crate::import::textures::{Meaning, Usage};
use crate::suggest::shown;
use std::collections::HashMap;
use std::sync::Arc;
use traylib_materials::{Layer, Texture, Tiling};
use traylib_math::glam::{Affine2, Mat2};
use traylib_math::{Grid, Rgb, Vec2};

/// Pixels along a side of a checkerboard of two by two squares.
const CHECKERBOARD: usize = 256;
/// Checkerboards of one file that are made pictures.
const MOST_CHECKERBOARDS: usize = 64;

/// The checkerboards so far, by the bits of their colours.
#[derive(Default)]
pub(super) struct Checkerboards(HashMap<[[u32; 3]; 2], Arc<Texture>>);

impl Importer<'_> {
    /// A texture times a factor; `None`, counted, of one that is not read.
    pub(super) fn texture(&mut self, object: usize, factor: Rgb) -> Option<Paint> {
        let mut fields = Fields::of(self.document, object);
        let paint = match fields.object.kind.as_str() {
            "bitmap" => self.bitmap(&mut fields, factor),
            "checkerboard" => self.checkerboard(&mut fields, factor),
            _ => {
                self.skipped(object);
                return None;
            }
        };
        fields.finish(self.pictures.counter);
        paint
    }

    fn bitmap(&mut self, fields: &mut Fields<'_>, factor: Rgb) -> Option<Paint> {
        // How it is filtered, and what a renderer keeps of it.
        fields.ignore(&["filter_type", "accel", "format", "cache", "max_anisotropy"]);
        let is_raw = fields.flag("raw").unwrap_or(false) || self.is_linear(fields);
        let meaning = if is_raw { Meaning::Amount } else { Meaning::Colour };
        let (placement, tiling) = (self.placement(fields)?, self.tiling(fields));
        let Some(name) = fields.text("filename") else {
            self.pictures.counter.add("picture without a `filename` skipped");
            return None;
        };
        let usage = Usage { meaning, negative: false, factor };
        let texture = self.pictures.load(&shown(name), self.beside.find(name), usage)?;
        let colour = texture.mean();
        Some(Paint { colour, layer: Some(Layer { placement, tiling, ..Layer::new(texture) }) })
    }

    /// Tells whether older files say that the numbers of a picture are light.
    fn is_linear(&mut self, fields: &mut Fields<'_>) -> bool {
        let gamma = fields.number("gamma").filter(|&gamma| gamma > 0.0);
        if gamma.is_some_and(|gamma| gamma != 1.0) {
            self.pictures.counter.add("`gamma` of a picture skipped: the curve for sRGB taken");
        }
        gamma == Some(1.0)
    }

    /// From the texture coordinates of a surface to those of a picture, which go up from its
    /// bottom; `None`, counted, if it has no extent.
    fn placement(&mut self, fields: &mut Fields<'_>) -> Option<Affine2> {
        let mut own = |name, usual| fields.number(name).unwrap_or(usual) as f32;
        let [scale, offset] =
            [[("uscale", 1.0), ("vscale", 1.0)], [("uoffset", 0.0), ("voffset", 0.0)]]
                .map(|axes| Vec2::from(axes.map(|(name, usual)| own(name, usual))));
        let old = Affine2::from_scale_angle_translation(scale, 0.0, offset);
        let given = fields.transform("to_uv").map(|place| {
            let [x, y, t] = [place.matrix3.x_axis, place.matrix3.y_axis, place.translation]
                .map(|v| v.truncate().as_vec2());
            Affine2 { matrix2: Mat2::from_cols(x, y), translation: t }
        });
        let upward = Affine2::from_scale_angle_translation(Vec2::new(1.0, -1.0), 0.0, Vec2::Y);
        let placement = upward * given.unwrap_or(old);
        let is_usable = placement.is_finite() && placement.matrix2.determinant() != 0.0;
        self.pictures.counter.add_many("picture of no extent skipped", u32::from(!is_usable));
        is_usable.then_some(placement)
    }

    fn tiling(&mut self, fields: &mut Fields<'_>) -> Tiling {
        match fields.text("wrap_mode") {
            None | Some("repeat") => Tiling::Repeat,
            Some("mirror") => Tiling::Mirror,
            Some(_) => {
                self.pictures.counter.add("picture whose edge goes on: repeated");
                Tiling::Repeat
            }
        }
    }

    /// Two by two squares: of `color0` those where both coordinates are in the same half.
    fn checkerboard(&mut self, fields: &mut Fields<'_>, factor: Rgb) -> Option<Paint> {
        let colours = [("color0", 0.4), ("color1", 0.2)];
        let colours = colours.map(|(name, usual)| self.even_paint(fields, name, usual) * factor);
        let placement = self.placement(fields)?;
        let colour = (colours[0] + colours[1]) * 0.5;
        let key = colours.map(|colour| colour.to_array().map(f32::to_bits));
        let known = &mut self.checkerboards.0;
        if known.len() >= MOST_CHECKERBOARDS && !known.contains_key(&key) {
            self.pictures.counter.add("one checkerboard too many: its mean taken");
            return Some(Paint { colour, layer: None });
        }
        let texture = match known.get(&key) {
            Some(texture) => Arc::clone(texture),
            None => squares(colours)?,
        };
        known.insert(key, Arc::clone(&texture));
        Some(Paint { colour, layer: Some(Layer { placement, ..Layer::new(texture) }) })
    }
}

fn squares(colours: [Rgb; 2]) -> Option<Arc<Texture>> {
    let half = CHECKERBOARD / 2;
    let mut pixels = Grid::filled(CHECKERBOARD, CHECKERBOARD, colours[0]);
    for (index, pixel) in pixels.values_mut().iter_mut().enumerate() {
        let (column, row) = (index % CHECKERBOARD, index / CHECKERBOARD);
        if (column < half) != (row < half) {
            *pixel = colours[1];
        }
    }
    Texture::new(pixels).map(Arc::new)
}
