//! A file of shapes as a whole scene.

use super::Imported;
use super::coincidence;
use super::counter::Counter;
use super::frame;
use super::imported_material::ImportedMaterial;
use super::imported_object::{ImportedObject, ObjectMaterial};
use super::lights::add_light;
use super::meter;
use super::model::ModelFile;
use super::model_camera::ModelCamera;
use super::model_part::ModelPart;
use super::one_sided::{self, Described};
use super::placement::Placement;
use super::scene_parts::{PartObject, SceneParts};
use super::sky_light::SkyLight;
use crate::load_options::{Headlight, LoadOptions, SceneSettings};
use crate::picture::two_digits;
use crate::ron_scene;
use crate::source::Location;
use crate::{Error, Warning};
use std::f32::consts::PI;
use traylib_geometry::{Aabb, Vec3};
use traylib_math::Rgb;
use traylib_scene::{
    self as scene, Camera, CameraSettings, Light, Object, PointLight, Scene, SceneBuilder,
};

/// Width and height of a picture that nobody has named.
const RESOLUTION: (u32, u32) = (400, 300);
/// Samples per pixel where nobody says it.
const SAMPLES: u32 = 64;
/// The value in the picture of a grey surface in a room of grey walls.
const MIDDLE_GREY: f32 = 0.25;

/// Builds the scene of a file, with a camera if it has none. What it is built of is kept where the
/// caller wants it.
pub(crate) fn import_whole(
    location: &Location,
    options: LoadOptions<'_>,
    keep_parts: bool,
) -> Result<Imported, Error> {
    let (mut file, mut warnings) = ModelFile::read(location, options)?;
    let name = location.to_string();
    let mut counter = Counter::default();
    let failed = |cause| Error::Model { file: name.clone(), cause };
    let items = items(&file, &mut counter).map_err(|cause| failed(cause.into()))?;
    let bounds = frame::bounds(&items);
    if bounds.is_empty() {
        return Err(Error::NothingToSee(name));
    }
    let mut lights = file.lights(&Placement::NONE, &bounds);
    file.forget_shapes();
    let (view, mut notes) = view(&file, &items, &lights, &bounds, options);
    let lack = lack_of_light(&file, &lights, &items, options.headlight);
    if let Some(lack) = lack {
        if options.headlight == Headlight::Never {
            return Err(Error::Unlit(name));
        }
        counter.add(format!("{lack}, lit by a point light at the camera"));
        lights.push(headlight(&view, bounds.centre()));
    }
    let places = lights.iter().map(|light| light.position).chain([view.position]);
    let one_sided = one_sided(&file, &name, &items, places.collect());
    let objects =
        keep_parts.then(|| items.iter().filter_map(|item| PartObject::of(item, 0)).collect());
    let kept_lights = if keep_parts { lights.clone() } else { Vec::new() };
    let camera = Camera::new(view).map_err(failed)?;
    let scene = build(camera, &file, items, lights, &mut counter).map_err(failed)?;
    let exposure = match options.exposure.or(file.format.exposure()) {
        Some(exposure) => exposure,
        // Under the light at the camera surfaces show their colours as they are.
        None if lack.is_some() => 1.0,
        None => {
            let exposure = exposure(&file, &scene, &bounds);
            notes.push(format!(
                "no exposure in the file, taken: --exposure {exposure}, in a scene file exposure: {exposure}"
            ));
            exposure
        }
    };
    warnings.extend(counter.into_warnings(&name));
    warnings.extend(one_sided);
    warnings.extend(coincidence::warnings(&scene, &name));
    let settings = SceneSettings { spp: file.samples().unwrap_or(SAMPLES), exposure };
    let parts = objects.map(|objects| {
        let named = |material: &ImportedMaterial| (material.name.clone(), material.surface.clone());
        let materials = file.materials.iter().map(named).collect();
        let sky = file.sky().and_then(SkyLight::as_part);
        SceneParts { camera: view, settings, materials, objects, lights: kept_lights, sky }
    });
    Ok(Imported { scene, settings, warnings, notes, headlight: lack.is_some(), parts })
}

/// Returns the light that a file lacks, in words, if the caller wants one at the camera for it.
fn lack_of_light(
    file: &ModelFile,
    lights: &[PointLight],
    items: &[ImportedObject],
    headlight: Headlight,
) -> Option<&'static str> {
    let has_points = lights.iter().any(|light| !light.intensity.is_black());
    let glows = items.iter().any(|item| !item.emission.is_black())
        || file.sky().is_some_and(SkyLight::is_lit);
    match (has_points, glows, headlight) {
        (false, false, _) => Some("nothing in it emits light"),
        (false, true, Headlight::WithoutPointLight) => Some("it has no point or spot light"),
        (true, ..) | (false, true, Headlight::Never | Headlight::WithoutLight) => None,
    }
}

