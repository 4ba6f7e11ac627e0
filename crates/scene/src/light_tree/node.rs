//! What a point is told of a cluster of lamps.

use super::cluster::Cluster;
use super::cone::Reach;
use traylib_math::Vec3;

/// Room for rounding, in cosines and relative to lengths: some ten operations, each
/// to 6·10⁻⁸. With it, no lamp that shines at a point is believed not to.
const SLACK: f32 = 1.0 / (1 << 20) as f32;

/// A cluster in the form that choices need, in single precision.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// Of a ball around all lamps.
    centre: Vec3,
    radius_squared: f32,
    axis: Vec3,
    spread: Angle,
    /// Cosine of how far off their direction the lamps shine.
    cos_reach: f32,
    /// Of all lamps together, over that of the scene's strongest.
    pub(super) intensity: f32,
    pub(super) link: Link,
}

/// What is below a node.
#[derive(Clone, Copy, Debug)]
pub(super) enum Link {
    /// Two nodes, this one and the next.
    Pair(u32),
    /// One lamp.
    Lamp(u32),
}

/// An angle from 0 to π by its cosine and sine, which need no unit vectors' arc
/// functions to be subtracted.
#[derive(Clone, Copy, Debug)]
struct Angle {
    cos: f32,
    sin: f32,
}

impl Angle {
    /// The difference, or zero if that is negative.
    #[inline]
    fn less(self, other: Self) -> Self {
        if self.cos >= other.cos {
            return Self { cos: 1.0, sin: 0.0 };
        }
        Self {
            cos: self.cos * other.cos + self.sin * other.sin,
            sin: self.sin * other.cos - self.cos * other.sin,
        }
    }
}

impl Node {
    pub(super) fn new(cluster: &Cluster, link: Link) -> Self {
        let Cluster { bounds, cone, intensity } = cluster;
        let centre = bounds.centre();
        let corner = (bounds.max - centre).max(centre - bounds.min);
        let (sin, cos) = cone.spread.sin_cos();
        Self {
            centre,
            radius_squared: corner.length_squared() * (1.0 + SLACK),
            axis: cone.axis.as_vec3(),
            spread: Angle { cos: cos as f32, sin: sin as f32 },
            cos_reach: match cone.reach {
                Reach::Nowhere => 1.0,
                Reach::Hemisphere => 0.0,
            },
            intensity: *intensity as f32,
            link,
        }
    }

    /// Intensity over distance squared, as if all lamps were at the centre, times a
    /// bound on their cosines toward `x1`; zero only if none of them shines there.
    /// No distance counts as less than the radius, within which every direction
    /// is possible.
    #[inline]
    pub(super) fn importance(&self, x1: Vec3) -> f32 {
        let offset = x1 - self.centre;
        let distance_squared = offset.length_squared();
        if distance_squared <= self.radius_squared {
            return self.intensity / self.radius_squared;
        }
        let cosine = self.greatest_cosine(offset, distance_squared);
        if cosine <= self.cos_reach {
            return 0.0;
        }
        self.intensity * cosine.min(1.0) / distance_squared
    }

    /// Cosine of the least angle between the direction of a lamp and that from it
    /// to a point outside the ball: θ to the axis from the centre, less the spread
    /// of the lamps' directions, less the angle at which the point sees the ball.
    #[inline]
    fn greatest_cosine(&self, offset: Vec3, distance_squared: f32) -> f32 {
        let per_length = 1.0 / distance_squared.sqrt();
        let from_axis = Angle {
            cos: self.axis.dot(offset) * per_length,
            // Not from the cosine, which says little of an angle near 0 or π.
            sin: self.axis.cross(offset).length() * per_length,
        };
        let sin_squared = self.radius_squared / distance_squared;
        let ball = Angle { cos: (1.0 - sin_squared).sqrt(), sin: sin_squared.sqrt() };
        from_axis.less(self.spread).less(ball).cos + SLACK
    }
}
