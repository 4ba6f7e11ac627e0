//! The loop that a method runs.

/// Methods that share a loop, and so the prices of their work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Engine {
    /// `puremc`.
    PureMc,
    /// `directlight`.
    DirectLight,
    /// `particle`.
    Particle,
    /// `bdpt`.
    Bdpt,
}

impl Engine {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::PureMc, Self::DirectLight, Self::Particle, Self::Bdpt];
}
