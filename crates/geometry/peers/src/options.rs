//! The command line.

use clap::{Parser, ValueEnum};

/// Casts the same rays in the same rooms by this crate and by its peers.
#[derive(Debug, Parser)]
pub(crate) struct Options {
    /// Which rooms: about a thousand, seventy thousand and a million triangles
    #[arg(long, value_delimiter = ',', default_value = "small,medium,large")]
    pub(crate) rooms: Vec<RoomSize>,
    /// How often each set of rays is cast by everyone in turn
    #[arg(long, default_value_t = 9, value_parser = clap::value_parser!(u16).range(9..1000))]
    pub(crate) runs: u16,
    /// Rays come from a picture of this many pixels squared
    #[arg(long, default_value_t = 256, value_parser = clap::value_parser!(u32).range(8..=4096))]
    pub(crate) side: u32,
    /// Only rivals whose name contains one of these; our own always take part
    #[arg(long, value_delimiter = ',')]
    pub(crate) only: Vec<String>,
    /// How many rays are aimed at the seams of a closed mesh
    #[arg(long, default_value_t = 200_000)]
    pub(crate) seam_rays: usize,
    /// Do not look for leaks
    #[arg(long)]
    pub(crate) without_leaks: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum RoomSize {
    Small,
    Medium,
    Large,
}
