//! A lamp and a sensor of the same kind change places, and the sensor finds the same.
//!
//! Both are plates of one material. As much of the light of the first as leaves the
//! second leaves the first if the second is the lamp: transport is symmetric where
//! surfaces reflect as they do with light going the other way (Veach, *Robust Monte
//! Carlo Methods for Light Transport Simulation*, 1997, sections 3.7 and 4.A). The
//! camera stands right before a plate and sees all of it evenly, since the film is
//! parallel to it.

use super::who::{part, sees};
use super::{Subject, name};
use crate::methods;
use crate::relations::draw::Dice;
use crate::relations::judge::{Claim, Law, Numbers, Side};
use crate::relations::render::{Estimator, Trouble};
use crate::relations::scene::{Base, Camera, DrawnScene, Material, Object, Shape};
use traylib_geometry::{Ray, Sides};
use traylib_math::Vec3;
use traylib_scene::Scene;

/// Between a plate and the camera before it, in units of the plate's side.
const NEAR: f32 = 0.25;

/// The number of times that room for a plate is looked for.
const TRIES: u32 = 20;

/// A square plate: its middle, half of either side, and its normal, all in metres.
#[derive(Clone, Copy)]
struct Plate {
    centre: Vec3,
    half: [Vec3; 2],
    normal: Vec3,
}

/// Claims by a method each for either place.
pub(super) fn claims(subject: &Subject<'_>, dice: &mut Dice) -> Result<Vec<Claim>, Trouble> {
    let mut scene = subject.drawn.clone();
    scene.lights.clear();
    scene.sky = None;
    scene.objects.iter_mut().for_each(reciprocal);
    // From lamp to plate, on, and into the camera.
    scene.max_depth = scene.max_depth.map(|longest| longest.max(3));
    let empty = &subject.built.scene;
    let first = (0..TRIES).find_map(|_| Plate::somewhere(empty, dice));
    let second = (0..TRIES).find_map(|_| Plate::somewhere(empty, dice));
    let (Some(first), Some(second)) = (first, second) else { return Ok(Vec::new()) };
    let mut parts = Vec::new();
    for [lamp, sensor] in [[first, second], [second, first]] {
        let lit = lit(&scene, lamp, sensor);
        let own = Subject::new(&lit, subject.workshop)?;
        if !lit.is_clear() || !sensor.is_seen(&own.built.scene) || !lamp.is_seen(&own.built.scene) {
            return Ok(Vec::new());
        }
        let methods = methods::WALKING.into_iter().filter(|&method| sees(&own, method));
        let estimator = Estimator::Method(dice.pick(&methods.collect::<Vec<_>>()));
        parts.push((part(&lit, &own.built, estimator), estimator));
    }
    let [(left, by), (right, by_other)] = [parts.remove(0), parts.remove(0)];
    Ok(vec![Claim {
        what: format!("lamp and sensor change places, {} and {}", name(by), name(by_other)),
        left: Side::Rendered(vec![left]),
        right: Side::Rendered(vec![right]),
        flipped: false,
        factor: f64::from(first.area() / second.area()),
        law: Law::MeanOfAll(2e-5),
        numbers: Numbers::Own,
    }])
}

/// Makes it dark, there from both sides, and its reflection symmetric: with normals
/// of its own alone, and with no holes in glass, within which light is denser.
fn reciprocal(object: &mut Object) {
    object.emission = Vec3::ZERO;
    object.sides = Sides::Both;
    object.material.bump = None;
    if let Shape::Mesh(mesh) = &mut object.shape {
        mesh.normals = None;
    }
    if matches!(object.material.base, Base::Glass(_)) {
        object.material.opacity = None;
    }
}

/// The scene with both plates, one of which shines, seen from before the other.
fn lit(scene: &DrawnScene, lamp: Plate, sensor: Plate) -> DrawnScene {
    let mut lit = scene.clone();
    lit.objects.push(sensor.object());
    lit.objects.push(Object { emission: Vec3::ONE, ..lamp.object() });
    lit.camera = Camera { pixels: scene.camera.pixels, ..sensor.camera() };
    lit
}

impl Plate {
    /// On the way from the camera to something that it sees.
    fn somewhere(scene: &Scene, dice: &mut Dice) -> Option<Self> {
        let from = scene.camera().position();
        let direction = dice.direction();
        let point = scene.intersect(&Ray::new(from, direction))?;
        let away = (point.site.position - from).length();
        let normal = if dice.chance(0.5) { dice.axis() } else { dice.direction() };
        let (u, v) = normal.any_orthonormal_pair();
        let half = away * dice.between(0.05, 0.2);
        let centre = from + direction * away * dice.between(0.2, 0.8);
        // Far from the origin the camera would stand in its plate.
        if half < 1e-3 * centre.length() {
            return None;
        }
        Some(Self { centre, half: [u * half, v * half], normal })
    }

    fn area(&self) -> f32 {
        4.0 * self.half[0].length() * self.half[1].length()
    }

    fn object(&self) -> Object {
        let [u, v] = self.half;
        let (u, v) = if u.cross(v).dot(self.normal) > 0.0 { (u, v) } else { (v, u) };
        Object {
            shape: Shape::Quad([self.centre - u - v, 2.0 * u, 2.0 * v]),
            material: Material::grey(0.5),
            emission: Vec3::ZERO,
            sides: Sides::Both,
        }
    }

    /// The camera whose film the plate just fills.
    fn camera(&self) -> Camera {
        Camera {
            position: self.eye(),
            target: self.centre,
            up: self.half[0],
            fov: 2.0 * (0.5 / NEAR).atan().to_degrees(),
            pixels: 1,
        }
    }

    fn eye(&self) -> Vec3 {
        self.centre + self.normal * (2.0 * self.half[0].length() * NEAR)
    }

    /// Tells whether nothing stands between it and its camera, at so many points.
    fn is_seen(&self, scene: &Scene) -> bool {
        const POINTS: u8 = 9;
        let share = |i: u8| 1.99 * (f32::from(i) / f32::from(POINTS - 1) - 0.5);
        (0..POINTS * POINTS).all(|i| {
            let [u, v] = self.half;
            let on = self.centre + u * share(i / POINTS) + v * share(i % POINTS);
            let met = scene.intersect(&Ray::new(self.eye(), on - self.eye()));
            met.is_some_and(|point| (point.site.position - on).length() < 1e-3 * u.length())
        })
    }
}
