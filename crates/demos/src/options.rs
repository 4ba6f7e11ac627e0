//! Options that all programs understand.

use crate::aov::Aov;
use crate::camera_options::CameraOptions;
use crate::display::DisplayAddress;
use crate::duration::parse_duration;
use crate::exposure::Exposure;
use crate::keep_options::KeepOptions;
use crate::noise::Noise;
use crate::outcome::Failure;
use crate::progress_form::ProgressForm;
use crate::window_options::{PixelBounds, WindowOptions};
use clap::Args;
use std::path::PathBuf;
use std::str::FromStr;
use std::time::Duration;
use traylib_integrators::PointSet;
use traylib_io::{Headlight, Limit, LoadOptions, MAX_PIXELS, ReadLimits, Tone};
use traylib_scene::Camera;

/// The options of what to render and how much.
#[derive(Args, Clone, Debug)]
pub struct RenderOptions {
    /// Scene file (.ron, .gltf, .glb, .obj, .ply, .3ds, .mgf, Mitsuba's .xml) or name of a
    /// built-in scene
    #[arg(default_value = "cornell")]
    pub scene: String,

    /// Further MGF files of the same scene, with --check --stats
    #[arg(requires_all = ["stats", "check"], value_name = "MORE")]
    pub more: Vec<String>,

    /// Picture to write, .png, .exr, .hdr, .tga or .pcx; may be repeated
    /// [default: PROGRAM.png]
    #[arg(short, long = "outfile", visible_alias = "output", value_name = "FILE")]
    pub outfile: Vec<PathBuf>,

    /// Layers of an .exr beside its light
    #[arg(long, value_name = "LAYERS", value_delimiter = ',')]
    pub aov: Vec<Aov>,

    /// Samples per pixel [default: the scene's, in `trace` 1; with --time-limit
    /// as many as it takes]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub spp: Option<u32>,

    /// Size of the picture in pixels [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = parse_resolution)]
    pub resolution: Option<(u32, u32)>,

    /// Where it is taken from
    #[command(flatten)]
    pub view: CameraOptions,

    /// Which part of the picture
    #[command(flatten)]
    pub window: WindowOptions,

    /// Factor on light in 8-bit pictures; `auto` shows the middle of the picture as middle grey,
    /// and says by which factor [default: the scene's]
    #[arg(long, value_name = "FACTOR")]
    pub exposure: Option<Exposure>,

    /// The curve that light follows there: `linear`, or `filmic`, which keeps more of what is
    /// brighter than white
    #[arg(long, value_name = "CURVE", default_value_t = Tone::default())]
    pub tone: Tone,

    /// Seed of the random numbers: same seed, same picture
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,

    /// Where random numbers come from: `independent`, or `sobol`, whose points fill the space
    /// of paths more evenly
    #[arg(long, value_name = "NAME", default_value_t = PointSet::default())]
    pub sampler: PointSet,

    /// Threads, up to 1024, 0 for one a processor; the picture stays the same
    #[arg(short, long, value_name = "N", default_value_t = 0, value_parser = parse_threads)]
    pub threads: usize,

    /// End at this time, as 90s, 1m30s or 1.5h, with the passes that are done
    /// [default: none]
    #[arg(long, value_name = "TIME", value_parser = parse_duration)]
    pub time_limit: Option<Duration>,

    /// End when the estimated error is no more than this, as 0.01 or 1%, after 16 passes or more;
    /// looks for it now and then, which favours pictures that seem better than they are. Status 5
    /// if --spp or --time-limit ends it before
    #[arg(long, value_name = "ERROR", conflicts_with = "shard")]
    pub noise: Option<Noise>,

    /// What to keep of the rendering
    #[command(flatten)]
    pub keep: KeepOptions,

    /// Print errors alone
    #[arg(short, long)]
    pub quiet: bool,

    /// Print the names of the built-in scenes
    #[arg(long)]
    pub list: bool,

    /// Find out whether the picture could be made and written, without making it
    #[arg(long)]
    pub check: bool,

    /// How to tell how far it is
    #[arg(long, value_name = "FORM", default_value = "line")]
    pub progress: ProgressForm,

    /// Show the picture in a viewer while it is rendered: in tev, or one that is told the same by
    /// TCP; boxes are where most of the estimated error is. Port 14158 if none is named
    #[arg(long, value_name = "HOST:PORT")]
    pub display_server: Option<DisplayAddress>,

    /// Write what was done as JSON: passes, rays, paths, seconds, memory, and what ended it;
    /// with --check what is in the file, also of one of shapes without camera or lamp. `-` is
    /// standard output
    #[arg(long, value_name = "FILE")]
    pub stats: Option<PathBuf>,

    /// The folder that files included by a scene or MGF file may come from
    /// [default: that of the first file]
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,

    /// Allow more of what files may ask for, as a message names it: bytes, memory,
    /// work, surfaces, corners, cutting, line, depth, transforms, items or pixels, as
    /// surfaces=2M; may be repeated
    #[arg(long, value_name = "NAME=N", value_parser = parse_limit)]
    pub limit: Vec<(Limit, u64)>,
}

