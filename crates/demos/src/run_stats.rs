//! The work that was done, as JSON.

use crate::VERSION;
use crate::done::Done;
use crate::end::End;
use crate::job::Job;
use crate::memory;
use crate::outcome::Failure;
use crate::recipe;
use crate::say::write_json;
use serde_json::{Value, json};
use std::path::Path;

/// Writes what a job has done to `file`, `-` for standard output, and why it was done by its
/// method if a plan chose that.
///
/// Counters and seconds are of this run; passes, and samples left out, of all from which it
/// went on.
///
/// # Errors
/// It cannot be written.
pub(crate) fn write(
    file: &Path,
    job: &Job<'_>,
    done: &Done,
    end: End,
    why: Option<&Value>,
) -> Result<(), Failure> {
    let Done { statistics, loaded, passes, error, elapsed, before, .. } = done;
    let before = before.unwrap_or_default();
    let camera = loaded.scene.camera();
    let figures = json!({
        "program": job.program,
        "version": VERSION,
        "command": recipe::with_spp(&recipe::command(job, loaded), *passes),
        "scene": loaded.name,
        "resolution": [camera.width(), camera.height()],
        "endedBy": end.words(),
        "spp": passes,
        "sppBefore": before.passes,
        "relativeError": error,
        "totalClockTime": elapsed.as_secs_f64(),
        "rays": {
            "camera": statistics.camera_rays,
            "bounce": statistics.bounce_rays,
            "shadow": statistics.shadow_rays,
        },
        "paths": { "camera": statistics.camera_paths, "light": statistics.light_paths },
        "rejectedSamples": statistics.rejected + before.rejected,
        "peakMemory": memory::peak(),
        "plan": why,
        "warnings": loaded.warnings.iter().map(ToString::to_string).collect::<Vec<_>>(),
    });
    write_json(file, &figures)
}
