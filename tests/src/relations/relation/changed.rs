//! The scene in another form: the same light.

use super::{Subject, alike, name, side};
use crate::methods;
use crate::relations::draw::Dice;
use crate::relations::form::exported::{Exported, through_mgf, through_three_ds};
use crate::relations::form::motion::Motion;
use crate::relations::form::{Files, Placement, cut, pictured};
use crate::relations::judge::{Claim, Law, Numbers};
use crate::relations::render::{Estimator, Trouble};
use crate::relations::scene::{DrawnScene, Object, Shape};
use std::sync::Arc;
use traylib_math::glam::{DMat3, DVec3};

/// The shift of means that rounding may cause where random numbers fall alike: the few paths that
/// meet an edge on the other side.
const NEARLY: Law = Law::SameMean(2e-5);
/// The shift that it may cause where they do not.
const ROUGHLY: Law = Law::SameMean(5e-5);

/// Returns the shift that rounding may cause where coordinates are others: each end of the smallest
/// object is known to half a unit in the last place of the largest coordinate, which counts twice
/// in its area.
fn rounded(moved: &DrawnScene) -> Law {
    let of_the_smallest = 2.0 * f32::EPSILON * moved.reach() / moved.finest();
    Law::SameMean(f64::from(of_the_smallest).max(2e-5))
}

/// The changes that are made to a scene.
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
    /// Most of it in an MGF file, in grey.
    ThroughMgf,
    /// Most of it in 3DS files.
    ThroughThreeDs,
    /// In files of shapes that are scaled, turned and moved to where these belong.
    Placed,
    /// Pictures of one colour for colours.
    ColoursAsPictures,
    /// Panes as mirrors with holes.
    PanesAsHoles,
    /// A quarter as bright.
    Brighter,
}

/// A scene in another form.
struct Changed {
    scene: DrawnScene,
    law: Law,
    flipped: bool,
    /// In words.
    how: String,
    /// The scene that it is held against, if not the scene itself.
    before: Option<DrawnScene>,
}

impl Change {
    /// All of them.
    pub const ALL: [Self; 19] = [
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
        Self::ThroughMgf,
        Self::ThroughThreeDs,
        Self::Placed,
        Self::ColoursAsPictures,
        Self::PanesAsHoles,
        Self::Brighter,
    ];

    /// Whether it takes directions elsewhere, where a sky cannot follow that differs by them.
    fn turns(self) -> bool {
        match self {
            Self::QuarterTurned | Self::Turned | Self::Mirrored => true,
            Self::MovedByHalves
            | Self::Moved
            | Self::ScaledByPowerOfTwo
            | Self::Scaled
            | Self::Backwards
            | Self::BoxesAsQuads
            | Self::QuadsAsTriangles
            | Self::MeshesAsTriangles
            | Self::TrianglesAsMeshes
            | Self::LampsInTwo
            | Self::ThroughMgf
            | Self::ThroughThreeDs
            | Self::Placed
            | Self::ColoursAsPictures
            | Self::PanesAsHoles
            | Self::Brighter => false,
        }
    }

    /// The other form; `None` where there is none, or where rounding may decide
    /// what is seen.
    fn apply(self, scene: &DrawnScene, dice: &mut Dice) -> Option<Changed> {
        let has_picture = scene.sky.as_ref().is_some_and(|sky| !sky.is_even());
        if has_picture && self.turns() {
            return None;
        }
        let changed = |how: String, scene: DrawnScene, law: Law| {
            Some(Changed { scene, law, flipped: false, how, before: None })
        };
        let moved = |motion: Motion, law: Law| {
            let Motion { scale, shift, .. } = motion;
            let how = format!("scaled by {scale:e}, moved by {shift}");
            changed(how, motion.scene(scene), law)
        };
        let shifted = |shift: DVec3| {
            let motion = Motion::shift(shift);
            moved(motion, rounded(&motion.scene(scene)))
        };
        let cut = |pieces: Option<DrawnScene>| changed(format!("{self:?}"), pieces?, ROUGHLY);
        let is_clear = scene.is_clear();
        let size = f64::from(stride(scene));
        match self {
            Self::MovedByHalves if is_clear => {
                let steps = [0; 3].map(|_| f64::from(dice.below(9)) - 4.0);
                let unit = (0.5 * size).log2().floor().exp2();
                shifted(DVec3::from_array(steps) * unit)
            }
            Self::Moved if is_clear => shifted(dice.direction().as_dvec3() * size),
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
                // Squares of lengths must not leave single precision, nor what is
                // divided by them.
                let least = (1e-15 / scene.finest()).log2() as i32;
                let power = power.clamp(least, (1e15 / scene.reach()).log2() as i32);
                moved(Motion::scale(f64::from(power).exp2()), Law::SameBits)
            }
            Self::Scaled if is_clear => {
                moved(Motion::scale(f64::from(dice.between(0.1, 0.9))), NEARLY)
            }
            Self::Mirrored if is_clear && !has_quads_with_pictures(scene) => {
                let mirror = Motion::turn(DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0)));
                let how = String::from("left for right");
                Some(Changed {
                    scene: mirror.scene(scene),
                    law: ROUGHLY,
                    flipped: true,
                    how,
                    before: None,
                })
            }
            Self::Backwards if is_clear => cut(cut::backwards(scene)),
            Self::BoxesAsQuads => {
                changed(format!("{self:?}"), cut::boxes_as_quads(scene)?, Law::SameBits)
            }
            Self::QuadsAsTriangles if is_clear => cut(cut::quads_as_triangles(scene)),
            Self::MeshesAsTriangles if is_clear => cut(cut::meshes_as_triangles(scene)),
            Self::TrianglesAsMeshes if is_clear => cut(cut::triangles_as_meshes(scene)),
            Self::LampsInTwo if is_clear => cut(cut::lamps_in_two(scene)),
            Self::ColoursAsPictures => {
                let (plain, pictured) = pictured::colours_as_pictures(scene)?;
                let claim = changed(format!("{self:?}"), pictured, NEARLY)?;
                Some(Changed { before: Some(plain), ..claim })
            }
            Self::PanesAsHoles => {
                let (plain, pictured) = pictured::panes_as_holes(scene)?;
                let claim = changed(format!("{self:?}"), pictured, ROUGHLY)?;
                Some(Changed { before: Some(plain), ..claim })
            }
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
            | Self::ThroughMgf
            | Self::ThroughThreeDs
            | Self::Placed
            | Self::Brighter => None,
        }
    }
}