impl RenderOptions {
    /// Returns the options for reading files otherwise than they say.
    pub(crate) fn load_options(&self) -> LoadOptions<'_> {
        let mut limits = ReadLimits::default();
        self.limit.iter().for_each(|&(limit, value)| limits.set(limit, value));
        LoadOptions {
            resolution: self.resolution,
            exposure: self.exposure.and_then(Exposure::factor),
            root: self.root.as_deref(),
            headlight: Headlight::default(),
            limits,
        }
    }
}

/// A pixel, as `X,Y` from the top left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelName {
    x: u32,
    y: u32,
}

impl PixelName {
    /// The row-major index of the pixel, which is counted in the frame, in the camera's picture.
    ///
    /// # Errors
    /// The picture has no such pixel.
    pub fn index_in(self, camera: &Camera) -> Result<u32, Failure> {
        let Self { x, y } = self;
        let window = camera.window();
        let (column, row) = (x.wrapping_sub(window.x), y.wrapping_sub(window.y));
        if column < window.width && row < window.height {
            return Ok(row * window.width + column);
        }
        let (width, height, bounds) = (window.width, window.height, PixelBounds::of(window));
        Err(Failure::usage(format_args!(
            "--pixel {x},{y} is outside the {width}x{height} picture, {bounds}"
        )))
    }
}

impl FromStr for PixelName {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        text.split_once(',')
            .and_then(|(x, y)| Some(Self { x: x.trim().parse().ok()?, y: y.trim().parse().ok()? }))
            .ok_or("wanted as X,Y")
    }
}

const LARGEST_SIDE: u32 = 32_768;

/// Reads `640x480`.
///
/// # Errors
/// Returns a description of the value that was wanted instead.
pub fn parse_resolution(text: &str) -> Result<(u32, u32), String> {
    let side = |text: &str| text.parse().ok().filter(|side| (1..=LARGEST_SIDE).contains(side));
    text.split_once('x')
        .and_then(|(width, height)| Some((side(width)?, side(height)?)))
        .filter(|&(width, height)| u64::from(width) * u64::from(height) <= MAX_PIXELS)
        .ok_or_else(|| {
            format!(
                "wanted as 640x480, each side from 1 to {LARGEST_SIDE}, at most {MAX_PIXELS} pixels"
            )
        })
}

const MOST_THREADS: usize = 1024;

/// Reads a number of threads.
///
/// # Errors
/// Returns a description of the value that was wanted instead.
pub fn parse_threads(text: &str) -> Result<usize, String> {
    let threads = text.parse().ok().filter(|threads| *threads <= MOST_THREADS);
    threads.ok_or_else(|| format!("wanted a number from 0, one a processor, to {MOST_THREADS}"))
}

/// Reads `surfaces=2000000` or `surfaces=2M`.
///
/// # Errors
/// Returns a description of the value that was wanted instead.
pub fn parse_limit(text: &str) -> Result<(Limit, u64), String> {
    let names = || Limit::ALL.map(Limit::name).join(", ");
    let wanted = || format!("wanted as surfaces=2M, with k, M, G or none; names: {}", names());
    let (name, number) = text.split_once('=').ok_or_else(wanted)?;
    let limit = Limit::of_name(name).ok_or_else(wanted)?;
    let (digits, unit) = match number.strip_suffix(['k', 'M', 'G']) {
        Some(digits) if number.ends_with('k') => (digits, 1000),
        Some(digits) if number.ends_with('M') => (digits, 1_000_000),
        Some(digits) => (digits, 1_000_000_000),
        None => (number, 1),
    };
    let value = digits.parse::<u64>().ok().and_then(|value| value.checked_mul(unit));
    value.map(|value| (limit, value)).ok_or_else(wanted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn resolutions_have_two_sides() {
        assert_eq!(parse_resolution("640x480"), Ok((640, 480)));
        for bad in ["640", "640x", "x480", "0x480", "640x-1", "1e3x2", "99999x1", "32768x32768"] {
            assert!(parse_resolution(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn threads_have_an_end() {
        assert_eq!([parse_threads("0"), parse_threads("1024")], [Ok(0), Ok(1024)]);
        for bad in ["1025", "1000000", "-1", "99999999999999999999"] {
            assert!(parse_threads(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn limits_have_names_and_units() {
        assert_eq!(parse_limit("surfaces=2000000"), Ok((Limit::Surfaces, 2_000_000)));
        assert_eq!(parse_limit("memory=2G"), Ok((Limit::Memory, 2_000_000_000)));
        assert_eq!(parse_limit("pixels=300k"), Ok((Limit::Pixels, 300_000)));
        for bad in ["surfaces", "faces=3", "bytes=", "bytes=-1", "bytes=1T", "bytes=99999999999G"] {
            assert!(parse_limit(bad).unwrap_err().contains("names: bytes, memory,"), "{bad}");
        }
    }
}
