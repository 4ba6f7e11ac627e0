//! Settings of a command line, each in its place.

use super::option::{MethodOption, MethodSetting};
use crate::{MayLose, PathsPerPixel, Roulette};
use traylib_math::Heuristic;

/// The settings that were given; those that were not are `None` or false.
#[derive(Clone, Copy, Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each stands for an option of its own")]
pub(super) struct Given {
    pub(super) max_depth: Option<u32>,
    pub(super) may_lose: Option<MayLose>,
    pub(super) roulette: Option<Roulette>,
    pub(super) heuristic: Option<Heuristic>,
    pub(super) light_paths: Option<PathsPerPixel>,
    pub(super) jitter: bool,
    pub(super) combine: bool,
    pub(super) direct_sum: bool,
    pub(super) no_connections: bool,
    pub(super) no_splats: bool,
    pub(super) no_images: bool,
    pub(super) auto: bool,
    /// The first of those that a plan chooses.
    pub(super) planned: Option<MethodOption>,
}

impl Given {
    pub(super) fn of(settings: &[MethodSetting]) -> Self {
        let mut given = Self::default();
        for setting in settings {
            match *setting {
                MethodSetting::Jitter => given.jitter = true,
                MethodSetting::MaxDepth(edges) => given.max_depth = Some(edges),
                MethodSetting::MayLose(part) => given.may_lose = Some(part),
                MethodSetting::Roulette(roulette) => given.roulette = Some(roulette),
                MethodSetting::Combine => given.combine = true,
                MethodSetting::Heuristic(heuristic) => given.heuristic = Some(heuristic),
                MethodSetting::DirectSum => given.direct_sum = true,
                MethodSetting::NoConnections => given.no_connections = true,
                MethodSetting::NoSplats => given.no_splats = true,
                MethodSetting::LightPaths(paths) => given.light_paths = Some(paths),
                MethodSetting::NoImages => given.no_images = true,
                MethodSetting::Auto => given.auto = true,
            }
        }
        // All but the length of paths is a plan's own.
        let own =
            |option: &MethodOption| !matches!(option, MethodOption::MaxDepth | MethodOption::Auto);
        given.planned = settings.iter().map(|setting| setting.option()).find(own);
        given
    }
}
