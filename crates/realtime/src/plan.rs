//! The plan for a view whose method is left to one.

use crate::stage::Stage;
use crate::view::Wanted;
use std::num::NonZeroU32;
use traylib_demos::Failure;
use traylib_integrators::planner::{Request, plan};
use traylib_integrators::{Control, Method, Settings};
use traylib_scene::Camera;

/// Returns the method that a view is to be rendered by: its own, or the one that a plan chooses
/// for it, as `bdpt --auto` does for the picture of a program; `None` if `control` was cancelled
/// meanwhile.
///
/// # Errors
/// The scene cannot be read any more, or the system refuses threads.
pub(crate) fn planned(
    stage: &Stage,
    wanted: &Wanted,
    control: &Control,
) -> Result<Option<Method>, Failure> {
    let (loaded, options) = (stage.of(wanted.method)?, stage.options());
    let settings = Settings {
        spp: options.spp.map_or(loaded.settings.spp, NonZeroU32::get),
        seed: options.seed,
        threads: options.threads,
        points: options.sampler,
    };
    let Some(request) = Request::of(wanted.method, &settings) else {
        return Ok(Some(wanted.method));
    };
    let camera = Camera::new(wanted.camera).map_err(Failure::scene)?;
    let plan = plan(&loaded.scene.seen_by(camera), &request, control).map_err(Failure::output)?;
    Ok(plan.map(|plan| plan.method))
}
