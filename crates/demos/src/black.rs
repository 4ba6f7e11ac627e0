//! The reason why a picture is black, as far as its scene tells.

use crate::options::RenderOptions;
use std::path::Path;
use traylib_geometry::Ray;
use traylib_integrators::{BlindSpot, Integrator, Limits, SceneFacts};
use traylib_io::Look;
use traylib_math::{Grid, Rgb, Vec2, Vec3};
use traylib_scene::{MAX_PASS_THROUGHS, Scene, SurfacePoint};

/// Rays from the camera that are looked at, across the picture and down.
const GRID: [u32; 2] = [64, 48];

/// The facts of a rendering that may be black.
pub(crate) struct Picture<'a> {
    pub(crate) program: &'a str,
    pub(crate) scene: &'a Scene,
    pub(crate) integrator: &'a dyn Integrator,
    pub(crate) limits: Limits,
    pub(crate) look: Look,
    pub(crate) radiance: &'a Grid<Rgb>,
}

/// Says why all that is written is black; `None` if it is not.
pub(crate) fn reason(picture: &Picture<'_>, options: &RenderOptions) -> Option<String> {
    let pixels = picture.radiance.values();
    let brightest = pixels.iter().map(|pixel| pixel.max_band()).fold(0.0, f32::max);
    if brightest == 0.0 {
        return Some(without_light(picture));
    }
    let is_stepped =
        options.outfile.is_empty() || options.outfile.iter().any(|file| is_stepped(file));
    let is_shown = |&pixel: &Rgb| picture.look.bytes(pixel) != [0; 3];
    if !is_stepped || pixels.iter().any(is_shown) {
        return None;
    }
    let (exposure, wanted) = (picture.look.exposure, 1.0 / brightest);
    Some(format!(
        "its radiance is at most {brightest:.2e}, which an exposure of {exposure} leaves below the \
         first of 255 steps; try --exposure {wanted:.2e}"
    ))
}

/// Tells whether a picture of this name has 256 steps of brightness.
pub(crate) fn is_stepped(file: &Path) -> bool {
    let ending = file.extension().unwrap_or_default();
    !["exr", "hdr"].iter().any(|keeps_light| ending.eq_ignore_ascii_case(keeps_light))
}

/// Names the obstacle between any light and the camera, the plainest first.
fn without_light(picture: &Picture<'_>) -> String {
    let Picture { program, scene, integrator, limits, .. } = *picture;
    let lights = scene.lights();
    if lights.iter().all(|light| light.power().is_black()) {
        return "nothing in the scene emits light".into();
    }
    let points = lights.iter().filter(|light| light.is_point()).count();
    let areas = lights.len() - points - usize::from(scene.sky().is_some());
    let blind = integrator.blind_spots(&SceneFacts::of(scene));
    let is_blind = |spot| blind.contains(&spot);
    let view = View::of(scene);
    if let Some(reason) = view.reason(scene) {
        return reason;
    }
    if limits.max_depth == Some(1) {
        return "--max-depth 1 shows lamps alone, and none shows its front to the camera".into();
    }
    if lights.len() == 1 && is_blind(BlindSpot::SkyLight) {
        return format!(
            "{program} sees no light of the sky on surfaces, and the scene has no other; try bdpt"
        );
    }
    if points == 0 && is_blind(BlindSpot::AreaLights) {
        return format!(
            "{program} sees no light of lamps that have an area, and the scene has no other lamps \
             ({areas} of these); try bdpt"
        );
    }
    if view.ideal == view.met && is_blind(BlindSpot::SeenInMirrors) {
        return format!("{program} sees nothing in mirrors and glass, and all that is met is such");
    }
    if view.backs == view.met {
        return "all surfaces in view are seen from their backs, where no light came: the camera \
                may stand inside of something"
            .into();
    }
    let cannot = |spot: &BlindSpot| format!("; {program} cannot produce {spot}");
    "no light was found on what is in view: something may stand between, or it takes more --spp"
        .to_string()
        + &blind.iter().map(cannot).collect::<String>()
}

/// The numbers of rays from the camera, by the surfaces that they meet.
#[derive(Default)]
struct View {
    met: u32,
    /// Surfaces that absorb all, of those met.
    black: u32,
    ideal: u32,
    backs: u32,
}

impl View {
    fn of(scene: &Scene) -> Self {
        let camera = scene.camera();
        let [columns, rows] = GRID;
        let part =
            Vec2::new(camera.width() as f32 / columns as f32, camera.height() as f32 / rows as f32);
        let mut view = Self::default();
        for index in 0..columns * rows {
            let cell = Vec2::new((index % columns) as f32, (index / columns) as f32);
            let ray = camera.ray((cell + 0.5) * part);
            let Some(point) = surface(scene, ray) else { continue };
            view.met += 1;
            view.black += u32::from(is_black(&point, -ray.direction));
            view.ideal += u32::from(!point.model.has_smooth_part());
            view.backs += u32::from(!point.is_front());
        }
        view
    }

    /// Names the fault that does not depend on the lamps, if there is one.
    fn reason(&self, scene: &Scene) -> Option<String> {
        if self.met > 0 {
            let is_dark = self.black == self.met;
            return is_dark.then(|| "all surfaces in view are black: they reflect nothing".into());
        }
        let position = scene.camera().position();
        let around = axes().any(|way| scene.intersect(&Ray::new(position, way)).is_some());
        Some(if around {
            "the camera looks past everything: no ray of the picture meets a surface".into()
        } else {
            "no ray of the picture meets a surface: the camera looks past everything, or stands \
             behind surfaces of one side, whose backs are not there"
                .into()
        })
    }
}

/// The ways along, across and between the axes.
fn axes() -> impl Iterator<Item = Vec3> {
    let steps = || [-1.0, 0.0, 1.0].into_iter();
    let all = steps()
        .flat_map(move |x| steps().flat_map(move |y| steps().map(move |z| Vec3::new(x, y, z))));
    all.filter_map(Vec3::try_normalize)
}

/// The first surface that does not let all light straight through.
fn surface(scene: &Scene, mut ray: Ray) -> Option<SurfacePoint> {
    for _ in 0..MAX_PASS_THROUGHS {
        let point = scene.intersect(&ray)?;
        if point.through != Rgb::WHITE {
            return Some(point);
        }
        ray.origin = point.site.ray_origin(ray.direction);
    }
    None
}

/// Tells whether a surface throws nothing toward `wo`, by some of its samples.
fn is_black(point: &SurfacePoint, wo: Vec3) -> bool {
    let numbers = [[0.1, 0.3, 0.7], [0.5, 0.2, 0.1], [0.9, 0.6, 0.4], [0.99, 0.1, 0.9]];
    let sample = |u| point.model.sample(point.shading_normal, wo, u);
    point.through.is_black()
        && numbers.into_iter().all(|u| sample(u).is_none_or(|sample| sample.weight.is_black()))
}
