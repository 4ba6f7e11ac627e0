//! The request for a plan, and the plan.

use super::evidence::Evidence;
use crate::{Auto, Method, PointSet, Settings};

/// A request for a plan.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// The longest path, for the methods that are chosen from.
    pub max_depth: Option<u32>,
    /// The part of all light that longer paths may hold and lose: where it is above zero, a
    /// longest path is chosen, too.
    pub may_lose: f64,
    /// Samples a pixel of the picture, to spend a small part of them on the plan.
    pub spp: u32,
    /// Seed of the picture.
    pub seed: u64,
    /// The source of the picture's numbers.
    pub points: PointSet,
    /// Threads; 0 for one a processor. Does not change the plan.
    pub threads: usize,
}

impl Request {
    /// The request of a method that leaves its choice to a plan, for a picture of these settings;
    /// `None` of any other method.
    pub fn of(method: Method, settings: &Settings) -> Option<Self> {
        let Auto { may_lose } = method.auto()?;
        let max_depth = method.limits().and_then(|limits| limits.max_depth);
        let Settings { spp, seed, threads, points } = *settings;
        Some(Self { max_depth, may_lose: may_lose.part(), spp, seed, points, threads })
    }
}

/// The chosen method with the evidence for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// The method to render by.
    pub method: Method,
    /// The evidence for it; `None` if the picture is too small to spend anything on it.
    pub evidence: Option<Evidence>,
}
