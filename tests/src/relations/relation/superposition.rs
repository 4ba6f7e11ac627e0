//! The light of all lamps is the sum of that of each.

use super::who::{RARITY, part, sees};
use super::{Subject, name};
use crate::methods;
use crate::relations::draw::Dice;
use crate::relations::judge::{Claim, Law, Numbers, Part, Side};
use crate::relations::render::{Estimator, Trouble};
use crate::relations::scene::DrawnScene;
use traylib_integrators::Method;
use traylib_math::Vec3;

/// More lamps than this take too long.
const MOST: usize = 4;

/// For a first idea of how much light each lamp brings.
const PASSES: u32 = 8;

/// Claims by one method.
pub(super) fn claims(subject: &Subject<'_>, dice: &mut Dice) -> Result<Vec<Claim>, Trouble> {
    let single = each_alone(subject.drawn);
    // Of two surfaces in one plane the lamp is met, while it is one.
    if !(2..=MOST).contains(&single.len()) || subject.drawn.has_coplanar() {
        return Ok(Vec::new());
    }
    let methods: Vec<Method> =
        methods::WALKING.into_iter().filter(|&method| sees(subject, method)).collect();
    if methods.is_empty() {
        return Ok(Vec::new());
    }
    let method = dice.pick(&methods);
    let estimator = Estimator::Method(method);
    let parts: Result<Vec<Part>, Trouble> =
        single.iter().map(|scene| Ok(part(scene, &subject.build(scene)?, estimator))).collect();
    let parts = parts?;
    let mut whole = part(subject.drawn, &subject.built, estimator);
    if methods::splats_alone(method) {
        whole.brightest = brightest_of_all(subject, &parts)?;
    }
    Ok(vec![Claim {
        what: format!("all lamps = the sum of {}, {}", single.len(), name(estimator)),
        left: Side::Rendered(vec![whole]),
        right: Side::Rendered(parts),
        flipped: false,
        factor: 1.0,
        law: Law::SameMean(2e-5),
        numbers: Numbers::Own,
    }])
}

/// Returns the greatest mean that samples can have, where lamps take turns: those of each lamp
/// alone, as often as it brings light, and brighter by as much as it is rare.
fn brightest_of_all(subject: &Subject<'_>, parts: &[Part]) -> Result<f64, Trouble> {
    let (mut light, mut brightness) = (0.0, 0.0);
    for part in parts {
        let cells = subject.workshop.render(&part.built, part.estimator, 1, PASSES)?;
        let mean = cells.values[0].iter().sum::<f64>() / f64::from(PASSES);
        light += mean;
        brightness += mean * part.brightest;
    }
    // If none brings any, there is nothing to be accused of.
    let mean = if light > 0.0 { brightness / light } else { f64::INFINITY };
    Ok(RARITY * subject.built.scene.lights().len() as f64 * mean)
}

/// The scene with one object that shines, or one light, for each of them.
fn each_alone(scene: &DrawnScene) -> Vec<DrawnScene> {
    let mut dark = scene.clone();
    dark.lights.clear();
    dark.sky = None;
    dark.objects.iter_mut().for_each(|object| object.emission = Vec3::ZERO);
    let lamps = scene.objects.iter().enumerate().filter(|(_, object)| object.is_light());
    let of_objects = lamps.map(|(index, lamp)| {
        let mut single = dark.clone();
        single.objects[index].emission = lamp.emission;
        single
    });
    let of_lights =
        scene.lights.iter().map(|&light| DrawnScene { lights: vec![light], ..dark.clone() });
    let of_sky = scene.sky.iter().map(|sky| DrawnScene { sky: Some(sky.clone()), ..dark.clone() });
    of_objects.chain(of_lights).chain(of_sky).collect()
}
