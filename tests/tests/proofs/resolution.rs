//! Weights do not know how many pixels a picture has: each pixel brings a path from the camera
//! and one from the lights, so that the odds of all techniques stay what they are.

use std::ops::ControlFlow;
use traylib_integrators::{Bdpt, Control, Report, Settings, Technique, render};
use traylib_scene::{Camera, CameraSettings, Scene};
use traylib_statistics::{Sample, welch};
use traylib_tests::findings::{Finding, settle};
use traylib_tests::still_life::still_life;

/// The probability that a right program fails by chance.
const LEVEL: f64 = 1e-5;
/// Renderings of either size, each with numbers of its own.
const RENDERINGS: u64 = 16;

/// The share that splats have of all light, in several renderings.
fn shares_of_splats(scene: &Scene, passes: u32) -> Sample {
    let bdpt = Bdpt { report: Report::Techniques, ..Bdpt::default() };
    let share = |seed| {
        let settings = Settings { spp: passes, seed, ..Settings::default() };
        let control = Control::default();
        let rendering =
            render(scene, &bdpt, &settings, &control, &mut |_| ControlFlow::Continue(())).unwrap();
        let (mut splats, mut all) = (0.0, 0.0);
        for (layer, picture) in rendering.film.develop_layers() {
            let technique = Technique::of_layer(layer);
            if technique.weighted {
                let light: f64 = picture.values().iter().map(|pixel| f64::from(pixel.g)).sum();
                all += light;
                splats += if technique.t == 1 { light } else { 0.0 };
            }
        }
        splats / all
    };
    Sample::of(&(0..RENDERINGS).map(share).collect::<Vec<_>>())
}

fn resized(scene: &Scene, [width, height]: [u32; 2]) -> Scene {
    let settings = CameraSettings { width, height, ..scene.camera().settings() };
    scene.seen_by(Camera::new(settings).unwrap())
}

/// As many paths of either kind fall into few pixels as into many.
#[test]
fn splats_have_the_same_share_at_any_resolution() {
    let scene = still_life(1.0);
    let few = shares_of_splats(&resized(&scene, [8, 6]), 100);
    let many = shares_of_splats(&resized(&scene, [40, 30]), 4);
    let p = welch(&few, &many);
    settle(&[Finding {
        claim: "splats have the same share of the light on 48 pixels and on 1200".to_string(),
        statistic: format!("shares {:.4} and {:.4}, p = {p:.2e}", few.mean, many.mean),
        level: Some(LEVEL),
        samples: 2 * RENDERINGS * 4800,
        holds: p > LEVEL && few.mean > 1e-3,
    }]);
}
