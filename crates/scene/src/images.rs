//! The images of lamps in mirrors, as rough surfaces that look for light see them.
//!
//! Light that comes over a mirror onto a rough surface is a caustic. Where that surface
//! is itself seen by way of a mirror, no two neighbouring vertices between lamp and eye
//! are rough, so nothing can be connected, and a walk from the camera has to hit the lamp's
//! image by chance. But the image is where geometry says: [`ImageDirections`] are cones
//! around it, seen from one point, to be mixed into the directions that a surface draws.
//! They need be neither exact nor complete: whatever they miss the surface's own sampling
//! finds, and weights see to the rest.

mod ball;
mod flat;
mod light_ball;
mod mirror;
mod points;
mod reflection;

pub(crate) use points::{MirrorPath, NumberedMirror};

use crate::surface_point::SHARP;
use crate::surfaces::{Surface, Surfaces};
use crate::{Light, SurfacePoint};
use light_ball::LightBall;
use mirror::Mirror;
use points::MirroredPoints;
use std::f32::consts::TAU;
use traylib_materials::Material;
use traylib_math::{SolidAnglePdf, Vec2, Vec3, warp};

/// So many pairs of lamp and mirror are looked at from a point: those that send most light.
const MOST_PAIRS: usize = 16;
/// A pair that sends less than this part of what the greatest does is not looked at.
const FAINTEST: f32 = 1e-6;
/// The number of mirrors and of lamps that pairs are made of: the largest, the strongest.
const MOST_OF_A_KIND: usize = 64;
/// Lamps are small if they are no more than this part of all surfaces. The surface's own
/// sampling finds an image about as often as the lamp is large, so that images pay where it
/// is small: where light paths do not help, 26 to 76 times at 0.02 to 0.17 %, nothing from
/// 1 % on (docs/hard-light.md).
const SMALL: f64 = 1.0 / 200.0;
/// The number of mirrors, the largest, of which those that are flat show others.
const MOST_IN_ROW: usize = 8;
/// So many cones a point has: the first pairs that show an image there.
const MOST_CONES: usize = 4;
/// The width of the widest images that are aimed at; what is wider than this, in 1 − cos of the
/// half-angle, the surface's own sampling finds often enough: a third of a steradian.
const WIDEST: f32 = 0.05;
/// No cone is narrower than rounding of a unit vector allows: 1 − cos of its half-angle.
const NARROWEST: f32 = 1e-10;

/// The mirrors of a scene, each with a lamp that may show in it; the brightest first.
#[derive(Debug, Default)]
pub(crate) struct MirroredLights {
    pairs: Vec<Pair>,
    /// Whether no more than [`SMALL`] of all surfaces shines.
    pub(crate) lights_are_small: bool,
    /// The point lights that ideal mirrors show, where no direction meets them.
    pub(crate) points: Option<MirroredPoints>,
}

/// A mirror and a lamp.
#[derive(Clone, Copy, Debug)]
struct Pair {
    /// The flat mirror in which the other one is seen; `None` if it is seen itself.
    seen_in: Option<Mirror>,
    mirror: Mirror,
    lamp: LightBall,
    /// About how much of the lamp's power falls on the mirror, over that of the greatest pair.
    power: f32,
}

/// Cones of directions from one point, each around the image of a lamp in a mirror.
///
/// A function of where the point is and which way its surface faces alone, so that walks
/// from both ends of a path agree on it.
#[derive(Clone, Copy, Debug)]
pub struct ImageDirections {
    /// At least one.
    count: usize,
    part: f32,
    cones: [ImageCone; MOST_CONES],
}

/// All directions with 1 − cos of their angle to the axis up to a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
struct ImageCone {
    axis: Vec3,
    one_minus_cos: f32,
}

