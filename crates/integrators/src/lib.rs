//! Light transport algorithms: from a scene to its picture.
//!
//! ```
//! use traylib_geometry::{Facing, Primitive, Quad, Sides, Sphere, Vec3};
//! use traylib_integrators::{Method, Settings, render_to_end};
//! use traylib_materials::{Lambert, SurfaceModel};
//! use traylib_math::Rgb;
//! use traylib_scene::{Camera, CameraSettings, Object, ObjectShape, SceneBuilder};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let scratch = std::env::temp_dir().join(format!("traylib-ball-{}", std::process::id()));
//! # std::fs::create_dir_all(&scratch)?;
//! # std::env::set_current_dir(&scratch)?;
//! let (position, target, up) = (Vec3::new(0.0, 2.0, 6.0), Vec3::Y, Vec3::Y);
//! let (fov_degrees, width, height) = (45.0, 64, 48);
//! let camera =
//!     Camera::new(CameraSettings { position, target, up, fov_degrees, width, height })?;
//! let mut builder = SceneBuilder::new(camera);
//! let white = builder.add_material(SurfaceModel::Lambert(Lambert::new(Rgb::splat(0.7))?));
//!
//! let floor = Quad::new(Vec3::new(-3.0, 0.0, -3.0), 6.0 * Vec3::Z, 6.0 * Vec3::X)?;
//! let ball = Sphere::new(Vec3::Y, 1.0, Facing::Outward)?;
//! // Its front is where X × Z points: below.
//! let lamp = Quad::new(Vec3::new(-1.0, 4.0, -1.0), 2.0 * Vec3::X, 2.0 * Vec3::Z)?;
//! for (shape, emission) in [
//!     (Primitive::Quad(floor), Rgb::BLACK),
//!     (Primitive::Sphere(ball), Rgb::BLACK),
//!     (Primitive::Quad(lamp), Rgb::splat(8.0)),
//! ] {
//!     let (shape, sides) = (ObjectShape::Primitive(shape), Sides::Both);
//!     builder.add_object(Object { shape, sides, material: white, emission })?;
//! }
//! let scene = builder.build()?;
//!
//! let settings = Settings { spp: 16, ..Settings::default() };
//! let picture = render_to_end(&scene, &*Method::BDPT.build(), &settings)?.film.develop();
//!
//! let mut file = format!("P6 {width} {height} 255\n").into_bytes();
//! for radiance in picture.values() {
//!     file.extend(radiance.to_array().map(|band| (255.0 * band.powf(1.0 / 2.2)) as u8));
//! }
//! std::fs::write("ball.ppm", file)?;
//! # let (lit, shadow) = (picture.get(8, 40).g, picture.get(32, 40).g);
//! # assert!(lit > 2.0 * shadow && shadow > 0.0, "{lit} {shadow}");
//! # std::env::set_current_dir(std::env::temp_dir())?;
//! # std::fs::remove_dir_all(scratch)?;
//! # Ok(())
//! # }
//! ```
//!
//! `traylib-io` writes other formats, and reads scenes from files.
//!
//! | integrator | what it samples | section of the paper |
//! |---|---|---|
//! | [`Trace`] | point lights, one ray a pixel, no interreflection | 3.2 |
//! | [`PureMc`] | walks until a lamp is hit | 2.1 |
//! | [`DirectLight`] | lamps, at every vertex; combined with hits if asked | 2.2, 2.3 |
//! | [`Particle`] | walks from the lamps, seen by the camera | |
//! | [`Bdpt`] | walks from both ends and every way to join them | 2.4, 4 |
//!
//! All of them estimate the same radiance wherever they can see it; what one
//! cannot see at all, [`Integrator::blind_spots`] tells before rendering starts.
//! [`Method`] is the list of them with their settings, spelled as on command lines.
//! [`render`] owns threads, random streams and the film.

mod bdpt;
mod blind;
mod chunk;
mod control;
mod direct;
mod directlight;
mod emission;
mod first_hits;
mod found_path;
mod limits;
mod method;
mod mirrored_point;
mod numbers;
mod particle;
mod pass;
mod path_scattering;
pub mod planner;
mod puremc;
mod render;
mod splat;
mod step;
mod toward_light;
mod trace;
mod tracer;

