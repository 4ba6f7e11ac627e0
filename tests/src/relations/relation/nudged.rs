//! Lights on solids: rounding may decide on which side of the surface they are, once for
//! the whole picture. Of a solid one side is seen, so that a light which shines on both
//! is, too, as good as one off the surface.

use super::{Subject, alike};
use crate::methods;
use crate::relations::judge::{Claim, Law};
use crate::relations::render::{Estimator, Trouble};
use crate::relations::scene::{DrawnScene, Light};

/// The distance by which a light is moved, as a part of the size of its surface; ten times as far
/// as it may be off it.
const NUDGE: f32 = 1e-5;

/// Part of the light by which the horizon of a nudged light may matter: how far it
/// reaches down grows with the root of the nudge, so four times as much tells.
const HORIZON: f64 = 0.01;

/// The picture is that of the light a little off the surface, to that side to which
/// it is nearer.
pub(super) fn claims(subject: &Subject<'_>) -> Result<Vec<Claim>, Trouble> {
    let estimator = Estimator::Method(methods::DIRECT_LIGHT);
    let Some(sides) = off_the_surface(subject.drawn, NUDGE) else { return Ok(Vec::new()) };
    let further = off_the_surface(subject.drawn, 4.0 * NUDGE).unwrap_or_else(|| sides.clone());
    let mean = |scene: &DrawnScene| {
        let cells = subject.workshop.render(&*subject.build(scene)?, estimator, 1, 16)?;
        Ok::<f64, Trouble>(cells.values[0].iter().sum())
    };
    let here = mean(subject.drawn)?;
    let [front, back] = [mean(&sides[0])?, mean(&sides[1])?];
    let nearer = usize::from((back - here).abs() < (front - here).abs());
    let [near, far] = [[front, back][nearer], mean(&further[nearer])?];
    if (far - near).abs() > HORIZON * near {
        return Ok(Vec::new());
    }
    let what = "a light on a surface is on one side of it";
    let scenes = [subject.drawn, &sides[nearer]];
    Ok(vec![alike(scenes, subject.workshop, estimator, what, Law::SameMean(0.03))?])
}

/// The scene with its first light that lies on a surface moved to either side.
fn off_the_surface(scene: &DrawnScene, nudge: f32) -> Option<[DrawnScene; 2]> {
    let normal = |light: &Light| scene.solid_surface_at(light.position, 0.1 * NUDGE);
    let (index, step) = scene.lights.iter().enumerate().find_map(|(i, l)| Some((i, normal(l)?)))?;
    Some([nudge, -nudge].map(|nudge| {
        let mut moved = scene.clone();
        moved.lights[index].position += step * nudge;
        moved
    }))
}