impl MirroredLights {
    /// Finds the pairs of a scene, as far as they are worth looking for.
    pub(crate) fn new(surfaces: &Surfaces, materials: &[Material], lights: &[Light]) -> Self {
        let points = MirroredPoints::new(surfaces, materials, lights);
        let lights_are_small = lights_are_small(surfaces, lights);
        let mirrors = mirrors(surfaces, materials);
        let lamps = lamps(lights);
        let mut pairs: Vec<Pair> = mirrors
            .iter()
            .flat_map(|mirror| lamps.iter().filter_map(move |lamp| Pair::new(mirror, lamp)))
            .collect();
        let rows = in_rows(&pairs, &mirrors[..mirrors.len().min(MOST_IN_ROW)]);
        pairs.extend(rows);
        keep_greatest(&mut pairs, MOST_PAIRS, |pair| pair.power);
        // In units of the greatest, so that no sum of them leaves the range of numbers.
        let greatest = pairs.first().map_or(1.0, |pair| pair.power);
        for pair in &mut pairs {
            pair.power /= greatest;
        }
        pairs.retain(|pair| pair.power >= FAINTEST);
        Self { pairs, lights_are_small, points }
    }

    /// The images that the surface at `point` may see.
    #[inline]
    pub(crate) fn seen_from(&self, point: &SurfacePoint) -> Option<ImageDirections> {
        if self.pairs.is_empty() { None } else { self.directions(point) }
    }

    fn directions(&self, point: &SurfacePoint) -> Option<ImageDirections> {
        let cones = [ImageCone::EMPTY; MOST_CONES];
        let mut images = ImageDirections { count: 0, part: 0.0, cones };
        let (mut narrow, mut shown) = (0.0, 0.0);
        let (from, normal) = (point.site.position, point.normal);
        for pair @ Pair { power, .. } in &self.pairs {
            if images.count < MOST_CONES
                && pair.rises_above(from, normal)
                && let Some(cone) = pair.image(from)
                && cone.rises_above(normal)
            {
                shown += power;
                if cone.one_minus_cos <= WIDEST {
                    narrow += power;
                    images.cones[images.count] = cone;
                    images.count += 1;
                }
            }
        }
        images.part = narrow / shown;
        (images.count > 0).then_some(images)
    }
}

/// Images of images: the pairs of these mirrors as the other ones show them, as far as they may.
/// Not of mirrors that share a corner: those are sides of one body as a rule, which show one
/// another only where nobody is; in a corner of a room both are found without aiming.
fn in_rows(pairs: &[Pair], mirrors: &[Mirror]) -> Vec<Pair> {
    let of_these = pairs.iter().filter(|pair| mirrors.contains(&pair.mirror));
    of_these.flat_map(|pair| mirrors.iter().filter_map(|mirror| pair.seen_in(mirror))).collect()
}

impl Pair {
    /// `None` where nobody sees this lamp in this mirror.
    fn new(mirror: &Mirror, lamp: &LightBall) -> Option<Self> {
        let power = lamp.power * mirror.part_of_sky(lamp.centre);
        let pair = Self { seen_in: None, mirror: *mirror, lamp: *lamp, power };
        mirror.may_show(lamp).then_some(pair)
    }

    /// Returns this pair as another mirror shows it, if that is flat and may.
    fn seen_in(&self, other: &Mirror) -> Option<Self> {
        let power = self.power * other.part_of_sky(self.mirror.middle());
        let pair = Self { seen_in: Some(*other), power, ..*self };
        let may = other.may_show_mirror(&self.mirror) && !other.touches(&self.mirror);
        may.then_some(pair)
    }

    /// Whether a surface with this normal may see any of it; what is flat does not say no.
    #[inline]
    fn rises_above(&self, from: Vec3, normal: Vec3) -> bool {
        self.seen_in.is_some() || self.mirror.rises_above(from, normal)
    }

    /// Returns the cone of directions in which a point sees the image, if it does.
    fn image(&self, from: Vec3) -> Option<ImageCone> {
        match &self.seen_in {
            None => self.mirror.image(&self.lamp, from),
            Some(other) => other.image_of_image(&self.mirror, &self.lamp, from),
        }
    }
}

/// Whether the lamps are small beside all that there is.
fn lights_are_small(surfaces: &Surfaces, lights: &[Light]) -> bool {
    let shining: f64 = lights
        .iter()
        .map(|light| match light {
            Light::Area { primitive, .. } => f64::from(primitive.area()),
            Light::Point(_) | Light::Sky(_) => 0.0,
        })
        .sum();
    // The sum of areas grows: most scenes have enough of them long before its end.
    let mut all = 0.0;
    let is_enough = |surface: Surface<'_>| {
        all += f64::from(surface.area());
        shining <= SMALL * all
    };
    shining == 0.0 || surfaces.all().any(is_enough)
}

