//! The image in a flat mirror stands as far behind it as the lamp before it.

use super::ImageCone;
use super::light_ball::LightBall;
use super::reflection::Reflection;
use traylib_geometry::{Outline, Sides};
use traylib_math::Vec3;
use traylib_math::glam::DVec3;

/// The height, over its size, up to which a shape lies in a plane: what is no higher than this,
/// over its size, lies in it but for rounding.
const IN_PLANE: f32 = 1e-5;

/// A flat piece that mirrors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FlatMirror {
    /// A corner, or the centre of a disk.
    anchor: Vec3,
    normal: Vec3,
    front_only: bool,
    outline: MirrorOutline,
}

/// The outline in its plane.
#[derive(Clone, Copy, Debug, PartialEq)]
enum MirrorOutline {
    /// Coordinates of an offset o from the anchor are o·`to_u` and o·`to_v`, both from 0
    /// to 1 in a parallelogram with these edges.
    Quad { edges: [Vec3; 2], to_u: Vec3, to_v: Vec3 },
    /// They are in [0, 1], and their sum is at most 1.
    Triangle { edges: [Vec3; 2], to_u: Vec3, to_v: Vec3 },
    /// Around the anchor.
    Disk { radius: f32 },
}

impl FlatMirror {
    /// A flat piece with this front normal; `None` where it is too thin for coordinates on it.
    pub(super) fn new(normal: Vec3, outline: Outline, sides: Sides) -> Option<Self> {
        let (anchor, outline) = match outline {
            Outline::Triangle([a, b, c]) => {
                let edges = [b - a, c - a];
                let [to_u, to_v] = duals(edges)?;
                (a, MirrorOutline::Triangle { edges, to_u, to_v })
            }
            Outline::Parallelogram { corner, edges } => {
                let [to_u, to_v] = duals(edges)?;
                (corner, MirrorOutline::Quad { edges, to_u, to_v })
            }
            Outline::Circle { centre, radius } => (centre, MirrorOutline::Disk { radius }),
        };
        Some(Self { anchor, normal, front_only: sides == Sides::Front, outline })
    }

    /// A point in its middle.
    pub(super) fn middle(&self) -> Vec3 {
        match self.outline {
            MirrorOutline::Quad { edges: [u, v], .. } => self.anchor + 0.5 * (u + v),
            MirrorOutline::Triangle { edges: [u, v], .. } => self.anchor + (u + v) / 3.0,
            MirrorOutline::Disk { .. } => self.anchor,
        }
    }

    /// Tells whether a lamp's light may fall on a side that mirrors.
    pub(super) fn may_show(&self, lamp: &LightBall) -> bool {
        let height = self.height(lamp.centre);
        (!self.front_only || height > -lamp.radius)
            && lamp.may_light(self.middle(), self.outline.reach())
    }

    /// Tells whether any of a ball is before a side that mirrors.
    pub(super) fn faces_ball(&self, centre: Vec3, radius: f32) -> bool {
        !self.front_only || self.height(centre) > -radius
    }

    /// Tells whether any of another piece is before a side that mirrors, and not in the same plane.
    pub(super) fn faces(&self, other: &Self) -> bool {
        let (height, rise) =
            (self.height(other.anchor), other.outline.rise(self.normal, other.normal));
        let highest = height + rise[1];
        let lowest = if self.front_only { 0.0 } else { height + rise[0] };
        highest.max(-lowest) > IN_PLANE * other.outline.reach()
    }

    /// Tells whether it has a corner in common with another piece, but for rounding.
    pub(super) fn touches(&self, other: &Self) -> bool {
        let near = IN_PLANE * self.outline.reach();
        let is_near = |one: Vec3, other: Vec3| one.distance_squared(other) <= near * near;
        let others = other.corners();
        self.corners().iter().any(|&one| others.iter().any(|&other| is_near(one, other)))
    }

    /// Its corners; a disk has none.
    fn corners(&self) -> Vec<Vec3> {
        let from_anchor = match self.outline {
            MirrorOutline::Quad { edges: [u, v], .. } => vec![Vec3::ZERO, u, v, u + v],
            MirrorOutline::Triangle { edges: [u, v], .. } => vec![Vec3::ZERO, u, v],
            MirrorOutline::Disk { .. } => Vec::new(),
        };
        from_anchor.into_iter().map(|offset| self.anchor + offset).collect()
    }

    /// Tells whether two points are before the same side.
    pub(super) fn are_on_one_side(&self, one: Vec3, other: Vec3) -> bool {
        self.height(one) * self.height(other) > 0.0
    }

    /// Returns the image of a point in the mirror, if that shows it.
    pub(super) fn behind(&self, from: Vec3) -> Option<Vec3> {
        let height = self.height(from);
        let shows = height > 0.0 || (height < 0.0 && !self.front_only);
        shows.then(|| from - 2.0 * height * self.normal)
    }

    /// A direction as it looks in the mirror.
    pub(super) fn mirrored(&self, direction: DVec3) -> DVec3 {
        let normal = self.normal.as_dvec3();
        direction - 2.0 * normal.dot(direction) * normal
    }

    /// A cone of directions from behind the mirror, which end before it, as `from` sees it, and
    /// where in the mirror that is; `None` if the mirror does not reach there.
    pub(super) fn turned(&self, cone: ImageCone, from: Vec3) -> Option<(ImageCone, Vec3)> {
        let (height, climb) = (self.height(from), self.normal.dot(cone.axis));
        if height * climb <= 0.0 {
            return None;
        }
        let distance = height / climb;
        let axis = cone.axis - 2.0 * climb * self.normal;
        let seen_at = from + distance * axis;
        let reaches = self.outline.reaches(seen_at - self.anchor, distance * cone.half_angle());
        reaches.then_some((ImageCone { axis, ..cone }, seen_at))
    }

