//! A lamp outside of a closed room: nothing changes within, however strong it is.

use super::who::{OUTSHONE, RARITY, part, sees};
use super::{Subject, name, side};
use crate::methods;
use crate::relations::draw::Dice;
use crate::relations::judge::{Claim, Law, Numbers, Side};
use crate::relations::render::{Estimator, Trouble};
use crate::relations::scene::{DrawnScene, Material, Object, Shape};
use std::sync::Arc;
use traylib_geometry::{Ray, Sides};
use traylib_math::{Rgb, Vec3};
use traylib_scene::Scene;

/// The scene with a ball outside that shines with up to 10¹⁰ times the power of all
/// that is within, or a good deal less.
pub(super) fn claims(subject: &Subject<'_>, dice: &mut Dice) -> Result<Vec<Claim>, Trouble> {
    let drawn = subject.drawn;
    if drawn.objects.iter().any(|object| object.sides == Sides::Front)
        || !is_closed(&subject.built.scene)
    {
        return Ok(Vec::new());
    }
    // Walks from lamps need most that lamps are chosen well.
    let others = [methods::COMBINED, methods::BDPT];
    let method = if dice.chance(0.6) { methods::PARTICLE } else { dice.pick(&others) };
    if !sees(subject, method) {
        return Ok(Vec::new());
    }
    let estimator = Estimator::Method(method);
    let lit = with_outsider(drawn, &subject.built.scene, dice);
    let built = Arc::new(subject.workshop.build(&lit)?);
    let within = part(drawn, &subject.built, estimator);
    let mut with = part(&lit, &built, estimator);
    // It takes choices away, but for what is every lamp's due.
    let lamps = built.scene.lights().len() as f64;
    with.brightest = within.brightest * (RARITY * lamps).max(OUTSHONE);
    with.is_rare = true;
    Ok(vec![Claim {
        what: format!("a lamp outside changes nothing, {}", name(estimator)),
        left: side(drawn, &subject.built, estimator),
        right: Side::Rendered(vec![with]),
        flipped: false,
        factor: 1.0,
        law: Law::SameMean(2e-5),
        numbers: Numbers::Own,
    }])
}

/// Tells whether nothing gets out: in every direction there is something opaque.
fn is_closed(scene: &Scene) -> bool {
    let mut dice = Dice::new(0, 0);
    (0..400).all(|_| {
        let mut ray = Ray::new(scene.camera().position(), dice.direction());
        for _ in 0..20 {
            let Some(point) = scene.intersect(&ray) else { return false };
            let refracts = point.model.has_delta_part() && point.model.transmits();
            if point.through == Rgb::BLACK && !point.model.transmits() && !refracts {
                return true;
            }
            ray.origin = point.site.ray_origin(ray.direction);
        }
        false
    })
}

fn with_outsider(drawn: &DrawnScene, scene: &Scene, dice: &mut Dice) -> DrawnScene {
    let reach = drawn.reach();
    let far = reach * 10.0_f32.powf(dice.between(0.7, 6.0));
    let radius = 0.1 * far;
    let power: f32 = scene.lights().iter().map(|light| light.power().luminance()).sum();
    let radiance = power * 10.0_f32.powf(dice.between(-2.0, 10.0)) / (radius * radius);
    let shape = Shape::Sphere { centre: dice.axis() * far, radius, inward: false };
    let (emission, material) = (Vec3::splat(radiance), Material::grey(0.0));
    let mut lit = drawn.clone();
    lit.objects.push(Object { shape, material, emission, sides: Sides::Both });
    lit
}