fn has_quads_with_pictures(scene: &DrawnScene) -> bool {
    scene.objects.iter().any(|object| {
        matches!(object.shape, Shape::Quad(_) | Shape::Box(_)) && object.material.has_maps()
    })
}

/// Claims by a method or two.
pub(super) fn claims(
    change: Change,
    subject: &Subject<'_>,
    dice: &mut Dice,
) -> Result<Vec<Claim>, Trouble> {
    if change == Change::Brighter {
        return brighter(subject, dice);
    }
    if change == Change::ThroughMgf {
        return exported(through_mgf(subject.drawn, "other"), subject, dice, "MGF");
    }
    if change == Change::ThroughThreeDs {
        return exported(through_three_ds(subject.drawn, "other"), subject, dice, "3DS");
    }
    if change == Change::Placed {
        let placement = placement(subject.drawn, dice);
        let how = format!("{placement:?}");
        return exported(placed(subject.drawn, placement), subject, dice, &how);
    }
    let Some(Changed { scene, law, flipped, how, before }) = change.apply(subject.drawn, dice)
    else {
        return Ok(Vec::new());
    };
    let before = before.as_ref().unwrap_or(subject.drawn);
    let estimator = who_may_tell(before, law, dice);
    let claim = alike([before, &scene], subject.workshop, estimator, &how, law)?;
    Ok(vec![Claim { flipped, ..claim }])
}

/// Any method; where walks from lamps see other surfaces than walks from the camera,
/// what they lack depends on weights, and these on where objects are.
fn who_may_tell(scene: &DrawnScene, law: Law, dice: &mut Dice) -> Estimator {
    let any = scene.fronts_are_alike() || law == Law::SameBits;
    let mut methods = methods::beginning_with(&[methods::PURE_MC, methods::COMBINED]);
    // One way to weigh the techniques of `bdpt` is enough.
    methods.retain(|&method| method != methods::BDPT_BALANCE);
    methods.retain(|&method| any || !methods::walks_from_lights(method));
    Estimator::Method(dice.pick(&methods))
}

/// Returns the distance that the camera looks, but, where that is at a sun, no further than leaves
/// the smallest object its digits.
fn stride(scene: &DrawnScene) -> f32 {
    let away = (scene.camera.target - scene.camera.position).length();
    away.min(1000.0 * scene.finest())
}

/// Any scale by a power of two, quarter turns, and a shift by parts of what is seen.
fn placement(scene: &DrawnScene, dice: &mut Dice) -> Placement {
    let mut rotate = [0.0; 3];
    rotate[dice.below(3) as usize] = 90.0 * dice.below(4) as f32;
    let scale = dice.pick(&[0.25, 0.5, 1.0, 2.0, 1024.0]);
    let unit = (0.5 * stride(scene)).log2().floor().exp2();
    Placement { scale, rotate, translate: (dice.direction() * 4.0).round() * unit }
}

fn placed(scene: &DrawnScene, placement: Placement) -> Option<Exported> {
    let files = Files::placed(scene, "other", placement);
    let is_placed = files.beside.iter().any(|(name, _)| name.contains("mgf"));
    is_placed.then(|| Exported { arranged: scene.clone(), files })
}

/// The scene through another format against the same in ours.
fn exported(
    exported: Option<Exported>,
    subject: &Subject<'_>,
    dice: &mut Dice,
    how: &str,
) -> Result<Vec<Claim>, Trouble> {
    let exported = exported.filter(|_| subject.drawn.is_clear());
    let Some(Exported { arranged, files }) = exported else { return Ok(Vec::new()) };
    let estimator = who_may_tell(&arranged, NEARLY, dice);
    let here = Arc::new(subject.workshop.build(&arranged)?);
    let there = Arc::new(subject.workshop.load(&files, arranged.max_depth)?);
    Ok(vec![Claim {
        what: format!("{how}, {}", name(estimator)),
        left: side(&arranged, &here, estimator),
        right: side(&arranged, &there, estimator),
        flipped: false,
        factor: 1.0,
        law: rounded(&arranged),
        numbers: Numbers::of([&here, &there]),
    }])
}

/// All lamps a quarter as bright: a quarter of the picture, exactly.
fn brighter(subject: &Subject<'_>, dice: &mut Dice) -> Result<Vec<Claim>, Trouble> {
    let mut scene = subject.drawn.clone();
    scene.objects.iter_mut().for_each(|object| object.emission *= 0.25);
    scene.lights.iter_mut().for_each(|light| light.intensity *= 0.25);
    scene.sky.iter_mut().flat_map(|sky| &mut sky.texels).for_each(|texel| *texel *= 0.25);
    let method = dice.pick(&[methods::COMBINED, methods::BDPT, methods::PARTICLE]);
    let (estimator, law) = (Estimator::Method(method), Law::SameMean(1e-9));
    let scenes = [subject.drawn, &scene];
    let claim = alike(scenes, subject.workshop, estimator, "a quarter as bright", law)?;
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
