//! The contestants.

mod bvh_crate;
mod embree;
mod obvhs;
mod ours;
mod parry;

use crate::options::Options;
use traylib_geometry::{Mesh, Ray};

/// A library in one of its settings.
pub(crate) struct Contestant {
    pub(crate) name: &'static str,
    build: Box<Build>,
}

type Build = dyn Fn(&Mesh) -> Result<Box<dyn Built>, String>;

/// A mesh, ready to be asked.
///
/// Rays come many at a time, so that a call through this trait costs nothing; what
/// a library does of it ray by ray is its own affair.
pub(crate) trait Built {
    /// The first hit of each ray with 0 < t < `t_max`.
    fn nearest(&mut self, rays: &[Ray], found: &mut [Found]);

    /// Tells whether each ray has any such hit.
    fn any_hit(&mut self, rays: &[Ray], found: &mut [bool]);

    /// Bytes that the process's heap does not know of.
    fn bytes_elsewhere(&self) -> usize {
        0
    }
}

/// The facts that every contestant reports of a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Found {
    /// Infinite without a hit.
    pub(crate) t: f32,
    pub(crate) primitive: u32,
}

impl Found {
    pub(crate) const NOTHING: Self = Self { t: f32::INFINITY, primitive: u32::MAX };
}

impl Contestant {
    fn new<B: Built + 'static>(
        name: &'static str,
        build: impl Fn(&Mesh) -> Result<B, String> + 'static,
    ) -> Self {
        let boxed = move |mesh: &Mesh| build(mesh).map(|built| Box::new(built) as Box<dyn Built>);
        Self { name, build: Box::new(boxed) }
    }

    /// # Errors
    /// Returns the refusal of the library, with its name.
    pub(crate) fn build(&self, mesh: &Mesh) -> Result<Box<dyn Built>, String> {
        (self.build)(mesh).map_err(|error| format!("{}: {error}", self.name))
    }
}

/// Our own, the first two of which others are compared with, then whom the options
/// let in.
pub(crate) fn chosen(options: &Options) -> Vec<Contestant> {
    let wanted = |rival: &Contestant| {
        options.only.is_empty() || options.only.iter().any(|part| rival.name.contains(part))
    };
    let rivals = obvhs::all().into_iter().chain([bvh_crate::new(), parry::new()]);
    ours::all().into_iter().chain(rivals.chain(embree::all()).filter(wanted)).collect()
}

#[cfg(test)]
mod tests;
