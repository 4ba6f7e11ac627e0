//! Materials, and the images that they are made with.

use super::accessor::{Arrays, item};
use super::buffers::{data, unescaped};
use super::json::{self, Root};
use super::{Cause, Error, Image, Material, Picture, WarningKind, Wrap};
use crate::warning_counts::WarningCounts;
use traylib_math::glam::Affine2;
use traylib_math::{Rgb, Vec2};

/// Reads the materials of a file.
pub(super) fn all(
    root: &Root,
    warnings: &mut WarningCounts<WarningKind>,
) -> Result<Vec<Material>, Error> {
    let material = |(index, material): (usize, &json::Material)| {
        let failed = |cause| Error::at(format!("materials[{index}]"), cause);
        one(root, material, warnings).map_err(failed)
    };
    root.materials.iter().enumerate().map(material).collect()
}

fn one(
    root: &Root,
    material: &json::Material,
    warnings: &mut WarningCounts<WarningKind>,
) -> Result<Material, Cause> {
    let pbr = &material.pbr_metallic_roughness;
    let strength = material.extensions.emissive_strength.emissive_strength;
    let emission = Rgb::from(material.emissive_factor) * strength;
    let mut unit = |value: f32| {
        if !(0.0..=1.0).contains(&value) {
            warnings.add(WarningKind::OutsideUnit);
        }
        // Of what is no number, 0.
        if value > 0.0 { value.min(1.0) } else { 0.0 }
    };
    let [r, g, b, alpha] = pbr.base_color_factor.map(&mut unit);
    let (metallic, roughness) = (unit(pbr.metallic_factor), unit(pbr.roughness_factor));
    if !(emission.is_finite() && emission.min_band() >= 0.0) {
        return Err(Cause::Kind("emission that is finite and not negative"));
    }
    let picture = |info: &Option<json::TextureInfo>| {
        info.as_ref().map(|info| picture(root, info)).transpose()
    };
    Ok(Material {
        name: material.name.clone(),
        base_colour: Rgb::new(r, g, b),
        alpha,
        metallic,
        roughness,
        emission,
        is_unlit: material.extensions.unlit.is_some(),
        alpha_mode: material.alpha_mode,
        alpha_cutoff: material.alpha_cutoff,
        double_sided: material.double_sided,
        base_colour_picture: picture(&pbr.base_color_texture)?,
        metallic_roughness_picture: picture(&pbr.picture)?,
        has_normal_occlusion_emission: [
            material.normal_texture.is_some(),
            material.occlusion_texture.is_some(),
            material.emissive_texture.is_some(),
        ],
    })
}

fn picture(root: &Root, info: &json::TextureInfo) -> Result<Picture, Cause> {
    let texture = item(&root.textures, info.index, "texture")?;
    let image =
        texture.source.map(|source| item(&root.images, source, "image").map(|_| source as usize));
    let wrap = match texture.sampler {
        None => [Wrap::Repeat; 2],
        Some(sampler) => {
            let sampler = item(&root.samplers, sampler, "sampler")?;
            [sampler.wrap_s, sampler.wrap_t].map(Wrap::of)
        }
    };
    let (mut set, mut transform) = (info.tex_coord, Affine2::IDENTITY);
    if let Some(given) = &info.extensions.transform {
        set = given.tex_coord.unwrap_or(set);
        // v goes down, so that what is counter-clockwise is so the other way.
        let (scale, offset) = (Vec2::from(given.scale), Vec2::from(given.offset));
        transform = Affine2::from_scale_angle_translation(scale, -given.rotation, offset);
    }
    if !transform.is_finite() {
        return Err(Cause::NotFinite);
    }
    Ok(Picture { image: image.transpose()?, set, transform, wrap })
}

/// Reads the images that pictures of materials are made of; others are left out.
pub(super) fn images(
    root: &Root,
    arrays: &Arrays<'_>,
    materials: &[Material],
) -> Result<Vec<Image>, Error> {
    let mut is_used = vec![false; root.images.len()];
    for material in materials {
        for picture in [material.base_colour_picture, material.metallic_roughness_picture] {
            if let Some(image) = picture.and_then(|picture| picture.image) {
                is_used[image] = true;
            }
        }
    }
    let image = |(image, is_used): (&json::Image, bool)| match (&image.uri, image.buffer_view) {
        _ if !is_used => Ok(Image::Missing("it is not used".to_string())),
        (Some(uri), _) => Ok(match data(uri) {
            Some(Ok(bytes)) => Image::Bytes(bytes),
            Some(Err(why)) => Image::Missing(why),
            None => Image::File(unescaped(uri)),
        }),
        (None, Some(view)) => arrays.view(view).map(|bytes| Image::Bytes(bytes.to_vec())),
        (None, None) => Ok(Image::Missing("it has no `uri` and no `bufferView`".to_string())),
    };
    root.images.iter().zip(is_used).map(image).collect()
}
