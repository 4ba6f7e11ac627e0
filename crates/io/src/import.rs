//! From documents to a scene.
//!
//! Everything that makes no sense is collected, with its place in the text, and
//! reported together.

mod coincidence;
mod counter;
mod files;
mod frame;
mod imported_material;
mod imported_object;
mod lights;
mod material;
mod mesh;
mod meter;
mod model;
mod model_camera;
mod model_part;
mod object;
mod one_sided;
mod place;
mod placement;
mod scene_parts;
mod shape;
mod sky;
mod sky_light;
mod textures;
mod whole;

pub(crate) use files::{SceneFile, gather};
pub(crate) use scene_parts::{PartObject, PartSky, SceneParts};
pub(crate) use whole::import_whole;

use crate::load_options::{LoadOptions, SceneSettings};
use crate::locate::Path;
use crate::report::Problems;
use crate::ron_scene::Shape;
use crate::source::Location;
use crate::{Error, MAX_PIXELS, MeshCounts, Warning};
use imported_object::{ImportedObject, ObjectMaterial};
use material::Materials;
use model::ModelFiles;
use one_sided::Described;
use sky::ImportedSky;
use traylib_materials::Material;
use traylib_math::Vec3;
use traylib_scene::{Camera, CameraSettings, Object, PointLight, Scene, SceneBuilder};

/// A scene and what came with it.
pub(crate) struct Imported {
    pub(crate) scene: Scene,
    pub(crate) settings: SceneSettings,
    pub(crate) warnings: Vec<Warning>,
    /// Notes of the choices that no file makes.
    pub(crate) notes: Vec<String>,
    /// Whether it got a light at the camera.
    pub(crate) headlight: bool,
    /// The parts that it was built of, if they were to be kept.
    pub(crate) parts: Option<SceneParts>,
}

/// Tells whether a file's name says that it brings shapes without being a scene file.
pub(crate) fn is_model(path: &std::path::Path) -> bool {
    model::Format::of(path).is_some()
}

/// Tells whether [`mesh_counts`] counts files of this name.
pub(crate) fn has_mesh_counts(path: &std::path::Path) -> bool {
    model::counts::is_counted(path)
}

/// Counts the contents of a file of meshes.
pub(crate) fn mesh_counts(
    location: &Location,
    options: LoadOptions<'_>,
) -> Result<(MeshCounts, Vec<Warning>), Error> {
    model::counts::of(location, options)
}

/// Builds the scene of these files; the last one is the scene itself, the
/// others are included. What it is built of is kept where the caller wants it.
pub(crate) fn import(
    files: &[SceneFile],
    options: LoadOptions<'_>,
    keep_parts: bool,
) -> Result<Imported, Error> {
    let mut problems = Problems::default();
    let Some(root) = files.last() else { return Err(Error::Scene(problems.into_report())) };
    let camera = camera(root, options, &mut problems);
    let settings = settings(root, &mut problems);
    let mut materials = Materials::collect(files, options.limits, &mut problems);
    let sky = ImportedSky::of(root, materials.textures(), &mut problems);
    let mut models = ModelFiles::new(options);
    let parts = object::collect(files, &materials, &mut models, &mut problems);
    let mut points = lights::collect(files, &mut problems);
    points.extend(models.take_lights());
    models.forget_files();
    let is_sky_lit = sky.as_ref().map_or(root.document.sky.is_some(), |sky| sky.light.is_lit());
    check_for_light(files, &parts, (&points, is_sky_lit), &mut problems);
    match camera {
        Some(camera) if problems.is_empty() => {
            let places = points.iter().map(|light| light.position).chain([camera.position()]);
            let one_sided = one_sided(&parts, &materials, &models, places.collect());
            let kept = keep_parts.then(|| SceneParts {
                camera: camera.settings(),
                settings,
                materials: named(&materials, &models),
                objects: kept_objects(&parts, materials.models().len()),
                lights: points.clone(),
                sky: sky.as_ref().and_then(|sky| sky.light.as_part()),
            });
            let lights = (points, sky);
            let scene =
                build(root, camera, [materials.models(), models.materials()], parts, lights)?;
            let mut warnings = materials.into_warnings();
            warnings.extend(models.into_warnings());
            warnings.extend(one_sided);
            warnings.extend(coincidence::warnings(&scene, &root.source.name));
            Ok(Imported {
                scene,
                settings,
                warnings,
                notes: Vec::new(),
                headlight: false,
                parts: kept,
            })
        }
        _ => Err(Error::Scene(problems.into_report())),
    }
}

/// All materials with their names, those of scene files first.
fn named(materials: &Materials, models: &ModelFiles<'_>) -> Vec<(String, Material)> {
    let own = (0..).zip(materials.models());
    let own = own.map(|(number, material)| (materials.name(number).to_string(), material.clone()));
    let others = (0..).zip(models.materials());
    let others =
        others.map(|(number, material)| (models.name(number).to_string(), material.clone()));
    own.chain(others).collect()
}

fn kept_objects(parts: &[object::Part], named: usize) -> Vec<PartObject> {
    parts.iter().filter_map(|part| PartObject::of(&part.item, named)).collect()
}

