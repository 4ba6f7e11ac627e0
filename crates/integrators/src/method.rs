//! The choice of an integrator with its settings: the one list of them.
//!
//! A [`Method`] is data. Its spelling is a command line without a scene, as
//! `directlight --combine`; [`Method::build`] makes the [`Integrator`].

mod engine;
mod given;
mod option;
mod spelling;
#[cfg(test)]
mod tests;

pub use engine::Engine;
pub use option::{MethodOption, MethodSetting, OptionValues};
pub use spelling::MethodError;

use crate::bdpt::{BdptSettings, MayLose, PathsPerPixel};
use crate::directlight::DirectLightOfPixel;
use crate::{
    Auto, DirectLight, Integrator, LightSampling, Limits, Particle, PureMc, Report, Roulette,
    Techniques, Trace,
};
use given::Given;
use traylib_math::Heuristic;

/// The choice of an integrator with its settings.
///
/// Where an integrator is nothing but its settings, it stands for them. `Display` and
/// `FromStr` are each other's inverse, as `bdpt --max-depth 6 --no-connections`, for all that
/// can be spelled: a roulette from edge 1, or none without a longest path, cannot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// `trace`.
    Trace(Trace),
    /// `puremc`.
    PureMc(PureMc),
    /// `directlight`, strict or with `--combine`.
    DirectLight(DirectLight),
    /// `particle`.
    Particle(Particle),
    /// `bdpt`.
    Bdpt(BdptSettings),
}

impl Method {
    /// `trace`, as one sample a pixel is rendered.
    pub const TRACE: Self = Self::Trace(Trace { jitter: false });
    /// `trace --jitter`, as a mean of samples is.
    pub const JITTERED_TRACE: Self = Self::Trace(Trace { jitter: true });
    /// `puremc`.
    pub const PURE_MC: Self = Self::PureMc(PureMc { limits: Limits::OF_CAMERA_WALKS });
    /// `directlight`, strict as in the paper.
    pub const DIRECT_LIGHT: Self = Self::DirectLight(DirectLight {
        limits: Limits::OF_CAMERA_WALKS,
        combine: None,
        no_images: false,
    });
    /// `directlight --combine`, weighted by the power heuristic.
    pub const COMBINED: Self = Self::DirectLight(DirectLight {
        limits: Limits::OF_CAMERA_WALKS,
        combine: Some(Heuristic::Power),
        no_images: false,
    });
    /// `particle`.
    pub const PARTICLE: Self = Self::Particle(Particle { limits: Limits::NONE });
    /// `bdpt`, weighted by the power heuristic.
    pub const BDPT: Self = Self::Bdpt(BdptSettings::DEFAULT);
    /// `bdpt --auto`: the method that a [plan](crate::planner) chooses.
    pub const AUTO: Self = Self::Bdpt(BdptSettings {
        auto: Some(Auto { may_lose: MayLose::NOTHING }),
        ..BdptSettings::DEFAULT
    });

    /// Each as it is without any option.
    pub const ALL: [Self; 5] = {
        let mut all = [Self::TRACE; 5];
        let mut last = 0;
        while let Some(next) = all[last].after() {
            last += 1;
            assert!(last < all.len(), "there are more methods");
            all[last] = next;
        }
        assert!(last + 1 == all.len(), "there are fewer methods");
        all
    };

    /// The methods that tables and charts compare: estimators of the mean over a pixel, each as it
    /// is by default.
    pub const COMPARED: [Self; 6] = [
        Self::JITTERED_TRACE,
        Self::PURE_MC,
        Self::DIRECT_LIGHT,
        Self::COMBINED,
        Self::PARTICLE,
        Self::BDPT,
    ];

    /// The next of [`ALL`](Self::ALL); a match, so that no method is forgotten there.
    const fn after(self) -> Option<Self> {
        match self {
            Self::Trace(_) => Some(Self::PURE_MC),
            Self::PureMc(_) => Some(Self::DIRECT_LIGHT),
            Self::DirectLight(_) => Some(Self::BDPT),
            Self::Bdpt(_) => Some(Self::PARTICLE),
            Self::Particle(_) => None,
        }
    }

