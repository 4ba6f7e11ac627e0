//! Objects under a sky of radiance 1 that takes all light that arrives.

use super::{Subject, name, side};
use crate::methods;
use crate::relations::draw::Dice;
use crate::relations::judge::{Claim, Law, Numbers, Side};
use crate::relations::render::{Built, Estimator, Trouble};
use crate::relations::scene::{Base, DrawnScene, Lobes, Material, Object, Shape, Sky};
use std::sync::Arc;
use traylib_geometry::{Ray, Sides};
use traylib_integrators::Method;
use traylib_math::Vec3;
use traylib_scene::Scene;

/// The longest path: where most rays get out, none is so long.
const LONGEST: u32 = 1000;

/// Surfaces that lose nothing are not to be seen: every sample of `puremc` is 1,
/// and the mean of other methods.
pub(super) fn white(subject: &Subject<'_>, dice: &mut Dice) -> Result<Vec<Claim>, Trouble> {
    let Some(mut scene) = under_the_sky(subject)? else { return Ok(Vec::new()) };
    scene.objects.iter_mut().for_each(whiten);
    scene.max_depth = Some(LONGEST);
    let built = subject.build(&scene)?;
    let others = [methods::COMBINED, methods::BDPT, methods::BDPT_BALANCE];
    let other = dice.pick(if scene.fronts_are_alike() { &others } else { &others[..1] });
    let claim = |method, bound| as_if_empty("white", (&scene, &built), method, bound);
    let mut claims = vec![claim(methods::PURE_MC, 1e-5), claim(other, 2e-5)];
    if dice.chance(0.5) {
        let endless = without_dome(&scene);
        let built = subject.build(&endless)?;
        let method = dice.pick(&[methods::PURE_MC, other]);
        claims.push(as_if_empty("white and endless", (&endless, &built), method, 2e-5));
    }
    Ok(claims)
}

/// The same under a sky that is infinitely far away.
fn without_dome(scene: &DrawnScene) -> DrawnScene {
    let mut endless = scene.clone();
    endless.objects.retain(|object| !object.is_light());
    DrawnScene { sky: Some(Sky::even(Vec3::ONE)), ..endless }
}

/// Claims that this furnace is not to be seen, up to this part of its light.
fn as_if_empty(
    furnace: &str,
    (scene, built): (&DrawnScene, &Arc<Built>),
    method: Method,
    bound: f64,
) -> Claim {
    let estimator = Estimator::Method(method);
    Claim {
        what: format!("nothing is to be seen in a {furnace} furnace, {}", name(estimator)),
        left: side(scene, built, estimator),
        right: Side::Known(1.0),
        flipped: false,
        factor: 1.0,
        law: Law::SameMean(bound),
        numbers: Numbers::Own,
    }
}

/// Fronts that glow by as much as they do not reflect are not to be seen, whatever
/// their shape: each is a lamp of it.
pub(super) fn glowing(subject: &Subject<'_>, dice: &mut Dice) -> Result<Vec<Claim>, Trouble> {
    let mut scene = subject.drawn.clone();
    scene.lights.clear();
    scene.sky = None;
    scene.max_depth = Some(LONGEST);
    // Light is denser in glass.
    scene.objects.retain(|object| !matches!(object.material.base, Base::Glass(_)));
    if dice.chance(0.4) {
        // Walks from lamps see these alone as walks from the camera do.
        scene.objects.retain(|object| object.shape.is_solid());
    }
    if scene.objects.is_empty() || !scene.is_clear() {
        return Ok(Vec::new());
    }
    scene.objects.iter_mut().for_each(glow);
    let sky = sky(&scene);
    scene.objects.push(sky);
    let built = subject.build(&scene)?;
    let is_translucent =
        |object: &Object| matches!(object.material.base, Base::Sheet(..) | Base::Pane(..));
    let is_opaque = !scene.objects.iter().any(is_translucent);
    // What lets light in through its front alone is not the same from its back.
    let alike = scene.fronts_are_alike() && is_opaque;
    let can_tell = |&method: &Method| {
        // A lamp close behind a sheet lights a spot about as wide as the gap, which samples
        // of its whole area find too rarely: 0.5 % short after 32,768 passes at a gap of
        // 2.4 mm, 0.1 % at ten times that, within the noise at a hundred times.
        (is_opaque || !methods::never_hits(method))
            && (alike || !methods::walks_from_lights(method))
    };
    let methods: Vec<Method> = methods::WALKING.into_iter().filter(can_tell).collect();
    let chosen = [methods::PURE_MC, dice.pick(&methods[1..])];
    let claim = |method| as_if_empty("glowing", (&scene, &built), method, 2e-5);
    Ok(chosen.map(claim).to_vec())
}

