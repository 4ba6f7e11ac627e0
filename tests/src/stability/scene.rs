//! The rows of the table: failure scenes.

use crate::methods;
use crate::stability::{closed, crowded, plate};
use traylib_geometry::Vec3;
use traylib_integrators::{BlindSpot, Method};
use traylib_io::{LoadOptions, load_scene_with};
use traylib_scene::Scene;

/// A scene that breaks something.
#[derive(Clone, Copy, Debug)]
pub struct FailureScene {
    /// F1 to F15; a letter where a scene has variants.
    pub id: &'static str,
    /// The title of the scene.
    pub title: &'static str,
    /// The file or the code that it is made by.
    pub source: Source,
    /// The longest path, in edges.
    pub max_depth: Option<u32>,
    /// The truth that its picture is held against.
    pub truth: Truth,
    /// Kinds of light that all of its light belongs to, but for lamps seen
    /// directly: who cannot produce one of them finds nothing.
    pub light: &'static [BlindSpot],
    /// Passes in each run, a power of two.
    pub passes: u32,
}

/// The source of a scene.
#[derive(Clone, Copy, Debug)]
pub enum Source {
    /// A file of `scenes/failure`, without its ending.
    File(&'static str),
    /// Code, where a scene file has no words for it.
    Built(fn() -> Scene),
}

/// The truths that pictures are held against.
#[derive(Clone, Copy, Debug)]
pub enum Truth {
    /// The radiance seen from a place in a unit direction, of each band.
    Closed(fn(Vec3, Vec3) -> f64),
    /// The mean of so many passes of a method, with random numbers that no
    /// cell uses.
    Rendered(Method, u32),
}

impl FailureScene {
    /// The scene itself.
    ///
    /// # Panics
    /// If its file cannot be read or makes no sense.
    pub fn build(&self) -> Scene {
        match self.source {
            Source::File(name) => {
                let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes");
                // One of them includes a scene from the folder above.
                let options = LoadOptions { root: Some(scenes.as_ref()), ..Default::default() };
                let loaded = load_scene_with(&format!("{scenes}/failure/{name}.ron"), options);
                loaded.unwrap_or_else(|error| panic!("{name}: {error}")).scene
            }
            Source::Built(build) => build(),
        }
    }

    /// Tells whether all of its light comes from lamps with an area.
    pub fn has_area_lights_only(&self) -> bool {
        self.light.contains(&BlindSpot::AreaLights)
    }
}

const AREA: &[BlindSpot] = &[BlindSpot::AreaLights];
const CAUSTIC: &[BlindSpot] = &[BlindSpot::AreaLights, BlindSpot::Interreflection];
const MIRRORED_CAUSTIC: &[BlindSpot] =
    &[BlindSpot::AreaLights, BlindSpot::Interreflection, BlindSpot::SeenInMirrors];
const POINT_CAUSTIC: &[BlindSpot] = &[BlindSpot::PointLightCaustics, BlindSpot::Interreflection];
const MIRRORED_POINT: &[BlindSpot] = &[
    BlindSpot::PointLightCaustics,
    BlindSpot::PointLightCausticsInMirrors,
    BlindSpot::SeenInMirrors,
    BlindSpot::Interreflection,
];

/// All scenes but F11, which is asked another question
/// ([`scale`](crate::stability::scale)).
pub const SCENES: [FailureScene; 17] = [
    file("F1", "small lamp", "f01-small-lamp", closed(closed::small_lamp), AREA).passes(256),
    file("F2", "large lamp, sharp lobe", "f02-sharp-lobe", closed(closed::sharp_lobe), AREA)
        .passes(512),
    file("F3", "plates", "f03-plates", rendered(methods::COMBINED), AREA).up_to(2).passes(2048),
    file("F4", "caustic", "f04-caustic", closed(closed::caustic), CAUSTIC).up_to(3).passes(256),
    file(
        "F5",
        "caustic seen in a mirror",
        "f05-mirrored-caustic",
        closed(closed::mirrored_caustic),
        MIRRORED_CAUSTIC,
    )
    .up_to(4)
    .passes(2048),
    file("F6", "indirect light only", "f06-baffle", rendered(methods::BDPT), AREA).passes(256),
    file("F7", "door ajar", "f07-ajar-door", rendered(methods::BDPT), AREA).passes(1024),
    code("F8", "1000 lamps, 999 weak", crowded::weak, closed(crowded::weak_radiance), AREA)
        .passes(256),
    code("F8b", "1000 lamps, 999 hidden", crowded::hidden, closed(crowded::one_radiance), AREA)
        .passes(256),
    code("F8p", "1000 points, 999 weak", crowded::points, closed(crowded::points_radiance), &[])
        .passes(64),
    file("F9", "bright room", "f09-bright-room", rendered(methods::COMBINED), AREA).passes(128),
    file("F10", "corner", "f10-corner", closed(closed::corner), AREA).passes(1024),
    code("F12", "bump plate", plate::under_lamp, rendered(methods::COMBINED), AREA).passes(256),
    code(
        "F12p",
        "bump plate, point light",
        plate::under_point,
        rendered(methods::JITTERED_TRACE),
        &[],
    )
    .passes(256),
    file("F13", "camera sees 1e-4", "f13-small-view", closed(closed::small_view), &[]).passes(256),
    file(
        "F14",
        "point light, two mirrors",
        "f14-mirrored-point",
        closed(closed::mirrored_point),
        MIRRORED_POINT,
    )
    .up_to(4)
    .passes(256),
    file(
        "F15",
        "point light, one mirror",
        "f15-point-caustic",
        closed(closed::point_caustic),
        POINT_CAUSTIC,
    )
    .up_to(3)
    .passes(256),
];

const fn closed(radiance: fn(Vec3, Vec3) -> f64) -> Truth {
    Truth::Closed(radiance)
}

/// More than twenty times the passes of a run.
const fn rendered(by: Method) -> Truth {
    Truth::Rendered(by, 8192)
}

const fn file(
    id: &'static str,
    title: &'static str,
    name: &'static str,
    truth: Truth,
    light: &'static [BlindSpot],
) -> FailureScene {
    FailureScene { id, title, source: Source::File(name), max_depth: None, truth, light, passes: 0 }
}

const fn code(
    id: &'static str,
    title: &'static str,
    build: fn() -> Scene,
    truth: Truth,
    light: &'static [BlindSpot],
) -> FailureScene {
    let source = Source::Built(build);
    FailureScene { id, title, source, max_depth: None, truth, light, passes: 0 }
}

impl FailureScene {
    const fn up_to(mut self, edges: u32) -> Self {
        self.max_depth = Some(edges);
        self
    }

    const fn passes(mut self, passes: u32) -> Self {
        self.passes = passes;
        self
    }
}