    /// The first word of its spelling, which methods with other settings share.
    pub fn name(self) -> &'static str {
        match self {
            Self::Trace(_) => "trace",
            Self::PureMc(_) => "puremc",
            Self::DirectLight(_) => "directlight",
            Self::Particle(_) => "particle",
            Self::Bdpt(_) => "bdpt",
        }
    }

    /// Returns a description in one line, and further remarks if there are any.
    pub fn about(self) -> (&'static str, Option<&'static str>) {
        match self {
            Self::Trace(_) => {
                ("One ray a pixel with a shadow ray to each point lamp; no interreflection", None)
            }
            Self::PureMc(_) => {
                ("Pure Monte Carlo path tracing: walks from the camera until a lamp is hit", None)
            }
            Self::DirectLight(_) => (
                "Path tracing that aims at a lamp from every vertex",
                Some(
                    "A lamp that the path hits by itself counts only where no lamp could have \
                     been aimed at: seen directly, or after a perfect mirror. With --combine both \
                     count everywhere, weighted.",
                ),
            ),
            Self::Particle(_) => (
                "Particle tracing: walks from the lamps, splatted where the camera sees them",
                None,
            ),
            Self::Bdpt(_) => (
                "Bidirectional path tracing: all ways to join walks from both ends, weighted",
                None,
            ),
        }
    }

    /// The options that it takes, in the order of help texts and spellings.
    pub fn options(self) -> &'static [MethodOption] {
        use MethodOption::{
            Auto, Combine, DirectSum, Heuristic, Jitter, LightPaths, MaxDepth, NoConnections,
            NoImages, NoSplats, Roulette,
        };
        match self {
            Self::Trace(_) => &[Jitter],
            Self::PureMc(_) | Self::Particle(_) => &[MaxDepth, Roulette],
            Self::DirectLight(_) => &[MaxDepth, Roulette, Combine, Heuristic, NoImages],
            Self::Bdpt(_) => &[
                MaxDepth,
                Roulette,
                Heuristic,
                DirectSum,
                NoConnections,
                NoSplats,
                LightPaths,
                NoImages,
                Auto,
            ],
        }
    }

    /// Returns the bounds on the length of its paths; `None` if their length is fixed.
    pub fn limits(self) -> Option<Limits> {
        match self {
            Self::Trace(_) => None,
            Self::PureMc(PureMc { limits })
            | Self::DirectLight(DirectLight { limits, .. })
            | Self::Particle(Particle { limits })
            | Self::Bdpt(BdptSettings { limits, .. }) => Some(limits),
        }
    }

    /// The loop that it is, on which the prices of its work depend.
    pub fn engine(self) -> Engine {
        match self {
            Self::Trace(_) | Self::PureMc(_) => Engine::PureMc,
            Self::DirectLight(_) => Engine::DirectLight,
            Self::Particle(_) => Engine::Particle,
            Self::Bdpt(_) => Engine::Bdpt,
        }
    }

    /// Limits that hold where none are given.
    pub(crate) fn default_limits(self) -> Limits {
        match self {
            Self::PureMc(_) | Self::DirectLight(_) => Limits::OF_CAMERA_WALKS,
            Self::Trace(_) | Self::Particle(_) | Self::Bdpt(_) => Limits::NONE,
        }
    }

    /// Returns the method with these limits, where it has any.
    #[must_use]
    pub fn with_limits(self, limits: Limits) -> Self {
        match self {
            Self::Trace(_) => self,
            Self::PureMc(_) => Self::PureMc(PureMc { limits }),
            Self::DirectLight(own) => Self::DirectLight(DirectLight { limits, ..own }),
            Self::Particle(_) => Self::Particle(Particle { limits }),
            Self::Bdpt(own) => Self::Bdpt(BdptSettings { limits, ..own }),
        }
    }

    /// Returns the method for paths of at most so many edges.
    #[must_use]
    pub fn up_to(self, max_depth: Option<u32>) -> Self {
        let limits = self.limits().unwrap_or_default();
        self.with_limits(Limits { max_depth, ..limits })
    }

    /// Returns the method for pictures of many samples a pixel, which find its mean: `trace` then
    /// draws their places.
    #[must_use]
    pub fn for_many_samples(self) -> Self {
        match self {
            Self::Trace(_) => Self::JITTERED_TRACE,
            Self::PureMc(_) | Self::DirectLight(_) | Self::Particle(_) | Self::Bdpt(_) => self,
        }
    }

    /// Tells by which techniques of bidirectional path tracing it finds light; lamps are seen
    /// directly by all.
    pub fn techniques(self) -> Techniques {
        let from_camera = Techniques { hits: false, ..Techniques::COMBINED };
        match self {
            Self::Trace(_) => {
                let light_samples = LightSampling::PointLights;
                Techniques { light_samples, mirror_connections: false, ..from_camera }
            }
            Self::PureMc(_) => Techniques::PURE_MC,
            Self::DirectLight(DirectLight { combine, no_images, .. }) => Techniques {
                hits: combine.is_some(),
                mirror_connections: !no_images,
                ..Techniques::COMBINED
            },
            Self::Particle(_) => Techniques::PARTICLE,
            Self::Bdpt(settings) => settings.techniques(),
        }
    }

    /// Returns the freedom of the plan, if one is to choose the method.
    pub fn auto(self) -> Option<Auto> {
        match self {
            Self::Bdpt(BdptSettings { auto, .. }) => auto,
            Self::Trace(_) | Self::PureMc(_) | Self::DirectLight(_) | Self::Particle(_) => None,
        }
    }

    /// Light paths for each pixel of a pass, where it has any.
    pub(crate) fn light_paths_per_pixel(self) -> f64 {
        match self {
            Self::Bdpt(BdptSettings { light_paths, .. }) => light_paths.ratio(),
            Self::Trace(_) | Self::PureMc(_) | Self::DirectLight(_) | Self::Particle(_) => 1.0,
        }
    }

    /// The integrator.
    pub fn build(self) -> Box<dyn Integrator> {
        self.build_with(Report::None)
    }

    /// The integrator that records this, too: `bdpt`, or `directlight` the paths of a pixel;
    /// others have nothing to report.
    pub fn build_with(self, report: Report) -> Box<dyn Integrator> {
        match self {
            Self::Trace(trace) => Box::new(trace),
            Self::PureMc(pure_mc) => Box::new(pure_mc),
            Self::DirectLight(own) => match report {
                Report::Pixel(pixel) => Box::new(DirectLightOfPixel { own, pixel }),
                Report::None | Report::Techniques | Report::Paths => Box::new(own),
            },
            Self::Particle(particle) => Box::new(particle),
            Self::Bdpt(settings) => Box::new(settings.integrator(report)),
        }
    }

    /// Returns all that is set, whether by an option or by default, in the order of
    /// [`options`](Self::options).
    pub fn settings(self) -> Vec<MethodSetting> {
        let mut settings = Vec::new();
        // All else is for the plan to set.
        if let Self::Bdpt(BdptSettings { auto: Some(auto), limits, .. }) = self {
            settings.extend(limits.max_depth.map(MethodSetting::MaxDepth));
            let may_lose = Some(auto.may_lose).filter(|part| *part != MayLose::NOTHING);
            settings.extend(may_lose.map(MethodSetting::MayLose));
            settings.push(MethodSetting::Auto);
            return settings;
        }
        if let Some(Limits { max_depth, roulette }) = self.limits() {
            settings.extend(max_depth.map(MethodSetting::MaxDepth));
            settings.push(MethodSetting::Roulette(roulette));
        }
        match self {
            Self::Trace(own) => settings.extend(own.jitter.then_some(MethodSetting::Jitter)),
            Self::PureMc(_) | Self::Particle(_) => {}
            Self::DirectLight(own) => {
                let combined =
                    own.combine.map(|by| [MethodSetting::Combine, MethodSetting::Heuristic(by)]);
                settings.extend(combined.into_iter().flatten());
                settings.extend(own.no_images.then_some(MethodSetting::NoImages));
            }
            Self::Bdpt(own) => {
                settings.push(MethodSetting::Heuristic(own.heuristic));
                settings.extend(own.direct_sum.then_some(MethodSetting::DirectSum));
                settings.extend(own.no_connections.then_some(MethodSetting::NoConnections));
                settings.extend(own.no_splats.then_some(MethodSetting::NoSplats));
                settings.push(MethodSetting::LightPaths(own.light_paths));
                settings.extend(own.no_images.then_some(MethodSetting::NoImages));
            }
        }
        settings
    }

    /// Returns the method with one setting changed; `None` if that means nothing to it.
    #[must_use]
    pub fn and(self, setting: MethodSetting) -> Option<Self> {
        let option = setting.option();
        let mut settings = self.settings();
        settings.retain(|other| other.option() != option);
        settings.push(setting);
        let is_known = self.options().contains(&option);
        self.with(&settings).ok().filter(|_| is_known)
    }

    /// Returns the method with these settings, and what is not among them by default. They are
    /// of its [`options`](Self::options), others mean nothing to it.
    ///
    /// # Errors
    /// Fails for settings that do not go together: roulette off without a longest path, or a
    /// heuristic where nothing is weighted.
    pub fn with(self, settings: &[MethodSetting]) -> Result<Self, MethodError> {
        let given = Given::of(settings);
        let limits = limits(given, self.default_limits())?;
        let auto = auto(given)?;
        let Given { heuristic, no_images, no_connections, no_splats, direct_sum, .. } = given;
        Ok(match self {
            Self::Trace(_) => Self::Trace(Trace { jitter: given.jitter }),
            Self::PureMc(_) => Self::PureMc(PureMc { limits }),
            Self::DirectLight(_) => {
                let combine = given.combine.then(|| heuristic.unwrap_or_default());
                if combine.is_none() && heuristic.is_some() {
                    return Err(MethodError::NothingWeighted);
                }
                Self::DirectLight(DirectLight { limits, combine, no_images })
            }
            Self::Particle(_) => Self::Particle(Particle { limits }),
            Self::Bdpt(_) => Self::Bdpt(BdptSettings {
                limits,
                heuristic: heuristic.unwrap_or_default(),
                direct_sum,
                no_connections,
                no_splats,
                light_paths: given.light_paths.unwrap_or(PathsPerPixel::ONE),
                no_images,
                auto,
            }),
        })
    }
}

/// The limits among what was given, these where there are none.
fn limits(given: Given, default: Limits) -> Result<Limits, MethodError> {
    let max_depth = given.max_depth.or(default.max_depth);
    let roulette = given.roulette.unwrap_or(default.roulette);
    if roulette == Roulette::OFF && max_depth.is_none() {
        return Err(MethodError::Endless);
    }
    Ok(Limits { max_depth, roulette })
}

/// Returns the freedom of the plan, if one is asked for.
///
/// # Errors
/// Something is given that is for the plan to choose, or wants a plan that there is none.
fn auto(given: Given) -> Result<Option<Auto>, MethodError> {
    match (given.auto, given.may_lose, given.planned) {
        (false, None, _) => Ok(None),
        (false, Some(_), _) => Err(MethodError::NothingPlanned),
        (true, _, Some(option)) => Err(MethodError::Planned(option)),
        (true, may_lose, None) => Ok(Some(Auto { may_lose: may_lose.unwrap_or_default() })),
    }
}
