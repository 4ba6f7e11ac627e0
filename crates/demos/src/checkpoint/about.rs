//! The description of a rendering in its film.

use crate::VERSION;
use crate::job::Job;
use crate::plan::Plan;
use crate::recipe;
use crate::shard::Shard;
use crate::window_options;
use traylib_integrators::{Method, Statistics};
use traylib_io::{FilmAbout, Loaded, PictureFrame, PictureInfo, Tone};

const REVISION: &str = "revision";
const SEED: &str = "seed";
const SCENE: &str = "scene";
const PROGRAM: &str = "program";
const COMMAND: &str = "command";
const EXPOSURE: &str = "exposure";
const TONE: &str = "tone";

/// The note of the frame that the picture is a part of.
const FRAME: &str = "frame";

/// The note of how many passes the whole has, if that is known.
const SPP: &str = "spp";
/// The note of which part it is.
pub(crate) const SHARD: &str = "shard";

/// The names of the counters.
const COUNTERS: [&str; 6] =
    ["camera rays", "bounce rays", "shadow rays", "camera paths", "light paths", REJECTED];
const REJECTED: &str = "rejected samples";

/// Returns the description of a job for its film, before anything is counted.
pub(super) fn about(job: &Job<'_>, loaded: &Loaded, plan: &Plan) -> FilmAbout {
    let options = job.options;
    let pictures = if job.layers > 0 { "techniques" } else { "none" };
    let method =
        job.method.map_or_else(|| job.program.to_string(), |method: Method| method.to_string());
    let camera = loaded.scene.camera();
    let settings = [
        (REVISION, VERSION.to_string()),
        ("method", method),
        ("size", format!("{}x{}", camera.width(), camera.height())),
        (SCENE, format!("{:016x}", loaded.scene.content_hash())),
        (SEED, options.seed.to_string()),
        ("sampler", options.sampler.to_string()),
        ("further pictures", pictures.to_string()),
    ];
    let notes = [
        (SCENE, Some(loaded.name.clone())),
        (PROGRAM, Some(job.program.to_string())),
        (COMMAND, Some(recipe::command(job, loaded))),
        (EXPOSURE, Some(loaded.settings.exposure.to_string())),
        (TONE, (options.tone != Tone::default()).then(|| options.tone.to_string())),
        (FRAME, window_options::frame(camera).map(frame_text)),
        (SPP, plan.spp.map(|spp| spp.to_string())),
        (SHARD, (plan.shard != Shard::WHOLE).then(|| plan.shard.to_string())),
    ];
    let notes = notes.into_iter().filter_map(|(name, text)| Some((name.to_string(), text?)));
    FilmAbout {
        settings: settings.map(|(name, text)| (name.to_string(), text)).to_vec(),
        notes: notes.collect(),
        counters: counters(&[], Statistics::default()),
    }
}

/// Returns the sums of the counters before and now.
pub(super) fn counters(before: &[(String, u64)], now: Statistics) -> Vec<(String, u64)> {
    let Statistics { camera_rays, bounce_rays, shadow_rays, camera_paths, light_paths, rejected } =
        now;
    let now = [camera_rays, bounce_rays, shadow_rays, camera_paths, light_paths, rejected];
    let sum = |(name, now): (&str, u64)| (name.to_string(), now + counter(before, name));
    COUNTERS.into_iter().zip(now).map(sum).collect()
}

fn counter(counters: &[(String, u64)], name: &str) -> u64 {
    counters.iter().find(|(known, _)| known == name).map_or(0, |(_, counter)| *counter)
}

/// Samples that were left out.
pub(super) fn rejected(about: &FilmAbout) -> u64 {
    counter(&about.counters, REJECTED)
}

fn text<'a>(texts: &'a [(String, String)], name: &str) -> Option<&'a str> {
    texts.iter().find(|(known, _)| known == name).map(|(_, text)| text.as_str())
}

/// A frame in words: its size, and where the picture begins.
fn frame_text(PictureFrame { size, corner }: PictureFrame) -> String {
    format!("{}x{}+{}+{}", size.0, size.1, corner.0, corner.1)
}

fn read_frame(text: &str) -> Option<PictureFrame> {
    let numbers: Result<Vec<u32>, _> = text.split(['x', '+']).map(str::parse).collect();
    let [width, height, x, y] = numbers.ok()?.try_into().ok()?;
    Some(PictureFrame { size: (width, height), corner: (x, y) })
}

/// Returns the number of passes of the whole, if the film says it.
pub(crate) fn spp(about: &FilmAbout) -> Option<u32> {
    text(&about.notes, SPP)?.parse().ok()
}

/// Returns the part that the film is of, if it says it.
pub(crate) fn shard(about: &FilmAbout) -> Option<Shard> {
    text(&about.notes, SHARD)?.parse().ok()
}

/// Returns the description of a picture made of a film: the same as that of the program.
pub(crate) fn picture_info(about: &FilmAbout, passes: u32) -> PictureInfo {
    let note = |name| text(&about.notes, name).unwrap_or_default().to_string();
    let setting = |name| text(&about.settings, name).unwrap_or_default();
    PictureInfo {
        exposure: note(EXPOSURE).parse().unwrap_or(1.0),
        tone: note(TONE).parse().unwrap_or_default(),
        program: format!("TrayLib {}", setting(REVISION)),
        integrator: note(PROGRAM),
        command: recipe::with_spp(&note(COMMAND), passes),
        scene: note(SCENE),
        seed: setting(SEED).parse().unwrap_or(0),
        spp: passes.into(),
        rejected_samples: rejected(about),
        frame: text(&about.notes, FRAME).and_then(read_frame),
    }
}
