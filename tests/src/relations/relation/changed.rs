//! The scene in another form: the same light.

use super::{Subject, alike};
use crate::programs::Program;
use crate::relations::draw::Dice;
use crate::relations::form::cut;
use crate::relations::form::motion::Motion;
use crate::relations::judge::{Claim, Law};
use crate::relations::render::{Estimator, Trouble};
use crate::relations::scene::{DrawnScene, Object, Shape};
use traylib_math::glam::{DMat3, DVec3};

/// What rounding may shift where random numbers fall alike: the few paths that meet
/// an edge on the other side.
const NEARLY: Law = Law::SameMean(2e-5);
/// What it may shift where they do not.
const ROUGHLY: Law = Law::SameMean(5e-5);

/// What is done to the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Change {
    /// Moved by halves of a metre.
    MovedByHalves,
    /// Moved by any length.
    Moved,
    /// Axes exchanged and turned round, pictures not mirrored.
    QuarterTurned,
    /// Turned by any angle about any axis.
    Turned,
    /// Scaled by a power of two.
    ScaledByPowerOfTwo,
    /// Scaled by any factor.
    Scaled,
    /// Left for right.
    Mirrored,
    /// The last object first.
    Backwards,
    /// Boxes as six quads each.
    BoxesAsQuads,
    /// Quads as two triangles each.
    QuadsAsTriangles,
    /// Meshes as triangles.
    MeshesAsTriangles,
    /// Triangles as meshes.
    TrianglesAsMeshes,
    /// Lamps in two pieces.
    LampsInTwo,
    /// Twice, four times … as bright.
    Brighter,
}

/// A scene in another form.
struct Changed {
    scene: DrawnScene,
    law: Law,
    flipped: bool,
    /// In words.
    how: String,
}

impl Change {
    /// All of them.
    pub const ALL: [Self; 14] = [
        Self::MovedByHalves,
        Self::Moved,
        Self::QuarterTurned,
        Self::Turned,
        Self::ScaledByPowerOfTwo,
        Self::Scaled,
        Self::Mirrored,
        Self::Backwards,
        Self::BoxesAsQuads,
        Self::QuadsAsTriangles,
        Self::MeshesAsTriangles,
        Self::TrianglesAsMeshes,
        Self::LampsInTwo,
        Self::Brighter,
    ];

    /// The other form; `None` where there is none, or where rounding may decide
    /// what is seen.
    fn apply(self, scene: &DrawnScene, dice: &mut Dice) -> Option<Changed> {
        let changed = |how: String, scene: DrawnScene, law: Law| {
            Some(Changed { scene, law, flipped: false, how })
        };
        let moved = |motion: Motion, law: Law| {
            let Motion { scale, shift, .. } = motion;
            let how = format!("scaled by {scale:e}, moved by {shift}");
            changed(how, motion.scene(scene), law)
        };
        let cut = |pieces: Option<DrawnScene>| changed(format!("{self:?}"), pieces?, ROUGHLY);
        let is_clear = scene.is_clear();
        let size = f64::from((scene.camera.target - scene.camera.position).length());
        match self {
            Self::MovedByHalves if is_clear => {
                let steps = [0; 3].map(|_| f64::from(dice.below(9)) - 4.0);
                let unit = (0.5 * size).log2().floor().exp2();
                moved(Motion::shift(DVec3::from_array(steps) * unit), NEARLY)
            }
            Self::Moved if is_clear => {
                moved(Motion::shift(dice.direction().as_dvec3() * size), NEARLY)
            }
            Self::QuarterTurned if is_clear => {
                let scene = boxes_with_pictures_cut(scene);
                let turn = Motion::turn(quarter_turn(dice));
                changed(format!("turned by {}", turn.turn), turn.scene(&scene), ROUGHLY)
            }
            Self::Turned if is_clear => {
                let scene = cut::boxes_as_quads(scene).unwrap_or_else(|| scene.clone());
                let angle = f64::from(dice.between(0.1, 3.0));
                let turn = DMat3::from_axis_angle(dice.direction().as_dvec3().normalize(), angle);
                changed(format!("turned by {turn}"), Motion::turn(turn).scene(&scene), ROUGHLY)
            }
            Self::ScaledByPowerOfTwo => {
                let power = dice.pick(&[-40, -14, -3, -1, 1, 2, 7, 20, 33]);
                moved(Motion::scale(f64::from(power).exp2()), Law::SameBits)
            }
            Self::Scaled if is_clear => {
                moved(Motion::scale(f64::from(dice.between(0.1, 0.9))), NEARLY)
            }
            Self::Mirrored if is_clear && !has_quads_with_pictures(scene) => {
                let mirror = Motion::turn(DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0)));
                let how = String::from("left for right");
                Some(Changed { scene: mirror.scene(scene), law: ROUGHLY, flipped: true, how })
            }
            Self::Backwards if is_clear => cut(cut::backwards(scene)),
            Self::BoxesAsQuads => {
                changed(format!("{self:?}"), cut::boxes_as_quads(scene)?, Law::SameBits)
            }
            Self::QuadsAsTriangles if is_clear => cut(cut::quads_as_triangles(scene)),
            Self::MeshesAsTriangles if is_clear => cut(cut::meshes_as_triangles(scene)),
            Self::TrianglesAsMeshes if is_clear => cut(cut::triangles_as_meshes(scene)),
            Self::LampsInTwo if is_clear => cut(cut::lamps_in_two(scene)),
            // What rounding may decide is left out.
            Self::MovedByHalves
            | Self::Moved
            | Self::QuarterTurned
            | Self::Turned
            | Self::Scaled
            | Self::Mirrored
            | Self::Backwards
            | Self::QuadsAsTriangles
            | Self::MeshesAsTriangles
            | Self::TrianglesAsMeshes
            | Self::LampsInTwo
            | Self::Brighter => None,
        }
    }
}