/// Gives it a surface of its kind without lobes, of one side, that glows.
fn glow(object: &mut Object) {
    if let Shape::Mesh(mesh) = &mut object.shape {
        mesh.normals = None;
    }
    let (base, albedo) = match object.material.base {
        Base::Lambert(colour) | Base::MaxPhong(colour, _) => (Base::Lambert(colour), colour),
        Base::Phong(lobes) => (Base::Lambert(lobes.diffuse), lobes.diffuse),
        Base::Mirror(mirrored, diffuse) => (Base::Mirror(mirrored, diffuse), mirrored + diffuse),
        Base::Sheet(back, on) => {
            let base = Base::Sheet(Lobes::diffuse(back.diffuse), Lobes::diffuse(on.diffuse));
            (base, back.diffuse + on.diffuse)
        }
        Base::Pane(mirrored, through) => (Base::Pane(mirrored, through), mirrored + through),
        Base::Glass(index) => (Base::Glass(index), Vec3::ONE),
    };
    object.emission = Vec3::ONE - albedo;
    object.sides = Sides::Front;
    let opacity = object.material.opacity.clone();
    object.material = Material { opacity, ..Material::plain(base) };
}

/// Nothing is brighter than the sky.
pub(super) fn no_gain(subject: &Subject<'_>) -> Result<Vec<Claim>, Trouble> {
    let Some(scene) = under_the_sky(subject)? else { return Ok(Vec::new()) };
    let built = subject.build(&scene)?;
    Ok(vec![Claim {
        what: String::from("nothing is brighter than the sky, puremc"),
        left: side(&scene, &built, Estimator::Method(methods::PURE_MC)),
        right: Side::Known(1.0),
        flipped: false,
        factor: 1.0,
        law: Law::AtMost(1e-5),
        numbers: Numbers::Own,
    }])
}

/// The objects of a scene without those that shut its camera in, none of them a
/// lamp: light that never gets out would never be known.
fn under_the_sky(subject: &Subject<'_>) -> Result<Option<DrawnScene>, Trouble> {
    let mut scene = subject.drawn.clone();
    scene.lights.clear();
    scene.sky = None;
    scene.objects.iter_mut().for_each(|object| object.emission = Vec3::ZERO);
    // Light is denser in glass.
    let camera = scene.camera.position;
    scene.objects.retain(|object| {
        let is_glass = matches!(object.material.base, Base::Glass(_));
        let has_holes = object.material.opacity.is_some();
        !is_glass || !object.shape.bounds().contains(camera) && !has_holes
    });
    let extent = |object: &Object| object.shape.bounds().extent().length();
    scene.objects.sort_by(|a, b| extent(a).total_cmp(&extent(b)));
    loop {
        if scene.objects.is_empty() {
            return Ok(None);
        }
        let mut lit = scene.clone();
        lit.objects.push(sky(&scene));
        if is_open(&subject.build(&lit)?.scene) {
            return Ok(Some(lit));
        }
        scene.objects.pop();
    }
}

fn sky(scene: &DrawnScene) -> Object {
    let radius = 2.0 * scene.reach();
    Object {
        shape: Shape::Sphere { centre: Vec3::ZERO, radius, inward: true },
        material: Material::grey(0.0),
        emission: Vec3::ONE,
        sides: Sides::Both,
    }
}

/// Tells whether a quarter of all rays from the camera meet the sky at once.
fn is_open(scene: &Scene) -> bool {
    let mut dice = Dice::new(0, 0);
    let position = scene.camera().position();
    let meets_sky = |direction: Vec3| {
        let point = scene.intersect(&Ray::new(position, direction));
        point.is_some_and(|point| point.light.is_some())
    };
    (0..400).filter(|_| meets_sky(dice.direction())).count() > 100
}

/// Gives it a surface of its kind that loses nothing, and no normals but its own:
/// elsewhere light is lost to the sides on which they disagree.
fn whiten(object: &mut Object) {
    if object.is_light() {
        return;
    }
    if let Shape::Mesh(mesh) = &mut object.shape {
        mesh.normals = None;
    }
    if let Shape::Sphere { inward: true, .. } = object.shape {
        // Of its inside alone it would let light in and not out.
        object.sides = Sides::Both;
    }
    let half = Vec3::splat(0.5);
    let base = match object.material.base {
        Base::Lambert(_) | Base::Phong(_) | Base::MaxPhong(..) => Base::Lambert(Vec3::ONE),
        Base::Mirror(_, diffuse) => Base::Mirror(Vec3::ONE - diffuse, diffuse),
        Base::Sheet(..) => Base::Sheet(Lobes::diffuse(half), Lobes::diffuse(half)),
        Base::Glass(index) => {
            // Of one side alone it would let light in and not out.
            object.sides = Sides::Both;
            Base::Glass(index)
        }
        Base::Pane(reflectance, _) => Base::Pane(reflectance, Vec3::ONE - reflectance),
    };
    // Light that goes straight into glass is not the denser light that is there.
    let is_glass = matches!(base, Base::Glass(_));
    let opacity = object.material.opacity.clone().filter(|_| !is_glass);
    object.material = Material { opacity, ..Material::plain(base) };
}
