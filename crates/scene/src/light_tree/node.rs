//! What a point is told of a cluster of lamps.

use super::cluster::Cluster;
use super::cone::{Cone, Reach};
use std::f64::consts::PI;
use traylib_math::Vec3;

/// Room for rounding, in cosines and relative to lengths: some ten operations, each
/// to 6·10⁻⁸. With it, no lamp that shines at a point is believed not to.
const SLACK: f32 = 1.0 / (1 << 20) as f32;

/// A cluster in the form that choices need, in single precision.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// Of a box around all lamps.
    centre: Vec3,
    /// From the centre of the box to a corner.
    corner: Vec3,
    /// How long that is.
    radius: f32,
    axis: Vec3,
    aim: Aim,
    /// Of all lamps together, over that of the scene's strongest.
    pub(super) intensity: f32,
    pub(super) link: Link,
}

/// A [`Cone`](super::cone::Cone) around the axis, by what it takes to ask it.
#[derive(Clone, Copy, Debug)]
enum Aim {
    /// Some lamp shines into any direction.
    Everywhere,
    /// All lamps are flat and face along the axis.
    OneWay,
    /// Lamps have directions within an angle of the axis.
    Around(Angle, Reach),
}

/// What is below a node.
#[derive(Clone, Copy, Debug)]
pub(super) enum Link {
    /// Two nodes, this one and the next.
    Pair(u32),
    /// One lamp.
    Lamp(u32),
}

/// An angle from 0 to π by its cosine and sine times some length, which need no arc
/// functions to be subtracted.
#[derive(Clone, Copy, Debug)]
struct Angle {
    cos: f32,
    sin: f32,
}

impl Angle {
    /// The difference, times the product of both lengths; `None` if it is negative.
    #[inline]
    fn less(self, other: Self) -> Option<Self> {
        let sin = self.sin * other.cos - self.cos * other.sin;
        (sin >= 0.0).then_some(Self { cos: self.cos * other.cos + self.sin * other.sin, sin })
    }
}

impl Aim {
    fn new(cone: &Cone) -> Self {
        let (sin, cos) = cone.spread.sin_cos();
        if cone.spread >= PI {
            Self::Everywhere
        } else if cone.spread == 0.0 && cone.reach == Reach::Hemisphere {
            Self::OneWay
        } else {
            Self::Around(Angle { cos: cos as f32, sin: sin as f32 }, cone.reach)
        }
    }
}

impl Node {
    pub(super) fn new(cluster: &Cluster, link: Link) -> Self {
        let Cluster { bounds, cone, intensity } = cluster;
        let centre = bounds.centre();
        let corner = (bounds.max - centre).max(centre - bounds.min);
        Self {
            centre,
            corner,
            radius: corner.length() * (1.0 + SLACK),
            axis: cone.axis.as_vec3(),
            aim: Aim::new(cone),
            intensity: *intensity as f32,
            link,
        }
    }

    /// Intensity over the distance of the centre squared, times a bound on the
    /// lamps' cosines toward `x1`; `None` only if none of them shines there. No
    /// distance counts as less than the radius: so much light lamps that are spread
    /// evenly give a point among them.
    #[inline]
    pub(super) fn importance(&self, x1: Vec3) -> Option<f32> {
        let offset = x1 - self.centre;
        let distance_squared = offset.length_squared();
        let cosine = match self.aim {
            Aim::Everywhere => 1.0,
            Aim::OneWay => self.cosine_of_box(offset, self.most_along(offset))?,
            Aim::Around(spread, reach) => {
                self.cosine_around(offset, distance_squared, spread, reach)?
            }
        };
        Some(self.intensity * cosine / distance_squared.max(self.radius * self.radius))
    }

    /// The furthest that a point lies before any lamp, along the axis.
    #[inline]
    fn most_along(&self, offset: Vec3) -> f32 {
        let room = SLACK * (offset.abs() + self.corner).element_sum();
        self.axis.dot(offset) + self.axis.abs().dot(self.corner) + room
    }

    /// A bound on cosines toward a point that lies so far before any lamp: over the
    /// least distance of the box.
    #[inline]
    fn cosine_of_box(&self, offset: Vec3, before: f32) -> Option<f32> {
        if before <= 0.0 {
            return None;
        }
        let outside = (offset.abs() - self.corner).max(Vec3::ZERO);
        Some((before / outside.length()).min(1.0))
    }

    /// The lesser of two bounds. That of the ball holds for all lamps; that of the
    /// box says more of lamps that shine nearly one way, as those of a ceiling do.
    #[inline]
    fn cosine_around(
        &self,
        offset: Vec3,
        distance_squared: f32,
        spread: Angle,
        reach: Reach,
    ) -> Option<f32> {
        // Not from the cosine, which says little of an angle near 0 or π.
        let across = self.axis.cross(offset).length();
        let from_axis = Angle { cos: self.axis.dot(offset), sin: across };
        let of_ball = self.cosine_of_ball(from_axis, distance_squared, spread, reach)?;
        if reach == Reach::Nowhere || spread.cos < 0.0 {
            return Some(of_ball);
        }
        let before = self.most_along(offset) * spread.cos + (across + self.radius) * spread.sin;
        Some(of_ball.min(self.cosine_of_box(offset, before)?))
    }

    /// Cosine of the least angle between the direction of a lamp and that from it
    /// to a point: θ to the axis from the centre, less the spread of the lamps'
    /// directions, less the angle at which the point sees the ball. Within the ball
    /// it sees it everywhere.
    #[inline]
    fn cosine_of_ball(
        &self,
        from_axis: Angle,
        distance_squared: f32,
        spread: Angle,
        reach: Reach,
    ) -> Option<f32> {
        let tangent_squared = distance_squared - self.radius * self.radius;
        if tangent_squared <= 0.0 {
            return Some(1.0);
        }
        let ball = Angle { cos: tangent_squared.sqrt(), sin: self.radius };
        let Some(angle) = from_axis.less(spread).and_then(|angle| angle.less(ball)) else {
            return Some(1.0);
        };
        let cosine = angle.cos / distance_squared + SLACK;
        if cosine <= reach.cosine() { None } else { Some(cosine.min(1.0)) }
    }
}
