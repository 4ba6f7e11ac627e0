//! Nodes of the light tree: up to four clusters of lamps, judged from a point side by side.

use super::cluster::Cluster;
use super::cone::Reach;
use std::f64::consts::PI;
use traylib_math::Vec3;
use traylib_math::glam::{BVec4A, Vec4};

/// The greatest number of children of a node.
pub(super) const WIDTH: usize = 4;

/// Room for rounding, in cosines and relative to lengths: some ten operations, each
/// to 6·10⁻⁸. With it, no lamp that shines at a point is believed not to.
const SLACK: f32 = 1.0 / (1 << 20) as f32;

/// The children of a node in the form that choices need, in single precision: of each
/// number a vector, with an element for each child.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// The centres of boxes around all lamps, by axis.
    centre: [Vec4; 3],
    /// From the centre of the box to a corner, by axis.
    corner: [Vec4; 3],
    /// The sum of the corner's coordinates.
    corner_sum: Vec4,
    /// The distance of the corner.
    radius: Vec4,
    /// The axes of the cones, by coordinate.
    axis: [Vec4; 3],
    /// The extent of the box along the axis, from its centre.
    reach_of_box: Vec4,
    /// The cones' angles.
    spread: Angles,
    /// Cosine of the angle up to which lamps shine beyond the spread.
    reach: Vec4,
    /// Children whose lamps shine into all directions, as far as is known.
    everywhere: BVec4A,
    /// Children of whose lamps the box bounds cosines, too.
    bound_by_box: BVec4A,
    /// True if all lamps of each child are flat and face one way.
    flat: bool,
    /// The intensity of all lamps together, over that of the scene's strongest; zero where there is
    /// no child.
    pub(super) intensity: Vec4,
    /// The links to the children; where there is no child, that to another.
    pub(super) links: [Link; WIDTH],
}

/// A link to what is below a node: a lamp, or nodes.
#[derive(Clone, Copy, Debug)]
pub(super) enum Link {
    /// Another node.
    Node(u32),
    /// One lamp.
    Lamp(u32),
}

/// The importance of children: what they may give a point.
pub(super) struct Importance {
    /// Not a number or infinite where squares of distances leave single precision.
    pub(super) value: Vec4,
    /// Children that may give it any.
    pub(super) shines: BVec4A,
}

/// A bound on the cosines of children's lamps toward a point.
struct Cosines {
    bound: Vec4,
    /// Children whose lamps may shine at the point.
    shines: BVec4A,
}

/// Angles from 0 to π by their cosines and sines times some length, which need no arc
/// functions to be subtracted.
#[derive(Clone, Copy, Debug)]
struct Angles {
    cos: Vec4,
    sin: Vec4,
}

impl Angles {
    /// The differences, times the products of both lengths; their sines are less than
    /// zero where they are negative.
    #[inline]
    fn less(self, other: Self) -> Self {
        Self {
            cos: self.cos * other.cos + self.sin * other.sin,
            sin: self.sin * other.cos - self.cos * other.sin,
        }
    }
}

impl Node {
    /// The node of one to [`WIDTH`] children.
    pub(super) fn new(children: &[(Cluster, Link)]) -> Self {
        let child = |lane: usize| children.get(lane).unwrap_or(&children[0]);
        let clusters: [&Cluster; WIDTH] = std::array::from_fn(|lane| &child(lane).0);
        let each = |number: &dyn Fn(&Cluster) -> f32| Vec4::from_array(clusters.map(number));
        let by_axis = |vector: fn(&Cluster) -> Vec3| [0, 1, 2].map(|i| each(&|c| vector(c)[i]));
        let whose = |holds: fn(&Cluster) -> bool| BVec4A::from(clusters.map(holds));
        let exists: [f32; WIDTH] = std::array::from_fn(|lane| (lane < children.len()).into());
        Self {
            centre: by_axis(|c| c.bounds.centre()),
            corner: by_axis(corner),
            corner_sum: each(&|c| corner(c).element_sum()),
            radius: each(&|c| corner(c).length() * (1.0 + SLACK)),
            axis: by_axis(|c| c.cone.axis.as_vec3()),
            reach_of_box: each(&|c| c.cone.axis.as_vec3().abs().dot(corner(c))),
            spread: Angles {
                cos: each(&|c| c.cone.spread.cos() as f32),
                sin: each(&|c| c.cone.spread.sin() as f32),
            },
            reach: each(&|c| c.cone.reach.cosine()),
            everywhere: whose(|c| c.cone.spread >= PI),
            bound_by_box: whose(|c| {
                c.cone.reach == Reach::Hemisphere && c.cone.spread.cos() >= 0.0
            }),
            flat: clusters
                .iter()
                .all(|c| c.cone.reach == Reach::Hemisphere && c.cone.spread == 0.0),
            intensity: each(&|c| c.intensity as f32) * Vec4::from_array(exists),
            links: std::array::from_fn(|lane| child(lane).1),
        }
    }

