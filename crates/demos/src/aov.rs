//! Layers of a picture beside its light.

use clap::ValueEnum;
use traylib_integrators::FirstHit;

/// A layer of an EXR picture beside its light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub enum Aov {
    /// The part of the light that the surface scatters which is seen first
    Albedo,
    /// Its shading normal, on the side of the camera
    Normal,
    /// Its distance from the camera in metres
    Depth,
    /// The estimated variance of each pixel, as its passes tell it
    Variance,
}

impl Aov {
    /// The picture of first surfaces that it is, if it is one.
    pub(crate) fn first_hit(self) -> Option<FirstHit> {
        match self {
            Self::Albedo => Some(FirstHit::Albedo),
            Self::Normal => Some(FirstHit::Normal),
            Self::Depth => Some(FirstHit::Depth),
            Self::Variance => None,
        }
    }

    /// The name of its layer.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Albedo => "albedo",
            Self::Normal => "normal",
            Self::Depth => "depth",
            Self::Variance => "variance",
        }
    }

    /// The names of its channels.
    pub(crate) fn channels(self) -> &'static [&'static str] {
        match self {
            Self::Albedo | Self::Variance => &["R", "G", "B"],
            Self::Normal => &["X", "Y", "Z"],
            Self::Depth => &["Z"],
        }
    }
}
