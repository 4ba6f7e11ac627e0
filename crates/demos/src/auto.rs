//! The method that a plan chooses, and what it says of its choice.

mod tables;

use crate::explain::Explain;
use crate::job::Job;
use crate::outcome::Failure;
use crate::say::{STANDARD_OUTPUT, say, tell, write_json};
use serde_json::Value;
use std::path::Path;
use tables::{as_json, as_text};
use traylib_integrators::planner::{Choice, Plan, Request, plan};
use traylib_integrators::{Control, Method, Settings};
use traylib_io::Loaded;

/// The job with the method that is to render it, if that was left to a plan, and then also why
/// it was chosen.
///
/// # Errors
/// The system refuses threads, or standard output the explanation.
pub(crate) fn planned<'a>(
    job: &Job<'a>,
    loaded: &Loaded,
) -> Result<(Job<'a>, Option<Value>), Failure> {
    let Some(asked) = job.method else { return Ok((*job, None)) };
    let options = job.options;
    let settings = Settings {
        // Of a rendering that time ends nobody knows how long it will be.
        spp: options.spp.unwrap_or(loaded.settings.spp),
        seed: options.seed,
        threads: options.threads,
        points: options.sampler,
    };
    let Some(request) = Request::of(asked, &settings) else { return Ok((*job, None)) };
    // Whoever interrupts now ends the program at once: there is no work to keep.
    let plan = plan(&loaded.scene, &request, &Control::default()).map_err(Failure::output)?;
    let plan = plan.ok_or_else(|| Failure::output("the plan was given up"))?;
    if !options.quiet {
        say(format_args!("plan: {}", in_a_line(&plan)));
    }
    match job.explain {
        Some(Explain::Text) => as_text(&plan).lines().try_for_each(tell)?,
        Some(Explain::Json) => write_json(Path::new(STANDARD_OUTPUT), &as_json(&plan))?,
        None => {}
    }
    Ok((Job { method: Some(plan.method), ..*job }, Some(as_json(&plan))))
}

/// Names the method that was chosen, and by how much it is ahead of all techniques together.
fn in_a_line(plan: &Plan) -> String {
    let Some(evidence) = &plan.evidence else {
        return format!("{}, as the picture is too small to choose", plan.method);
    };
    let whole = evidence.choices.iter().find(|choice| is_whole(choice.method));
    let best = evidence.choices.first().map_or(f64::INFINITY, Choice::measured);
    let sooner = whole.map(|whole| whole.measured() / best).filter(|sooner| *sooner > 1.0);
    let by = sooner.map(|sooner| format!(", {sooner:.2} times sooner than bdpt by trial"));
    format!("{}{}", plan.method, by.unwrap_or_default())
}

/// Tells whether it is bidirectional tracing by all techniques, up to any length.
fn is_whole(method: Method) -> bool {
    method.up_to(None) == Method::BDPT
}
