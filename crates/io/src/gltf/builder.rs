//! From JSON and buffers to a document.

use super::accessor::{Arrays, item};
use super::budget::Budget;
use super::json::{self, Root};
use super::nodes::{self, Placed};
use super::primitive::Reader;
use super::{
    Camera, Cause, Document, Error, Image, Instance, Light, Limits, Material, Picture, WarningKind,
    Wrap,
};
use crate::Limit;
use crate::tally::Tally;
use base64::Engine;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};
use std::borrow::Cow;
use std::ops::Range;
use traylib_math::glam::{Affine2, DVec3};
use traylib_math::{Rgb, Vec2, Vec3};

/// Extensions that are read.
const READ: [&str; 5] = [
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_unlit",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
];

/// What begins the names of extensions without which a file can be shown all the same.
const OF_SURFACES: [&str; 5] =
    ["KHR_materials_", "KHR_technique", "KHR_texture_", "EXT_texture_", "MSFT_texture_"];

type Load<'a> = &'a mut dyn FnMut(&str) -> Result<Vec<u8>, String>;

pub(super) fn build(
    root: &Root,
    binary: Option<&[u8]>,
    limits: Limits,
    load: Load<'_>,
) -> Result<Document, Error> {
    let mut warnings = Tally::default();
    check_extensions(root, &mut warnings)?;
    check_items(root, limits)?;
    let arrays = Arrays::new(root, buffers(root, binary, limits, load)?);
    warnings.add_many(WarningKind::Animation, root.animations.len());
    let materials = materials(root, &mut warnings)?;
    let placed = nodes::placed(root, &mut warnings)?;
    let document =
        Document { images: images(root, &arrays, &materials)?, materials, ..Document::default() };
    let mut builder = Builder {
        root,
        document,
        warnings,
        meshes: vec![None; root.meshes.len()],
        vertices: Budget::new("vertices", limits.triangles),
        triangles: Budget::new("triangles", limits.triangles),
    };
    for node in &placed {
        builder.add(node, &arrays)?;
    }
    Ok(Document { warnings: builder.warnings, ..builder.document })
}

fn check_extensions(root: &Root, warnings: &mut Tally<WarningKind>) -> Result<(), Error> {
    let is_known = |name: &str| READ.contains(&name);
    let is_of_surfaces = |name: &str| OF_SURFACES.iter().any(|prefix| name.starts_with(prefix));
    let needed = |name: &&String| !is_known(name) && !is_of_surfaces(name);
    if let Some(name) = root.extensions_required.iter().find(needed) {
        return Err(Error::Extension(crate::suggest::shown(name)));
    }
    for name in root.extensions_used.iter().filter(|name| !is_known(name)) {
        warnings.add(WarningKind::Extension(crate::suggest::shown(name)));
    }
    Ok(())
}

fn check_items(root: &Root, limits: Limits) -> Result<(), Error> {
    for (what, count) in [
        ("nodes", root.nodes.len()),
        ("meshes", root.meshes.len()),
        ("materials", root.materials.len()),
        ("images", root.images.len()),
    ] {
        if count > limits.items {
            let (most, limit) = (limits.items as u64, Limit::Items);
            return Err(Error::at(what, Cause::TooMany { what, most, limit }));
        }
    }
    Ok(())
}