fn has_quads_with_pictures(scene: &DrawnScene) -> bool {
    scene.objects.iter().any(|object| {
        matches!(object.shape, Shape::Quad(_) | Shape::Box(_)) && object.material.has_maps()
    })
}

/// By a program or two.
pub(super) fn claims(
    change: Change,
    subject: &Subject<'_>,
    dice: &mut Dice,
) -> Result<Vec<Claim>, Trouble> {
    if change == Change::Brighter {
        return brighter(subject, dice);
    }
    let Some(Changed { scene, law, flipped, how }) = change.apply(subject.drawn, dice) else {
        return Ok(Vec::new());
    };
    let programs = [
        Program::PureMc,
        Program::Combined,
        Program::Strict,
        Program::BdptPower,
        Program::Particle,
    ];
    // Where walks from lamps see other surfaces, what they lack depends on weights.
    let alike_from_both_ends = subject.drawn.fronts_are_alike() || law == Law::SameBits;
    let program = dice.pick(if alike_from_both_ends { &programs } else { &programs[..3] });
    let claim = alike(subject, &scene, Estimator::Program(program), &how, law)?;
    Ok(vec![Claim { flipped, ..claim }])
}

/// All lamps a quarter as bright: a quarter of the picture, exactly.
fn brighter(subject: &Subject<'_>, dice: &mut Dice) -> Result<Vec<Claim>, Trouble> {
    let mut scene = subject.drawn.clone();
    scene.objects.iter_mut().for_each(|object| object.emission *= 0.25);
    scene.lights.iter_mut().for_each(|light| light.intensity *= 0.25);
    let program = dice.pick(&[Program::Combined, Program::BdptPower, Program::Particle]);
    let law = Law::SameMean(1e-9);
    let claim = alike(subject, &scene, Estimator::Program(program), "a quarter as bright", law)?;
    Ok(vec![Claim { factor: 4.0, ..claim }])
}

/// The quads of boxes with pictures keep their edges, which boxes name anew.
fn boxes_with_pictures_cut(scene: &DrawnScene) -> DrawnScene {
    let has = |object: &Object| matches!(object.shape, Shape::Box(_)) && object.material.has_maps();
    if !scene.objects.iter().any(has) {
        return scene.clone();
    }
    cut::boxes_as_quads(scene).unwrap_or_else(|| scene.clone())
}

/// One of the 24 rotations of a cube.
fn quarter_turn(dice: &mut Dice) -> DMat3 {
    let first = dice.axis().as_dvec3();
    let second = loop {
        let second = dice.axis().as_dvec3();
        if first.dot(second) == 0.0 {
            break second;
        }
    };
    DMat3::from_cols(first, second, first.cross(second))
}
