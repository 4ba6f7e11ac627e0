//! A fan before boxes.

use super::FAN;
use crate::Ray;
use crate::tree::lanes::{FARTHER, NEARER, greater, lesser};
use crate::tree::node::Node;

/// A fan as boxes see it, by axis, by ray.
pub(super) struct Slopes {
    origin: [f32; 3],
    /// From a distance along an axis to t, for near and for far planes.
    near: [[f32; FAN]; 3],
    far: [[f32; FAN]; 3],
}

impl Slopes {
    #[inline(always)]
    pub(super) fn of(rays: &[Ray; FAN]) -> Self {
        let none = [[0.0; FAN]; 3];
        let origin = rays[0].origin.to_array();
        let mut this = Self { origin, near: none, far: none };
        for axis in 0..3 {
            for (i, ray) in rays.iter().enumerate() {
                let reciprocal = 1.0 / ray.direction[axis];
                this.near[axis][i] = reciprocal * NEARER;
                this.far[axis][i] = reciprocal * FARTHER;
            }
        }
        this
    }

    /// The slopes with which a box is open that is open to any of the rays: of each axis the
    /// nearest to zero for near planes, the farthest from it for far ones.
    #[inline(always)]
    pub(super) fn widest(&self) -> [[f32; 3]; 2] {
        let (mut nearest, mut farthest) = ([f32::INFINITY; 3], [0.0; 3]);
        for axis in 0..3 {
            for i in 0..FAN {
                nearest[axis] = lesser(self.near[axis][i].abs(), nearest[axis]);
                farthest[axis] = greater(self.far[axis][i].abs(), farthest[axis]);
            }
            nearest[axis] = nearest[axis].copysign(self.near[axis][0]);
            farthest[axis] = farthest[axis].copysign(self.far[axis][0]);
        }
        [nearest, farthest]
    }

    /// One bit for each ray that meets a box of a node before its limit.
    #[inline(always)]
    pub(super) fn meet(&self, node: &Node, lane: usize, limits: &[f32; FAN]) -> u32 {
        let plane = |axis: usize, is_far: bool| {
            let side = usize::from((self.near[axis][0] < 0.0) ^ is_far);
            node.planes[2 * axis + side][lane] - self.origin[axis]
        };
        let near = [plane(0, false), plane(1, false), plane(2, false)];
        let far = [plane(0, true), plane(1, true), plane(2, true)];
        mask(|i| {
            let near = |axis: usize| near[axis] * self.near[axis][i];
            let far = |axis: usize| far[axis] * self.far[axis][i];
            let enter = greater(greater(near(0), near(1)), greater(near(2), 0.0));
            let leave = lesser(lesser(far(0), far(1)), lesser(far(2), limits[i]));
            enter <= leave
        })
    }
}

/// One bit for each ray of which something is true.
#[inline(always)]
fn mask(is_set: impl Fn(usize) -> bool) -> u32 {
    (0..FAN).fold(0, |mask, i| mask | u32::from(is_set(i)) << i)
}
