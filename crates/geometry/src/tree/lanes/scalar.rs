//! The kernel for any machine, which is what the others are checked against.

use super::{Lanes, Passed};
use crate::watertight::Shear;
use crate::{Ray, Vec3};
use crate::tree::block::Block;
use crate::tree::boxes::BoxRay;
use crate::tree::node::{LEAF, Node, WIDTH};

pub(crate) struct Scalar {
    boxes: BoxRay,
    shear: Shear,
    origin: Vec3,
}

impl Scalar {
    #[inline]
    pub(crate) fn new(ray: &Ray) -> Self {
        Self { boxes: BoxRay::new(ray), shear: Shear::along(ray.direction), origin: ray.origin }
    }
}

impl Lanes for Scalar {
    #[inline]
    fn enter(&self, node: &Node, limit: f32) -> ([f32; WIDTH], u32) {
        let ray = &self.boxes;
        let mut enter = [0.0; WIDTH];
        let mut mask = 0;
        for lane in 0..WIDTH {
            let mut leave = limit;
            for axis in 0..3 {
                let row = ray.near_row[axis];
                let near = (node.planes[row][lane] - ray.origin[axis]) * ray.near[axis];
                let far = (node.planes[row ^ 1][lane] - ray.origin[axis]) * ray.far[axis];
                enter[lane] = if near > enter[lane] { near } else { enter[lane] };
                leave = if far < leave { far } else { leave };
            }
            mask |= u32::from(enter[lane] <= leave) << lane;
        }
        (enter, mask)
    }

    #[inline]
    fn pass(&self, block: &Block, limit: f32) -> Passed {
        let mut passed =
            Passed { mask: 0, edges: [[0.0; LEAF]; 3], depths: [[0.0; LEAF]; 3] };
        for lane in 0..LEAF {
            let flat = self.shear.flatten(block.triangle(lane), self.origin);
            let [ta, tb, tc] = flat.depths;
            let reaches = ta.max(tb).max(tc) > 0.0 && ta.min(tb).min(tc) < limit;
            passed.mask |= u32::from(flat.is_inside() && reaches) << lane;
            for i in 0..3 {
                passed.edges[i][lane] = flat.edges[i];
                passed.depths[i][lane] = flat.depths[i];
            }
        }
        passed
    }
}
