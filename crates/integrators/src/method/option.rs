//! The options of methods: how they are spelled, and how their values are read.

use super::Method;
use crate::{Limits, MayLose, PathsPerPixel, Roulette};
use std::fmt;
use traylib_math::Heuristic;

/// An option of methods, with or without a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MethodOption {
    /// `--jitter`.
    Jitter,
    /// `--max-depth N`.
    MaxDepth,
    /// `--roulette EDGE`.
    Roulette,
    /// `--combine`.
    Combine,
    /// `--heuristic HEURISTIC`.
    Heuristic,
    /// `--direct-sum`.
    DirectSum,
    /// `--no-connections`.
    NoConnections,
    /// `--no-splats`.
    NoSplats,
    /// `--light-paths N`.
    LightPaths,
    /// `--no-images`.
    NoImages,
    /// `--auto`.
    Auto,
}

/// The values that may follow an option.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OptionValues {
    /// Nothing.
    None,
    /// Text of this name in help texts.
    Text(&'static str),
    /// One of these words, each with what it means, together of this name.
    OneOf(&'static str, &'static [(&'static str, &'static str)]),
}

/// An option with its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MethodSetting {
    /// Points of a pixel are drawn by chance.
    Jitter,
    /// The longest path, in edges.
    MaxDepth(u32),
    /// The longest path is the one that loses no more light than this.
    MayLose(MayLose),
    /// From where on paths may end by chance.
    Roulette(Roulette),
    /// Light samples and hits are weighted against each other.
    Combine,
    /// The heuristic that turns densities into weights.
    Heuristic(Heuristic),
    /// Weights are summed over all techniques.
    DirectSum,
    /// The techniques with s and t from 2 on take no part.
    NoConnections,
    /// The techniques with t = 1 take no part.
    NoSplats,
    /// Light paths of a pass, for each of its pixels.
    LightPaths(PathsPerPixel),
    /// Images of lamps in mirrors are neither aimed at nor joined.
    NoImages,
    /// A plan chooses the method.
    Auto,
}

impl MethodOption {
    /// Its name on a command line, without the hyphens before it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Jitter => "jitter",
            Self::MaxDepth => "max-depth",
            Self::Roulette => "roulette",
            Self::Combine => "combine",
            Self::Heuristic => "heuristic",
            Self::DirectSum => "direct-sum",
            Self::NoConnections => "no-connections",
            Self::NoSplats => "no-splats",
            Self::LightPaths => "light-paths",
            Self::NoImages => "no-images",
            Self::Auto => "auto",
        }
    }

    /// Returns the values that may follow it.
    pub fn values(self) -> OptionValues {
        match self {
            Self::MaxDepth | Self::LightPaths => OptionValues::Text("N"),
            Self::Roulette => OptionValues::Text("EDGE"),
            Self::Heuristic => OptionValues::OneOf(
                "HEURISTIC",
                &[
                    ("balance", "In proportion to the densities"),
                    ("power", "In proportion to their squares"),
                ],
            ),
            Self::Jitter
            | Self::Combine
            | Self::DirectSum
            | Self::NoConnections
            | Self::NoSplats
            | Self::NoImages
            | Self::Auto => OptionValues::None,
        }
    }

    /// The value that holds for a method where it is not given, if there is one.
    pub fn default_value(self, method: Method) -> Option<&'static str> {
        match self {
            Self::Roulette if method.default_limits() == Limits::OF_CAMERA_WALKS => Some("4"),
            Self::Roulette => Some("3"),
            Self::Heuristic => Some("power"),
            Self::LightPaths => Some("1"),
            Self::Jitter
            | Self::MaxDepth
            | Self::Combine
            | Self::DirectSum
            | Self::NoConnections
            | Self::NoSplats
            | Self::NoImages
            | Self::Auto => None,
        }
    }

    /// Returns its help text.
    pub fn help(self) -> &'static str {
        match self {
            Self::Jitter => {
                "Draw the point of a pixel by chance also of one sample, which else goes through \
                 the middle; with more samples or a --time-limit it always is"
            }
            Self::MaxDepth => {
                "Longest path in edges: 1 is a lamp seen directly, 2 direct light; light of \
                 longer paths is lost [default: none, roulette ends paths]"
            }
            Self::Roulette => {
                "First edge, from 2 on, that roulette may prevent, or `off`, which wants \
                 --max-depth"
            }
            Self::Combine => "Combine aimed and chance hits by multiple importance sampling",
            Self::Heuristic => {
                "How densities become weights; directlight takes it with --combine alone"
            }
            Self::DirectSum => {
                "Compute weights by summing over all techniques: slow, for comparison"
            }
            Self::NoConnections => {
                "Leave out the techniques that connect two walks (s and t from 2 on), which \
                 saves shadow rays; the others share their light"
            }
            Self::NoSplats => {
                "Leave out the techniques that join walks from lamps to the camera (t = 1)"
            }
            Self::LightPaths => {
                "Walks from lamps for each pixel of a pass; where there are fewer than one, one is \
                 joined with several walks from the camera"
            }
            Self::NoImages => {
                "Do not look for images of lamps in mirrors, for comparison: more noise, and less \
                 light where a mirror shows a point lamp"
            }
            Self::Auto => {
                "Find out first which method and techniques reach a given error soonest on this \
                 scene, and render by these alone; --explain tells why. With it --max-depth also \
                 takes auto:0.5%: the longest path that loses no more light than that"
            }
        }
    }

    /// The option with a value, as it stands on a command line; one without has none.
    ///
    /// # Errors
    /// Returns a description of the value that was wanted instead.
    pub fn read(self, value: &str) -> Result<MethodSetting, &'static str> {
        let alone = |setting| if value.is_empty() { Ok(setting) } else { Err("takes no value") };
        match self {
            Self::Jitter => alone(MethodSetting::Jitter),
            Self::Combine => alone(MethodSetting::Combine),
            Self::DirectSum => alone(MethodSetting::DirectSum),
            Self::NoConnections => alone(MethodSetting::NoConnections),
            Self::NoSplats => alone(MethodSetting::NoSplats),
            Self::LightPaths => value.parse().map(MethodSetting::LightPaths),
            Self::NoImages => alone(MethodSetting::NoImages),
            Self::Auto => alone(MethodSetting::Auto),
            Self::MaxDepth if value.starts_with("auto") => {
                value.parse().map(MethodSetting::MayLose)
            }
            Self::MaxDepth => {
                let edges = value.parse().ok().filter(|edges| *edges > 0);
                edges.map(MethodSetting::MaxDepth).ok_or("wanted: a number of edges from 1 on")
            }
            Self::Roulette => read_roulette(value).map(MethodSetting::Roulette),
            Self::Heuristic => match value {
                "balance" => Ok(MethodSetting::Heuristic(Heuristic::Balance)),
                "power" => Ok(MethodSetting::Heuristic(Heuristic::Power)),
                _ => Err("wanted: balance or power"),
            },
        }
    }
}

