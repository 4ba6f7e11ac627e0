//! Shapes of any kind.

use super::contents::{Holds, Leaves, offer};
use super::{Bvh, check_count, widened};
use crate::shape::Shape;
use crate::tree::Tree;
use crate::tree::block::Block;
use crate::tree::build::Quality;
use crate::tree::eights::Eights;
use crate::tree::fan::sight::Sight;
use crate::tree::lanes::Triangles;
use crate::tree::mask::ones;
use crate::tree::query::Query;
use crate::tree::visitor::Visitors;
use crate::{Aabb, Error, Ray};
use std::ops::ControlFlow;

/// What a [`Bvh`] of shapes holds: spheres, quads, disks, triangles, or whatever a
/// guest brings.
#[derive(Clone, Debug)]
pub struct Shapes<S>(Vec<S>);

impl<S: Shape> Bvh<Shapes<S>> {
    /// A tree over shapes, of which there may be none.
    ///
    /// # Errors
    /// [`Error::UnboundedShape`] when bounds are infinite or not numbers,
    /// [`Error::TooMany`] for more than 2²⁸ shapes.
    pub fn of_shapes(shapes: Vec<S>) -> Result<Self, Error> {
        check_count(shapes.len())?;
        let bounds: Vec<Aabb> = shapes.iter().map(S::bounds).collect();
        let (boxes, bounds) = sound(&bounds)?;
        let items = (0..shapes.len() as u32).collect();
        let tree = Tree::new(&boxes, items, |i| shapes[i as usize].corners(), Quality::default());
        Ok(Self { tree, contents: Shapes(shapes), bounds })
    }

    /// The shapes in the caller's order, which [`Hit::primitive`](crate::Hit::primitive) counts in.
    pub fn shapes(&self) -> &[S] {
        &self.contents.0
    }
}

/// The boxes widened, and the box around them all.
fn sound(bounds: &[Aabb]) -> Result<(Vec<Aabb>, Aabb), Error> {
    if let Some(index) = bounds.iter().position(|b| !b.is_finite() || b.is_empty()) {
        return Err(Error::UnboundedShape { index });
    }
    let all = bounds.iter().copied().fold(Aabb::EMPTY, Aabb::union);
    Ok((bounds.iter().map(widened).collect(), all))
}

impl<S: Shape> Holds for Shapes<S> {
    fn count(&self) -> u32 {
        self.0.len() as u32
    }

    #[inline]
    fn triangles<T: Triangles, Q: Query>(
        &self,
        block: &Block,
        lanes: &T,
        ray: &Ray,
        query: &mut Q,
    ) -> ControlFlow<()> {
        for lane in ones(lanes.candidates(block, query.limit())) {
            let ray = Ray { t_max: query.limit(), ..*ray };
            self.shape(block.number(lane), &ray, query)?;
        }
        ControlFlow::Continue(())
    }

    #[inline]
    fn fan<E: Eights, Q: Query>(
        &self,
        rays: &mut Visitors<Leaves<'_, Self, Q>>,
        active: u32,
        block: &Block,
        sight: &Sight<E>,
    ) {
        for (lane, candidates) in sight.candidates(block, active, &rays.limits) {
            rays.tell(candidates, |_, leaves| {
                let ray = leaves.ray();
                self.shape(block.number(lane), &ray, &mut leaves.query)
            });
        }
    }

    #[inline]
    fn shape<Q: Query>(&self, number: u32, ray: &Ray, query: &mut Q) -> ControlFlow<()> {
        offer(self.0[number as usize].intersect(ray), number, query)
    }
}