fn buffers<'a>(
    root: &Root,
    binary: Option<&'a [u8]>,
    limits: Limits,
    load: Load<'_>,
) -> Result<Vec<Cow<'a, [u8]>>, Error> {
    let mut left = limits.bytes;
    let mut buffers = Vec::new();
    for (index, buffer) in root.buffers.iter().enumerate() {
        let here = |cause| Error::at(format!("buffers[{index}]"), cause);
        let failed = |why| here(Cause::Buffer(why));
        let bytes = match (&buffer.uri, binary) {
            (Some(uri), _) => match data(uri) {
                Some(bytes) => Cow::Owned(bytes.map_err(failed)?),
                None => Cow::Owned(load(&unescaped(uri)).map_err(failed)?),
            },
            (None, Some(binary)) if index == 0 => Cow::Borrowed(binary),
            (None, _) => {
                return Err(failed("it has no `uri`, and the file no such part".to_string()));
            }
        };
        left = left.checked_sub(bytes.len()).ok_or(Error::TooLong(limits.bytes))?;
        let there = bytes.len() as u64;
        if there < buffer.byte_length {
            return Err(here(Cause::TooFewBytes { needed: buffer.byte_length, there }));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

/// The bytes that a `data:` address consists of; `None` of any other.
fn data(uri: &str) -> Option<Result<Vec<u8>, String>> {
    const CONFIG: GeneralPurposeConfig =
        GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent);
    const ENGINE: GeneralPurpose = GeneralPurpose::new(&base64::alphabet::STANDARD, CONFIG);
    let (kind, text) = uri.strip_prefix("data:")?.split_once(',')?;
    if !kind.ends_with(";base64") {
        return Some(Err("its `data:` is not in base 64".to_string()));
    }
    Some(ENGINE.decode(text).map_err(|error| format!("its `data:` makes no sense: {error}")))
}

/// A name of a file, in which signs may stand as `%20`.
fn unescaped(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let code = after.get(..2).filter(|_| first == b'%');
        let code = code.and_then(|code| std::str::from_utf8(code).ok());
        let code = code.and_then(|code| u8::from_str_radix(code, 16).ok());
        bytes.push(code.unwrap_or(first));
        rest = if code.is_some() { &after[2..] } else { after };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The images that pictures of materials are made of; others are left out.
fn images(root: &Root, arrays: &Arrays<'_>, materials: &[Material]) -> Result<Vec<Image>, Error> {
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

fn materials(root: &Root, warnings: &mut Tally<WarningKind>) -> Result<Vec<Material>, Error> {
    let material = |(index, material): (usize, &json::Material)| {
        let failed = |cause| Error::at(format!("materials[{index}]"), cause);
        self::material(root, material, warnings).map_err(failed)
    };
    root.materials.iter().enumerate().map(material).collect()
}

fn material(
    root: &Root,
    material: &json::Material,
    warnings: &mut Tally<WarningKind>,
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

struct Builder<'a> {
    root: &'a Root,
    document: Document,
    warnings: Tally<WarningKind>,
    /// The primitives of the meshes that have been read.
    meshes: Vec<Option<Range<usize>>>,
    vertices: Budget,
    triangles: Budget,
}

impl Builder<'_> {
    fn add(&mut self, placed: &Placed<'_>, arrays: &Arrays<'_>) -> Result<(), Error> {
        let name = || format!("nodes[{}]", placed.index);
        if let Some(mesh) = placed.node.mesh {
            self.instance(mesh, placed, arrays)?;
        }
        if let Some(light) = &placed.node.extensions.light {
            let lights = &self.root.extensions.lights.lights;
            let light = item(lights, light.light, "light");
            let light = light.map_err(|cause| Error::at(name(), cause))?;
            self.light(light, placed);
        }
        if let Some(camera) = placed.node.camera {
            let camera = item(&self.root.cameras, camera, "camera");
            let camera = camera.map_err(|cause| Error::at(name(), cause))?;
            self.camera(camera, placed);
        }
        self.warnings.add_many(WarningKind::Skin, usize::from(placed.node.skin.is_some()));
        Ok(())
    }

    fn instance(
        &mut self,
        mesh: u64,
        placed: &Placed<'_>,
        arrays: &Arrays<'_>,
    ) -> Result<(), Error> {
        let here = |cause| Error::at(format!("nodes[{}]", placed.index), cause);
        item(&self.root.meshes, mesh, "mesh").map_err(here)?;
        for primitive in self.mesh(mesh as usize, arrays)? {
            let triangles = self.document.primitives[primitive].triangles.len();
            self.triangles.take(triangles as u64).map_err(here)?;
            self.document.instances.push(Instance { primitive, place: placed.place });
        }
        Ok(())
    }

    /// The primitives of a mesh, which is read once.
    fn mesh(&mut self, mesh: usize, arrays: &Arrays<'_>) -> Result<Range<usize>, Error> {
        if let Some(known) = &self.meshes[mesh] {
            return Ok(known.clone());
        }
        let first = self.document.primitives.len();
        for (index, primitive) in self.root.meshes[mesh].primitives.iter().enumerate() {
            let place = format!("meshes[{mesh}].primitives[{index}]");
            let material = primitive
                .material
                .map(|material| item(&self.document.materials, material, "material"));
            let material = material.transpose().map_err(|cause| Error::at(&*place, cause))?;
            let picture = material.and_then(|material| material.base_colour_picture);
            let set = picture.map_or(0, |picture| picture.set);
            let (vertices, warnings) = (&mut self.vertices, &mut self.warnings);
            let mut reader = Reader { arrays, vertices, warnings };
            self.document.primitives.extend(reader.primitive(primitive, &place, set)?);
        }
        let primitives = first..self.document.primitives.len();
        self.meshes[mesh] = Some(primitives.clone());
        Ok(primitives)
    }

    fn light(&mut self, light: &json::Light, placed: &Placed<'_>) {
        let cone = match light.kind.as_str() {
            "point" => None,
            "spot" => {
                let spot = light.spot.as_ref();
                let outer = spot.and_then(|spot| spot.outer_cone_angle);
                let outer = outer.unwrap_or(std::f32::consts::FRAC_PI_4);
                Some([spot.map_or(0.0, |spot| spot.inner_cone_angle), outer])
            }
            "directional" => return self.warnings.add(WarningKind::DirectionalLight),
            _ => return self.warnings.add(WarningKind::OddLight),
        };
        let intensity = Rgb::from(light.color) * light.intensity;
        let is_cone = |[inner, outer]: [f32; 2]| {
            0.0 <= inner && inner <= outer && 0.0 < outer && outer <= std::f32::consts::PI
        };
        let is_sound = intensity.is_finite() && intensity.min_band() >= 0.0;
        if !is_sound || !cone.is_none_or(is_cone) {
            return self.warnings.add(WarningKind::OddLight);
        }
        self.warnings.add_many(WarningKind::LightRange, usize::from(light.range.is_some()));
        let position = placed.place.translation.as_vec3();
        let direction = direction(placed, DVec3::NEG_Z);
        self.document.lights.push(Light { position, direction, intensity, cone });
    }

    fn camera(&mut self, camera: &json::Camera, placed: &Placed<'_>) {
        let Some(perspective) = &camera.perspective else {
            return self.warnings.add(WarningKind::Orthographic);
        };
        self.document.cameras.push(Camera {
            position: placed.place.translation.as_vec3(),
            direction: direction(placed, DVec3::NEG_Z),
            up: direction(placed, DVec3::Y),
            yfov: perspective.yfov,
            aspect: perspective.aspect_ratio,
        });
    }
}

/// A unit vector of a node in the scene.
fn direction(placed: &Placed<'_>, of_node: DVec3) -> Vec3 {
    placed.place.transform_vector3(of_node).normalize_or_zero().as_vec3()
}