    /// Intensity over the distance of the centre squared, times a bound on the
    /// lamps' cosines toward `x1`; a child does not shine only if none of its lamps does
    /// so there. No distance counts as less than the radius: so much light lamps that are
    /// spread evenly give a point among them.
    #[inline]
    pub(super) fn importance(&self, x1: Vec3) -> Importance {
        let offset = [0, 1, 2].map(|i| Vec4::splat(x1[i]) - self.centre[i]);
        let distance_squared = dot(offset, offset);
        let along = dot(self.axis, offset);
        let Cosines { bound, shines } = if self.flat {
            // Of no spread, all that asks for the angle to the axis is nought.
            self.cosines_of_box(offset, Angles { cos: along, sin: Vec4::ZERO })
        } else {
            // Not from the cosine, which says little of an angle near 0 or π.
            let across = cross(self.axis, offset);
            let from_axis = Angles { cos: along, sin: dot(across, across).sqrt() };
            self.cosines(offset, distance_squared, from_axis)
        };
        let nearest = distance_squared.max(self.radius * self.radius);
        Importance { value: self.intensity * bound / nearest, shines: shines & self.exists() }
    }

    /// Returns a mask of the children that there are.
    #[inline]
    pub(super) fn exists(&self) -> BVec4A {
        self.intensity.cmpgt(Vec4::ZERO)
    }

    /// The lesser of two bounds. That of the ball holds for all lamps; that of the box
    /// says more of lamps that shine nearly one way, as those of a ceiling do.
    #[inline]
    fn cosines(&self, offset: [Vec4; 3], distance_squared: Vec4, from_axis: Angles) -> Cosines {
        let of_ball = self.cosines_of_ball(from_axis, distance_squared);
        let of_box = self.cosines_of_box(offset, from_axis);
        let least = of_ball.bound.min(of_box.bound);
        Cosines {
            bound: Vec4::select(self.bound_by_box, least, of_ball.bound),
            shines: of_ball.shines & (of_box.shines | !self.bound_by_box),
        }
    }

    /// Cosine of the least angle between the direction of a lamp and that from it
    /// to a point: θ to the axis from the centre, less the spread of the lamps'
    /// directions, less the angle at which the point sees the ball. Within the ball
    /// it sees it everywhere.
    #[inline]
    fn cosines_of_ball(&self, from_axis: Angles, distance_squared: Vec4) -> Cosines {
        let tangent_squared = distance_squared - self.radius * self.radius;
        let seen = Angles { cos: tangent_squared.max(Vec4::ZERO).sqrt(), sin: self.radius };
        let from_spread = from_axis.less(self.spread);
        let angle = from_spread.less(seen);
        let faces = self.everywhere
            | tangent_squared.cmple(Vec4::ZERO)
            | from_spread.sin.cmplt(Vec4::ZERO)
            | angle.sin.cmplt(Vec4::ZERO);
        let cosine = angle.cos / distance_squared + SLACK;
        Cosines {
            bound: Vec4::select(faces, Vec4::ONE, cosine.min(Vec4::ONE)),
            shines: faces | !cosine.cmple(self.reach),
        }
    }

    /// A bound from the furthest that a point may lie before any lamp, over the least
    /// distance of the box.
    #[inline]
    fn cosines_of_box(&self, offset: [Vec4; 3], from_axis: Angles) -> Cosines {
        let [x, y, z] = offset.map(Vec4::abs);
        let room = SLACK * (x + y + z + self.corner_sum);
        let before_axis = from_axis.cos + self.reach_of_box + room;
        let before =
            before_axis * self.spread.cos + (from_axis.sin + self.radius) * self.spread.sin;
        let [right, up, back] = self.corner;
        let outside = [x - right, y - up, z - back].map(|along| along.max(Vec4::ZERO));
        Cosines {
            bound: (before / dot(outside, outside).sqrt()).min(Vec4::ONE),
            // Of squares beyond the range of numbers nothing is known.
            shines: !before.cmple(Vec4::ZERO),
        }
    }
}

/// From the centre of a cluster's box to a corner.
fn corner(cluster: &Cluster) -> Vec3 {
    let bounds = &cluster.bounds;
    let centre = bounds.centre();
    (bounds.max - centre).max(centre - bounds.min)
}

#[inline]
fn dot(a: [Vec4; 3], b: [Vec4; 3]) -> Vec4 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
fn cross(a: [Vec4; 3], b: [Vec4; 3]) -> [Vec4; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