/// A surface as a mirror whose images can be found. Smooth normals bend a mirror that is flat, so
/// that its images are not where the plane has them.
fn mirror(surface: Surface<'_>, materials: &[Material]) -> Option<Mirror> {
    let model = &materials[surface.material()].model;
    let exponent = model.mirror_exponent()?;
    // Glass, of which no part is known, reflects too little to be aimed at.
    let is_glass = model.has_delta_part() && model.mirror_reflectance().is_none();
    if exponent < SHARP || is_glass || surface.is_smooth() {
        return None;
    }
    Mirror::new(&surface.primitive()?, surface.sides(), exponent)
}

/// The largest mirrors of a scene.
fn mirrors(surfaces: &Surfaces, materials: &[Material]) -> Vec<Mirror> {
    let mut mirrors: Vec<Mirror> =
        surfaces.all().filter_map(|surface| mirror(surface, materials)).collect();
    keep_greatest(&mut mirrors, MOST_OF_A_KIND, |mirror| mirror.area);
    mirrors
}

/// The strongest lamps of a scene.
fn lamps(lights: &[Light]) -> Vec<LightBall> {
    let mut lamps: Vec<LightBall> = lights.iter().filter_map(LightBall::of).collect();
    keep_greatest(&mut lamps, MOST_OF_A_KIND, |lamp| lamp.power);
    lamps
}

/// Sorts by a key, the greatest first and equal ones as they were, and keeps so many.
fn keep_greatest<T>(list: &mut Vec<T>, most: usize, key: impl Fn(&T) -> f32) {
    list.sort_by(|one, other| key(other).total_cmp(&key(one)));
    list.truncate(most);
}

impl ImageDirections {
    /// Returns the part that the cones hold of the power that falls on mirrors, as far as lamps
    /// show in them here, in (0, 1]; the rest is in images too wide to be aimed at.
    #[inline]
    pub fn part(&self) -> f32 {
        self.part
    }

    /// A unit direction uniform in one of the cones, each as likely as the others; `u` is
    /// uniform on [0, 1).
    pub fn sample(&self, u: [f32; 3]) -> Vec3 {
        let index = ((u[0] * self.count as f32) as usize).min(self.count - 1);
        let ImageCone { axis, one_minus_cos } = self.cones[index];
        warp::uniform_cone(axis, one_minus_cos, Vec2::new(u[1], u[2]))
    }

    /// The density of [`sample`](Self::sample) at a unit direction.
    #[inline]
    pub fn pdf(&self, direction: Vec3) -> SolidAnglePdf {
        let cones = &self.cones[..self.count];
        let sum: f32 = cones.iter().map(|cone| cone.pdf(direction)).sum();
        SolidAnglePdf(sum / self.count as f32)
    }
}

impl ImageCone {
    const EMPTY: Self = Self { axis: Vec3::Z, one_minus_cos: 1.0 };

    /// The cone around a unit vector with this 1 − cos of its half-angle.
    #[inline]
    fn around(axis: Vec3, one_minus_cos: f32) -> Self {
        Self { axis, one_minus_cos: one_minus_cos.clamp(NARROWEST, 1.0) }
    }

    /// Returns this cone, wider by an angle in radians.
    fn widened(self, angle: f32) -> Self {
        if angle == 0.0 {
            return self;
        }
        Self::around(self.axis, 0.5 * (self.half_angle() + angle).powi(2))
    }

    /// Whether it is a cone at all, where lengths leave the range of numbers, and any of it is
    /// above the surface with this normal.
    fn rises_above(&self, normal: Vec3) -> bool {
        if !self.axis.is_normalized() {
            return false;
        }
        let sine = (self.one_minus_cos * (2.0 - self.one_minus_cos)).sqrt();
        normal.dot(self.axis) > -sine
    }

    /// About its half-angle, no less.
    fn half_angle(&self) -> f32 {
        // 1 − cos h ≥ h²/2·(1 − h²/12).
        (2.0 * self.one_minus_cos * (1.0 + 0.2 * self.one_minus_cos)).sqrt()
    }

    fn pdf(&self, direction: Vec3) -> f32 {
        let inside = 0.5 * (direction - self.axis).length_squared() <= self.one_minus_cos;
        if inside { 1.0 / (TAU * self.one_minus_cos) } else { 0.0 }
    }
}

#[cfg(test)]
mod tests;
