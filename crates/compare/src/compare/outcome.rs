//! From what was done on a scene to what is told and shown of it.

use crate::judge::{Entry, doubted_by, judge, no_verdict, verdict, withhold};
use crate::picture::single;
use crate::pictures::ScenePictures;
use crate::prepare::Prepared;
use crate::reference::Reference;
use crate::results::{LengthShare, OutsidePoint, SceneResults, Verdict};
use traylib_demos::say;
use traylib_integrators::{Bdpt, Integrator, Technique};
use traylib_math::{Grid, Rgb};
use traylib_scene::Light;

/// Keeps those with runs enough to tell anything, and says who has not.
pub(super) fn finished(scene: &str, entries: Vec<Entry>) -> Vec<Entry> {
    let (finished, few): (Vec<Entry>, Vec<Entry>) =
        entries.into_iter().partition(|entry| entry.records.len() > 1);
    if !few.is_empty() {
        let names: Vec<String> = few.iter().map(|entry| entry.method.to_string()).collect();
        say(format_args!(
            "note: {scene}: without two runs yet, and shown only then: {}",
            names.join(", ")
        ));
    }
    finished
}

/// The pictures of a scene.
pub(super) fn shown(
    prepared: &Prepared,
    reference: &Reference,
    entries: &[Entry],
    outside: Vec<Grid<Rgb>>,
    techniques: Vec<(Technique, Grid<Rgb>)>,
) -> ScenePictures {
    ScenePictures {
        exposure: prepared.loaded.settings.exposure,
        reference: single(&reference.picture),
        methods: entries.iter().filter_map(|entry| entry.pictures.first().map(single)).collect(),
        errors: entries.iter().map(|entry| entry.error_map(reference)).collect(),
        outside,
        techniques,
    }
}

/// The numbers of a scene; `None` if no method has any.
pub(super) fn told(
    prepared: &Prepared,
    mut reference: Reference,
    entries: &[Entry],
    mut outside: Vec<OutsidePoint>,
    lengths: Vec<LengthShare>,
) -> Option<SceneResults> {
    let mut methods = judge(entries, &reference, prepared.facts);
    if let Some(name) = doubted_by(entries, &methods, &reference) {
        reference.results.doubted_by = Some(name.to_string());
        withhold(&mut methods);
        for point in &mut outside {
            point.solid = false;
        }
    }
    let verdict = verdict(&methods, &reference.results)?;
    Some(SceneResults { methods, outside, lengths, ..told_alone(prepared, reference, verdict) })
}

/// Tells the outcome where nothing could be held against the reference.
pub(super) fn told_without(prepared: &Prepared, reference: Reference, why: &str) -> SceneResults {
    // Whoever renders a reference sees all that any method does.
    let rendered = reference.results.agreement.is_some();
    let unseen = rendered.then(|| Bdpt::default().blind_spots(&prepared.facts));
    let unseen: Vec<String> = unseen.into_iter().flatten().map(|s| s.to_string()).collect();
    let verdict = no_verdict(why, &unseen, &reference.results);
    told_alone(prepared, reference, verdict)
}

fn told_alone(prepared: &Prepared, reference: Reference, verdict: Verdict) -> SceneResults {
    let scene = &prepared.loaded.scene;
    let points = scene.lights().iter().filter(|light| Light::is_point(light)).count();
    SceneResults {
        name: prepared.loaded.name.clone(),
        width: scene.camera().width(),
        height: scene.camera().height(),
        primitives: scene.primitive_count() as u64,
        area_lights: (scene.lights().len() - points) as u64,
        point_lights: points as u64,
        load_seconds: prepared.load_seconds,
        scene_bytes: prepared.bytes,
        epsilon: reference.epsilon,
        reference: reference.results,
        verdict,
        methods: Vec::new(),
        outside: Vec::new(),
        lengths: Vec::new(),
    }
}
