//! From metal and roughness to models.
//!
//! With base colour c, metal m and roughness r, after Khronos' own mix of a metal and a
//! dielectric of index 1.5, whose reflectance at normal incidence is 0.04:
//!
//! | part | is |
//! |---|---|
//! | kd | c·(1 − m)·0.96 |
//! | ks | 0.04·(1 − m) + c·m |
//! | n | 1/(2r⁴), at least 1: the facets' slope is α = r², and a lobe about the mirror direction is as wide as n = 1/(2α²) |
//! | emission | as radiance, times its strength |
//! | alpha | opacity if blended; 0 or 1 if masked |
//!
//! The reflectance at normal incidence is that of Khronos' model. Its growth toward grazing angles,
//! by Fresnel, is left out, and Phong's lobe falls off with the cosine: a dielectric at 80°
//! reflects 0.39 there and 0.01 here.

use crate::gltf::{AlphaMode, Image, Material, Picture, Wrap};
use crate::import::imported_material::ImportedMaterial;
use crate::import::model::appearance::{Appearance, SHARPEST};
use crate::import::model::beside::Beside;
use crate::import::model::pictures::Pictures;
use crate::import::model::plain;
use crate::import::textures::{Meaning, PictureSource, Usage};
use std::sync::Arc;
use traylib_geometry::Sides;
use traylib_materials::{self as materials, Layer, Maps, Texture, Tiling};
use traylib_math::glam::Affine2;
use traylib_math::{Rgb, Vec2};

/// The reflectance of a dielectric of index 1.5 at normal incidence.
const DIELECTRIC: f32 = 0.04;

/// Turns materials of a document into ours.
pub(super) struct MaterialImporter<'a> {
    /// Its name.
    pub(super) file: &'a str,
    pub(super) images: &'a [Image],
    pub(super) beside: &'a Beside,
    pub(super) pictures: Pictures<'a>,
}