fn camera(root: &SceneFile, options: LoadOptions<'_>, problems: &mut Problems) -> Option<Camera> {
    let Some(camera) = &root.document.camera else {
        let help = "add for instance `camera: (position: (0, 1, 4), target: (0, 1, 0), fov: 40, \
                    resolution: (400, 300))`";
        problems
            .push(root.place(Path::default()).missing("the scene has no camera").with_help(help));
        return None;
    };
    let place = root.place(Path::of("camera"));
    let (width, height) = options.resolution.unwrap_or(camera.resolution);
    if u64::from(width) * u64::from(height) > MAX_PIXELS {
        problems.push(place.field("resolution").problem("the picture has more than 2^28 pixels"));
    }
    let settings = CameraSettings {
        position: Vec3::from(camera.position),
        target: Vec3::from(camera.target),
        up: Vec3::from(camera.up),
        fov_degrees: camera.fov,
        width,
        height,
    };
    let part = faulty_part(&settings);
    let camera = Camera::new(settings).map_err(|error| {
        let help = (part == "up").then(|| "give `up` another direction".to_string());
        problems.push(place.field(part).problem(error).with_help_if_any(help));
    });
    camera.ok()
}

/// The field that a camera cannot be made of, if it cannot be made. What is left is that
/// up points along the view.
fn faulty_part(settings: &CameraSettings) -> &'static str {
    let CameraSettings { position, target, up, fov_degrees, width, height } = *settings;
    if !position.is_finite() {
        "position"
    } else if !target.is_finite() || position == target {
        "target"
    } else if up.is_finite() && !(0.0 < fov_degrees && fov_degrees < 180.0) {
        "fov"
    } else if up.is_finite() && (width == 0 || height == 0) {
        "resolution"
    } else {
        "up"
    }
}

fn settings(root: &SceneFile, problems: &mut Problems) -> SceneSettings {
    let spp = root.document.spp.unwrap_or(64);
    let exposure = root.document.exposure.unwrap_or(1.0);
    if spp == 0 {
        problems.push(root.place(Path::of("spp")).problem("at least 1 sample per pixel is needed"));
    }
    if !(exposure > 0.0 && exposure.is_finite()) {
        let place = root.place(Path::of("exposure"));
        problems.push(place.problem("the exposure must be positive and finite"));
    }
    SceneSettings { spp, exposure }
}

/// Refuses a scene that would be black. What could not be brought in might have
/// been its light.
fn check_for_light(
    files: &[SceneFile],
    parts: &[object::Part],
    (points, is_sky_lit): (&[PointLight], bool),
    problems: &mut Problems,
) {
    let objects = || files.iter().flat_map(|file| &file.document.objects);
    let is_mesh = objects().any(|object| matches!(object.shape, Shape::Mesh(_)));
    let unknown = is_mesh && !problems.is_empty();
    let lit = objects().any(|object| object.emission.is_some_and(|light| light != [0.0; 3]))
        || points.iter().any(|light| !light.intensity.is_black())
        || parts.iter().any(|part| !part.item.emission.is_black());
    let lit = lit || is_sky_lit || unknown;
    if let (false, Some(root)) = (lit, files.last()) {
        let problem = root.place(Path::default()).missing("nothing in the scene emits light");
        let help = "give an object `emission: (4, 4, 4)`, or add \
                    `lights: [Point(position: (0, 2, 0), intensity: (10, 10, 10))]`";
        problems.push(problem.with_help(help));
    }
}

/// Surfaces that let light through on one side only, of all files.
fn one_sided(
    parts: &[object::Part],
    materials: &Materials,
    models: &ModelFiles<'_>,
    points: Vec<Vec3>,
) -> Vec<Warning> {
    let items = parts.iter().map(|object::Part { place, item }| {
        let (material, name) = match item.material {
            ObjectMaterial::Named(index) => (&materials.models()[index], materials.name(index)),
            ObjectMaterial::Own(index) => (&models.materials()[index], models.name(index)),
        };
        let (file, remedy) = (place.source.name.as_str(), "give the object `sides: Both`");
        Described { item, material, name, file, remedy }
    });
    one_sided::warnings(&items.collect::<Vec<_>>(), points)
}

/// Builds the scene. Parts that passed the checks before can only fail in ways that depend
/// on the whole.
fn build(
    root: &SceneFile,
    camera: Camera,
    materials: [&[Material]; 2],
    parts: Vec<object::Part>,
    (points, sky): (Vec<PointLight>, Option<ImportedSky>),
) -> Result<Scene, Error> {
    let mut builder = SceneBuilder::new(camera);
    let [named, own] = materials
        .map(|some| some.iter().map(|m| builder.add_material(m.clone())).collect::<Vec<_>>());
    let mut problems = Problems::default();
    for object::Part { place, item: ImportedObject { shape, sides, material, emission, .. } } in
        parts
    {
        let material = match material {
            ObjectMaterial::Named(index) => named[index],
            ObjectMaterial::Own(index) => own[index],
        };
        let object = Object { shape, sides, material, emission };
        place.note(builder.add_object(object), &mut problems);
    }
    let whole = root.place(Path::default());
    for light in points {
        whole.note(lights::add_light(&mut builder, light), &mut problems);
    }
    if let Some(ImportedSky { light, place }) = sky {
        place.note(builder.set_sky(light.radiance, light.turn_degrees), &mut problems);
    }
    let scene = whole.note(builder.build(), &mut problems);
    scene.filter(|_| problems.is_empty()).ok_or(Error::Scene(problems.into_report()))
}

#[cfg(test)]
mod tests;
