//! The command line.

use clap::Parser;
use std::num::NonZeroU32;
use std::path::PathBuf;
use traylib_demos::{VERSION, parse_exposure, parse_limit, parse_resolution, parse_threads};
use traylib_integrators::{Method, PointSet, Trace};
use traylib_io::{Headlight, Limit, LoadOptions, ReadLimits};

const EXAMPLES: &str = "\
Examples:
  realtime                                  four spheres, the scene `spheres`
  realtime cornell --method bdpt            refined while the camera rests
  realtime YOURS.mgf --resolution 800x600   a file of yours
  realtime spheres --frames 100             without a window: how fast is it?

Mouse: left button turns around what is in the middle, right button shifts,
wheel goes nearer. With Shift steps are four times as long.

  W A S D  walk                    arrows     look around
  E Q      up and down             Home       back to the scene's camera
  1 trace  2 puremc  3 directlight  4 bdpt  5 particle
  6 auto: the method that a plan chooses for what is seen
  P        print the camera as a line for a scene file
  F12      write the picture       Escape     end

The title tells frames and rays a second; while the camera rests, samples a
pixel and their estimated error, the root of the mean variance of a pixel over
the mean radiance.

Ends with 0, 2 if the command line was not understood, 3 if a scene cannot be
read or makes no sense, 4 if there is no display or a picture cannot be written,
130 after Ctrl-C.";

/// Shows a scene in a window while you walk through it
#[derive(Clone, Debug, Parser)]
#[command(name = "realtime", version = VERSION, max_term_width = 80, after_long_help = EXAMPLES)]
pub(crate) struct Options {
    /// Scene file, or name of a built-in scene: what the other programs read
    #[arg(default_value = "spheres")]
    pub(crate) scene: String,

    /// What to render by at first: a program and its options, as "bdpt --max-depth 3"; its key
    /// comes back to these
    #[arg(long, value_name = "METHOD", default_value = "trace")]
    pub(crate) method: Method,

    /// Size of the window in pixels [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = parse_resolution)]
    pub(crate) resolution: Option<(u32, u32)>,

    /// Factor on light [default: the scene's]
    #[arg(long, value_name = "FACTOR", value_parser = parse_exposure)]
    pub(crate) exposure: Option<f32>,

    /// Samples per pixel after which a picture is left as it is [default: none]
    #[arg(long, value_name = "N")]
    pub(crate) spp: Option<NonZeroU32>,

    /// Seed of the random numbers: same seed, same picture
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) seed: u64,

    /// Where random numbers come from: `independent`, or `sobol`, whose points fill the space
    /// of paths more evenly
    #[arg(long, value_name = "NAME", default_value_t = PointSet::default())]
    pub(crate) sampler: PointSet,

    /// Threads that cast rays, up to 1024, 0 for one a processor; the picture stays the same
    #[arg(short, long, value_name = "N", default_value_t = 0, value_parser = parse_threads)]
    pub(crate) threads: usize,

    /// Picture that F12 writes, .png, .exr, .hdr, .tga or .pcx; further ones get numbers
    #[arg(short, long, value_name = "FILE", default_value = "realtime.png")]
    pub(crate) outfile: PathBuf,

    /// Without a window: render so many frames of a turn, print how fast that was, and end
    #[arg(long, value_name = "N")]
    pub(crate) frames: Option<NonZeroU32>,

    /// Print errors and what was asked for alone
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// The folder that files included by a scene or MGF file may come from
    /// [default: that of the first file]
    #[arg(long, value_name = "DIR")]
    pub(crate) root: Option<PathBuf>,

    /// Allow more of what files may ask for, as a message names it, as surfaces=2M; may be
    /// repeated
    #[arg(long, value_name = "NAME=N", value_parser = parse_limit)]
    pub(crate) limit: Vec<(Limit, u64)>,
}

impl Options {
    /// Returns the options for reading files otherwise than they say.
    pub(crate) fn load_options(&self, headlight: Headlight) -> LoadOptions<'_> {
        let mut limits = ReadLimits::default();
        self.limit.iter().for_each(|&(limit, value)| limits.set(limit, value));
        let Self { resolution, exposure, .. } = *self;
        LoadOptions { resolution, exposure, root: self.root.as_deref(), headlight, limits }
    }

    /// After how many passes a picture by this method is done: what draws nothing by chance
    /// has one alone.
    pub(crate) fn passes(&self, method: Method) -> u32 {
        if let Method::Trace(Trace { jitter: false }) = method {
            return 1;
        }
        self.spp.map_or(u32::MAX, NonZeroU32::get)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn options_are_sound() {
        Options::command().debug_assert();
    }

    #[test]
    fn a_picture_without_chance_has_one_pass() {
        let options = Options::parse_from(["realtime", "--spp", "9"]);
        assert_eq!((options.scene.as_str(), options.method), ("spheres", Method::TRACE));
        assert_eq!([Method::TRACE, Method::BDPT].map(|method| options.passes(method)), [1, 9]);
    }
}