    fn height(&self, at: Vec3) -> f32 {
        self.normal.dot(at - self.anchor)
    }

    /// The cone around a lamp's image as `from` sees it, if any of it may show.
    pub(super) fn image(&self, lamp: &LightBall, blur: f32, from: Vec3) -> Option<ImageCone> {
        // Both before the mirror, on one side of it.
        let (height, lamp_height) = (self.height(from), self.height(lamp.centre));
        if height * lamp_height <= 0.0 || (self.front_only && height < 0.0) {
            return None;
        }
        // The image, and where in the mirror it is seen.
        let image = lamp.centre - 2.0 * lamp_height * self.normal;
        let offset = image - from;
        let distance = offset.length();
        let to_mirror = height / (height + lamp_height);
        let seen_at = from + to_mirror * offset;
        // A blurred lamp is one that is larger by what the lobe makes of the way to it.
        let blur_radius = blur * (1.0 - to_mirror) * distance;
        let radius = lamp.radius + blur_radius;
        if !self.outline.reaches(seen_at - self.anchor, to_mirror * radius)
            || !lamp.shines_to(seen_at - lamp.centre)
        {
            return None;
        }
        // 1 − cos without cancellation; nobody needs to aim at what is all around.
        let sine_squared = (radius / distance).powi(2);
        let one_minus_cos = sine_squared / (1.0 + (1.0 - sine_squared).sqrt());
        (sine_squared < 1.0).then(|| ImageCone::around(offset / distance, one_minus_cos))
    }

    /// Returns how light of a point arrives at another by way of the mirror's plane, whether or not
    /// the mirror reaches there: as from an image, over the whole way.
    pub(super) fn reflection(&self, from: Vec3, light: Vec3) -> Option<Reflection> {
        let [anchor, normal] = [self.anchor, self.normal].map(Vec3::as_dvec3);
        let [from, light] = [from, light].map(|point| point.as_dvec3() - anchor);
        // Both on one side, and on the one that mirrors.
        let [height, light_height] = [from, light].map(|point| normal.dot(point));
        if height * light_height <= 0.0 || (self.front_only && height < 0.0) {
            return None;
        }
        let toward = light - 2.0 * light_height * normal - from;
        Some(Reflection { toward, spread: 1.0 / toward.length_squared() })
    }
}

impl MirrorOutline {
    /// No point is farther from the middle.
    fn reach(&self) -> f32 {
        match self {
            Self::Quad { edges: [u, v], .. } => 0.5 * (u.length() + v.length()),
            Self::Triangle { edges: [u, v], .. } => u.length().max(v.length()),
            Self::Disk { radius } => *radius,
        }
    }

    /// Returns how far below and above its anchor it reaches along a unit direction; `normal` is
    /// its own.
    fn rise(&self, up: Vec3, normal: Vec3) -> [f32; 2] {
        let corners = match *self {
            Self::Quad { edges: [u, v], .. } => [u, v, u + v],
            Self::Triangle { edges: [u, v], .. } => [u, v, Vec3::ZERO],
            Self::Disk { radius } => {
                let climb = radius * up.cross(normal).length();
                return [-climb, climb];
            }
        };
        let rises = corners.map(|corner| up.dot(corner));
        [rises.iter().copied().fold(0.0, f32::min), rises.iter().copied().fold(0.0, f32::max)]
    }

    /// Tells whether an offset from the anchor, in the plane, is inside or at most this far out.
    fn reaches(&self, offset: Vec3, margin: f32) -> bool {
        let inside = |to: Vec3, over: f32| {
            let (at, slack) = (offset.dot(to), margin * to.length());
            -slack <= at && at <= over + slack
        };
        match *self {
            Self::Quad { to_u, to_v, .. } => inside(to_u, 1.0) && inside(to_v, 1.0),
            Self::Triangle { to_u, to_v, .. } => {
                inside(to_u, f32::INFINITY)
                    && inside(to_v, f32::INFINITY)
                    && inside(to_u + to_v, 1.0)
            }
            Self::Disk { radius } => offset.length() <= radius + margin,
        }
    }
}

/// The vectors whose dot products with an offset in the plane of two edges give its
/// coordinates along them; `None` where the edges are too thin for that.
fn duals(edges: [Vec3; 2]) -> Option<[Vec3; 2]> {
    // In double precision: the fourth power of a length leaves the range of the single one.
    let [u, v] = edges.map(Vec3::as_dvec3);
    let normal = u.cross(v);
    let square = normal.length_squared();
    let duals = [v.cross(normal), normal.cross(u)].map(|dual| (dual / square).as_vec3());
    duals.iter().all(|dual| dual.is_finite()).then_some(duals)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coordinates along edges of any length, from where fourth powers are zero to where they
    /// are no numbers.
    #[test]
    fn coordinates_are_found_at_any_scale() {
        let (u, v) = (Vec3::new(1.5, 0.0, 0.5), Vec3::new(-0.25, 2.0, 0.0));
        for power in -40..=40 {
            let scale = 2.0_f32.powi(power);
            let [to_u, to_v] = duals([u * scale, v * scale]).unwrap();
            let at = 0.25 * u * scale + 0.5 * v * scale;
            assert!((at.dot(to_u) - 0.25).abs() < 1e-6, "2^{power}: {to_u}");
            assert!((at.dot(to_v) - 0.5).abs() < 1e-6, "2^{power}: {to_v}");
        }
    }
}