fn items(
    file: &ModelFile,
    counter: &mut Counter,
) -> Result<Vec<ImportedObject>, traylib_geometry::Error> {
    let parts = file.parts(&Placement::NONE, counter)?;
    let material = |part: &ModelPart| &file.materials[part.material];
    let object = |part| ImportedObject::of_model(material(&part), part, 0, 1.0);
    Ok(parts.into_iter().map(object).collect())
}

/// Warns of surfaces that let light through on one side only.
fn one_sided(
    file: &ModelFile,
    name: &str,
    items: &[ImportedObject],
    points: Vec<Vec3>,
) -> Vec<Warning> {
    let remedy = file.format.remedy();
    let described = |item| {
        let &ImportedObject {
            material: ObjectMaterial::Own(number) | ObjectMaterial::Named(number),
            ..
        } = item;
        let material = &file.materials[number];
        Described { item, material: &material.surface, name: &material.name, file: name, remedy }
    };
    one_sided::warnings(&items.iter().map(described).collect::<Vec<_>>(), points)
}

/// The file's camera, else one of ours and a note of it.
fn view(
    file: &ModelFile,
    items: &[ImportedObject],
    lights: &[PointLight],
    bounds: &Aabb,
    options: LoadOptions<'_>,
) -> (CameraSettings, Vec<String>) {
    let camera = file.camera();
    let aspect = camera.and_then(|camera| camera.aspect);
    let own = camera.and_then(|camera| camera.resolution);
    let (width, height) = options.resolution.or(own).unwrap_or_else(|| resolution(aspect));
    let settings = |view: ModelCamera| CameraSettings {
        position: view.position,
        target: view.target,
        up: view.up,
        fov_degrees: view.fov.horizontal(width as f32 / height as f32),
        width,
        height,
    };
    if let Some(view) = camera {
        return (settings(view), Vec::new());
    }
    let up = file.format.up(items, bounds);
    let view = settings(frame::camera(items, lights, bounds, up, width as f32 / height as f32));
    let note = format!("no camera in the file, taken: {}", shown(&view));
    (view, vec![note])
}

/// Chooses the resolution of a picture that nobody has named, for a camera that may be made for one
/// this much wider than high.
fn resolution(aspect: Option<f32>) -> (u32, u32) {
    let (width, height) = RESOLUTION;
    let sound = aspect.filter(|aspect| (0.1..=10.0).contains(aspect));
    (width, sound.map_or(height, |aspect| (width as f32 / aspect).round() as u32))
}

fn shown(view: &CameraSettings) -> String {
    ron_scene::Camera::of(view).to_string()
}

/// As bright as 3D Studio's lights: a diffuse surface in the middle shows its
/// colour.
fn headlight(view: &CameraSettings, middle: Vec3) -> PointLight {
    let intensity = Rgb::splat(PI * view.position.distance_squared(middle));
    PointLight { position: view.position, intensity, cone: None }
}

fn build(
    camera: Camera,
    file: &ModelFile,
    items: Vec<ImportedObject>,
    lights: Vec<PointLight>,
    counter: &mut Counter,
) -> Result<Scene, scene::Error> {
    let mut builder = SceneBuilder::new(camera);
    let materials = file.materials.iter().map(|material| material.surface.clone());
    let ids: Vec<_> = materials.map(|material| builder.add_material(material)).collect();
    for ImportedObject { shape, sides, material, emission, .. } in items {
        let (ObjectMaterial::Own(number) | ObjectMaterial::Named(number)) = material;
        let object = Object { shape, sides, material: ids[number], emission };
        match builder.add_object(object) {
            Err(scene::Error::EmptyMesh) => counter.add("mesh dropped: it has no area"),
            other => other?,
        }
    }
    for light in lights {
        add_light(&mut builder, light)?;
    }
    if let Some(SkyLight { radiance, turn_degrees }) = file.sky() {
        builder.set_sky(radiance.clone(), *turn_degrees)?;
    }
    builder.build()
}

/// The factor for 8-bit pictures, to two digits.
fn exposure(file: &ModelFile, scene: &Scene, bounds: &Aabb) -> f32 {
    let metered = if file.format.is_physical() { None } else { meter::exposure(scene) };
    let exposure = metered.unwrap_or_else(|| middle_grey(scene, bounds));
    two_digits(exposure).unwrap_or(1.0)
}

/// The factor that shows a room of this size as middle grey.
///
/// The power Φ of all lamps, spread over the walls of area A, leaves the radiance
/// Φ/(πA) if these reflect half of what arrives.
fn middle_grey(scene: &Scene, bounds: &Aabb) -> f64 {
    let power: f64 =
        scene.lights().iter().map(Light::power).map(|p| f64::from(p.luminance())).sum();
    let radiance = power / f64::from(PI * bounds.surface_area());
    f64::from(MIDDLE_GREY) / radiance
}