impl MaterialImporter<'_> {
    /// Makes the materials of a document, and last that of what has none.
    ///
    /// # Errors
    /// A number makes no material.
    pub(super) fn all(
        &mut self,
        materials: &[Material],
    ) -> Result<Vec<ImportedMaterial>, materials::Error> {
        let plain = plain::material("");
        let plain = plain.map(|plain| ImportedMaterial { sides: Sides::Front, ..plain });
        let materials = materials.iter().map(|material| self.imported(material));
        materials.chain([plain]).collect()
    }

    fn imported(&mut self, material: &Material) -> Result<ImportedMaterial, materials::Error> {
        self.note_skipped(material);
        let [roughness, metallic] = self.roughness_and_metal(material);
        let colour = material.base_colour;
        let diffuse = colour * ((1.0 - metallic) * (1.0 - DIELECTRIC));
        let maps = self.maps(material, diffuse, metallic);
        // The part of a metal comes with the picture, over that of a dielectric.
        let specular = if maps.specular.is_some() {
            Rgb::splat(DIELECTRIC)
        } else {
            Rgb::splat(DIELECTRIC * (1.0 - metallic)) + colour * metallic
        };
        let (exponent, share) = (exponent(roughness), share(material));
        let appearance = Appearance { diffuse, specular, exponent, share, maps };
        let surface = appearance.material(&mut self.pictures)?;
        let emission =
            if material.has_normal_occlusion_emission[2] { Rgb::BLACK } else { material.emission };
        let sides = if material.double_sided { Sides::Both } else { Sides::Front };
        Ok(ImportedMaterial { name: material.name.clone(), surface, sides, emission })
    }

    /// Loads what the picture of colour and alpha is for: the diffuse part, that of a metal, and
    /// opacity.
    fn maps(&mut self, material: &Material, diffuse: Rgb, metallic: f32) -> Maps {
        let mut maps = Maps::default();
        let picture = material.base_colour_picture.as_ref();
        let Some(picture) = picture.filter(|picture| self.is_usable(picture)) else { return maps };
        let usage = |meaning, factor| Usage { meaning, negative: false, factor };
        maps.diffuse = self.layer(picture, usage(Meaning::Colour, diffuse));
        if metallic > 0.0 && maps.diffuse.is_some() {
            // Over what a dielectric has: 0.04·(1 − m) + m·c.
            maps.specular = self
                .layer(picture, usage(Meaning::Colour, material.base_colour))
                .map(|layer| Layer { strength: metallic, ..layer });
        }
        let opacity = match material.alpha_mode {
            AlphaMode::Opaque => None,
            AlphaMode::Blend => Some(Meaning::Alpha),
            AlphaMode::Mask => Some(Meaning::Mask(material.alpha_cutoff.to_bits())),
        };
        let alpha = Rgb::splat(material.alpha);
        maps.opacity = opacity.and_then(|meaning| self.layer(picture, usage(meaning, alpha)));
        maps
    }

    fn note_skipped(&mut self, material: &Material) {
        let [normal, occlusion, emission] = material.has_normal_occlusion_emission;
        for (is_there, what) in [
            (normal, "picture of normals skipped"),
            (occlusion, "picture of occlusion skipped: light is computed"),
            (
                emission && !material.emission.is_black(),
                "picture of what a surface emits skipped, and what it emits",
            ),
            (material.is_unlit, "surface of the same light from everywhere shown as diffuse"),
        ] {
            self.pictures.counter.add_many(what, u32::from(is_there));
        }
    }

    /// Returns both; where pictures say them, their mean.
    fn roughness_and_metal(&mut self, material: &Material) -> [f32; 2] {
        if material.is_unlit {
            return [1.0, 0.0];
        }
        let factors = [material.roughness, material.metallic];
        let Some(picture) = &material.metallic_roughness_picture else { return factors };
        let texture = self.texture(picture, Usage::plain(Meaning::Amount));
        let Some(texture) = texture else { return factors };
        let mean = texture.mean();
        self.pictures
            .counter
            .add("picture of metal and roughness: its mean taken for all of the surface");
        [factors[0] * mean.g.clamp(0.0, 1.0), factors[1] * mean.b.clamp(0.0, 1.0)]
    }

    fn is_usable(&mut self, picture: &Picture) -> bool {
        let scale = picture.transform.matrix2;
        let has_extent = scale.determinant() != 0.0;
        self.pictures.counter.add_many("picture of no extent skipped", u32::from(!has_extent));
        has_extent
    }

    fn layer(&mut self, picture: &Picture, usage: Usage) -> Option<Layer> {
        let texture = self.texture(picture, usage)?;
        let [along_u, along_v] = picture.wrap;
        if along_u != along_v || along_u == Wrap::Clamp {
            self.pictures
                .counter
                .add("picture whose edge goes on, or does so one way alone: repeated");
        }
        let tiling = match along_u {
            Wrap::Mirror if along_v == Wrap::Mirror => Tiling::Mirror,
            Wrap::Mirror | Wrap::Clamp | Wrap::Repeat => Tiling::Repeat,
        };
        // v goes down there, and up here.
        let turned = Affine2::from_scale_angle_translation(Vec2::new(1.0, -1.0), 0.0, Vec2::Y);
        let placement = turned * picture.transform * turned;
        Some(Layer { placement, tiling, ..Layer::new(texture) })
    }

    fn texture(&mut self, picture: &Picture, usage: Usage) -> Option<Arc<Texture>> {
        let Some(index) = picture.image else {
            self.pictures.counter.add("picture in a format that an extension brings skipped");
            return None;
        };
        let loaded = match &self.images[index] {
            Image::File(name) => return self.pictures.load(name, self.beside.find(name), usage),
            Image::Bytes(bytes) => {
                let name = format!("{}: image {index}", self.file);
                self.pictures.textures.load_from(&PictureSource::Bytes { name, bytes }, usage)
            }
            Image::Missing(why) => Err(format!("picture {index} cannot be read: {why}")),
        };
        self.pictures.counted(loaded)
    }
}

/// The exponent of a lobe about the mirror direction.
fn exponent(roughness: f32) -> f32 {
    let slope = roughness * roughness;
    (0.5 / (slope * slope)).clamp(1.0, SHARPEST)
}

/// Returns the opacity of a surface where no picture gives it.
fn share(material: &Material) -> f32 {
    match material.alpha_mode {
        AlphaMode::Opaque => 1.0,
        AlphaMode::Blend => material.alpha,
        AlphaMode::Mask if material.alpha >= material.alpha_cutoff => 1.0,
        AlphaMode::Mask => 0.0,
    }
}
