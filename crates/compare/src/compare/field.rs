//! Refusing scenes and methods that do not go together, before any work.

use crate::method::suits;
use crate::prepare::Prepared;
use traylib_demos::{Failure, say};
use traylib_integrators::Method;

/// Scenes are known by their names in everything that a comparison leaves.
///
/// # Errors
/// Two have the same.
pub(super) fn check_names(scenes: &[Prepared]) -> Result<(), Failure> {
    for (i, scene) in scenes.iter().enumerate() {
        let name = &scene.loaded.name;
        let Some(first) = scenes[..i].iter().find(|other| other.loaded.name == *name) else {
            continue;
        };
        return Err(Failure::usage(format_args!(
            "`{}` and `{}` would both be called `{name}`: compare each by itself or under \
             another name",
            first.asked, scene.asked
        )));
    }
    Ok(())
}

/// Tells of methods that were `asked` for and find no light of their kind in a scene.
///
/// # Errors
/// Nobody is left.
pub(super) fn check_fit(asked: &[Method], scenes: &[Prepared]) -> Result<(), Failure> {
    for scene in scenes {
        let unfit = asked.iter().filter(|&&method| !suits(method, &scene.facts));
        let unfit: Vec<String> = unfit.map(ToString::to_string).collect();
        if unfit.is_empty() {
            continue;
        }
        let what = format!(
            "{}: {} left out: the scene has no point lights",
            scene.loaded.name,
            unfit.join(", ")
        );
        if unfit.len() == asked.len() {
            return Err(Failure::usage(format_args!("{what}, and nobody else was asked for")));
        }
        say(format_args!("warning: {what}"));
    }
    Ok(())
}