fn read_roulette(text: &str) -> Result<Roulette, &'static str> {
    match text {
        "off" => Ok(Roulette::OFF),
        _ => match text.parse() {
            Ok(from_edge) if from_edge >= 2 => Ok(Roulette { from_edge }),
            _ => Err("wanted: an edge from 2 on, or `off`"),
        },
    }
}

impl MethodSetting {
    /// The option that it belongs to.
    pub fn option(self) -> MethodOption {
        match self {
            Self::Jitter => MethodOption::Jitter,
            Self::MaxDepth(_) | Self::MayLose(_) => MethodOption::MaxDepth,
            Self::Roulette(_) => MethodOption::Roulette,
            Self::Combine => MethodOption::Combine,
            Self::Heuristic(_) => MethodOption::Heuristic,
            Self::DirectSum => MethodOption::DirectSum,
            Self::NoConnections => MethodOption::NoConnections,
            Self::NoSplats => MethodOption::NoSplats,
            Self::LightPaths(_) => MethodOption::LightPaths,
            Self::NoImages => MethodOption::NoImages,
            Self::Auto => MethodOption::Auto,
        }
    }

    /// The value; empty where there is none.
    pub fn value(self) -> String {
        match self {
            Self::MaxDepth(edges) => edges.to_string(),
            Self::MayLose(part) => part.to_string(),
            Self::Roulette(Roulette::OFF) => "off".into(),
            Self::Roulette(Roulette { from_edge }) => from_edge.to_string(),
            Self::Heuristic(Heuristic::Balance) => "balance".into(),
            Self::Heuristic(Heuristic::Power) => "power".into(),
            Self::LightPaths(paths) => paths.to_string(),
            Self::Jitter
            | Self::Combine
            | Self::DirectSum
            | Self::NoConnections
            | Self::NoSplats
            | Self::NoImages
            | Self::Auto => String::new(),
        }
    }
}

/// Writes it as on a command line: `--max-depth 6`.
impl fmt::Display for MethodSetting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, value) = (self.option().name(), self.value());
        let blank = if value.is_empty() { "" } else { " " };
        write!(f, "--{name}{blank}{value}")
    }
}