pub use bdpt::{
    Auto, Bdpt, BdptSettings, LightSampling, MayLose, PathsPerPixel, Report, Technique,
    TechniqueSet, Techniques, Weighting,
};
pub use blind::{BlindSpot, SceneFacts};
pub use chunk::{Chunk, ChunkOutput};
pub use control::Control;
pub use directlight::DirectLight;
pub use first_hits::{FirstHit, FirstHits};
pub use found_path::FoundPath;
pub use limits::{Limits, Roulette};
pub use method::{Engine, Method, MethodError, MethodOption, MethodSetting, OptionValues};
pub use numbers::{Dimensions, PathSampler, PointSet};
pub use particle::Particle;
pub use pass::{Pass, RenderChunk};
pub use puremc::PureMc;
pub use render::{
    Progress, Renderer, Rendering, Settings, ThreadError, ThreadPool, render, render_to_end,
    thread_pool,
};
pub use trace::Trace;
pub use tracer::Statistics;

/// The parts that algorithms are made of, for those that are not here yet.
///
/// A [`Tracer`](toolkit::Tracer) casts rays and counts them. A walk from the camera begins
/// with [`Chunk::sample_pixels`], one from a light with [`emit`](toolkit::emit); both go on by
/// [`next_step`](toolkit::next_step), which samples the surface and plays roulette. At each
/// vertex [`VertexNumbers`](toolkit::VertexNumbers) are drawn;
/// [`sample_light`](toolkit::sample_light) aims at a light and
/// [`aim_at_camera`](toolkit::aim_at_camera) at the camera.
///
/// Two algorithms made of these alone are in `crates/demos/examples`.
pub mod toolkit {
    pub use crate::chunk::pixel_corner;
    pub use crate::direct::{LightSample, sample_light, sample_point_lights};
    pub use crate::emission::{Emitted, emit};
    pub use crate::mirrored_point::light_through_mirrors;
    pub use crate::numbers::VertexNumbers;
    pub use crate::path_scattering::PathScattering;
    pub use crate::splat::{Splat, aim_at_camera};
    pub use crate::step::{Step, next_step, next_step_toward_light};
    pub use crate::toward_light::{TowardLight, images_for};
    pub use crate::tracer::{SurfaceHit, Tracer};
}

use traylib_scene::Scene;

/// An algorithm that renders passes.
///
/// A pass is one camera path a pixel and a number of light paths that the
/// integrator names. The driver cuts it into [`Chunk`]s; an integrator renders
/// a chunk from the chunk's own random streams and nothing else, so the result
/// does not depend on who renders which chunk when.
pub trait Integrator: Sync {
    /// Light paths in one pass over a film of `pixels` pixels.
    fn light_paths(&self, pixels: u32) -> u32 {
        let _ = pixels;
        0
    }

    /// Renders one chunk of a pass. What comes of it is thrown away if the chunk's
    /// control was cancelled meanwhile. Does nothing unless it is given; it need not be where
    /// [`begin_pass`](Self::begin_pass) is.
    fn render_chunk(&self, scene: &Scene, chunk: &Chunk<'_>, out: &mut ChunkOutput) {
        let _ = (scene, chunk, out);
    }

    /// For algorithms whose camera work needs the light work of the whole pass, as photon
    /// maps do: does that, with [`Pass::chunks`], and gives what then renders each chunk.
    /// `None`, which costs nothing, stands for [`render_chunk`](Self::render_chunk).
    fn begin_pass<'a>(&'a self, scene: &'a Scene, pass: &Pass<'_>) -> Option<RenderChunk<'a>> {
        let _ = (scene, pass);
        None
    }

    /// The kinds of light that this integrator cannot produce in such a scene,
    /// however long it renders.
    fn blind_spots(&self, facts: &SceneFacts) -> Vec<BlindSpot>;
}

/// Runs the examples of the package's README as tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
