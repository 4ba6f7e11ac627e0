//! The queries along a ray: for the nearest hit, any hit, or all hits.

use crate::{Hit, Ray};
use std::ops::ControlFlow;

/// A question that is answered hit by hit.
pub(crate) trait Query {
    /// True if the nearer boxes are better opened first.
    const IN_ORDER: bool;

    /// Hits count below this t: none, once it has broken.
    fn limit(&self) -> f32;

    /// Takes a hit with t below the limit; breaks when nothing more is asked.
    fn offer(&mut self, hit: Hit) -> ControlFlow<()>;
}

impl<Q: Query> Query for &mut Q {
    const IN_ORDER: bool = Q::IN_ORDER;

    #[inline]
    fn limit(&self) -> f32 {
        (**self).limit()
    }

    #[inline]
    fn offer(&mut self, hit: Hit) -> ControlFlow<()> {
        (**self).offer(hit)
    }
}

/// The query for the hit that comes first.
///
/// Of hits at the same t the one with the lowest number counts: so the answer does
/// not depend on the order in which shapes are tried.
pub(crate) struct Nearest {
    limit: f32,
    found: Hit,
}

impl Nearest {
    #[inline]
    pub(crate) fn new(ray: &Ray) -> Self {
        Self { limit: ray.t_max, found: Hit { t: ray.t_max, primitive: u32::MAX, u: 0.0, v: 0.0 } }
    }

    #[inline]
    pub(crate) fn found(&self) -> Option<Hit> {
        (self.found.primitive != u32::MAX).then_some(self.found)
    }
}

impl Query for Nearest {
    const IN_ORDER: bool = true;

    #[inline]
    fn limit(&self) -> f32 {
        self.limit
    }

    #[inline]
    fn offer(&mut self, hit: Hit) -> ControlFlow<()> {
        let ties = hit.t == self.found.t && hit.primitive < self.found.primitive;
        if hit.t < self.found.t || ties {
            self.found = hit;
            // A tie may still come with a lower number. t is below a limit, so the next
            // number has the next bits.
            self.limit = f32::from_bits(hit.t.to_bits() + 1);
        }
        ControlFlow::Continue(())
    }
}

/// Is there a hit?
pub(crate) struct Any {
    limit: f32,
    pub(crate) found: bool,
}

impl Any {
    #[inline]
    pub(crate) fn new(ray: &Ray) -> Self {
        Self { limit: ray.t_max, found: false }
    }
}

impl Query for Any {
    const IN_ORDER: bool = false;

    #[inline]
    fn limit(&self) -> f32 {
        self.limit
    }

    #[inline]
    fn offer(&mut self, _: Hit) -> ControlFlow<()> {
        (self.limit, self.found) = (-1.0, true);
        ControlFlow::Break(())
    }
}

/// The query for all hits.
pub(crate) struct All {
    pub(crate) limit: f32,
    pub(crate) found: Vec<Hit>,
}

impl Query for All {
    const IN_ORDER: bool = false;

    #[inline]
    fn limit(&self) -> f32 {
        self.limit
    }

    fn offer(&mut self, hit: Hit) -> ControlFlow<()> {
        self.found.push(hit);
        ControlFlow::Continue(())
    }
}
