//! Defects planted on purpose, to see that a test finds each.
//!
//! A build with `--cfg planted` has them all asleep and wakes the one that the
//! environment names in [`VARIABLE`]; in any other build [`planted`] is the
//! constant `false`, and nothing of them is left in the program.
//! `cargo xtask planted` runs the tests against each in turn.

/// The variable of the environment that names a defect.
pub const VARIABLE: &str = "TRAYLIB_PLANTED";

/// A mistake that a renderer may well have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defect {
    /// The cosine at a vertex joined to the camera is left out.
    SplatCosine,
    /// Weights count one light path, however many there are. The mean stays.
    LightPathsIgnoredInWeights,
    /// The light of splats is divided by the number of light paths twice.
    LightPathsDividedTwice,
    /// Weights take the density of emission for that of light sampling, which
    /// leaves the mean as well.
    EmissionForLightSampling,
    /// Light sampling forgets the chance to choose the lamp.
    LightChoiceForgotten,
    /// Light paths carry no correction for shading normals.
    AdjointMissing,
    /// The lobe is drawn around the normal.
    LobeAroundNormal,
    /// Directions below the surface are folded up, their density unchanged.
    BelowHorizonFolded,
    /// Survivors of roulette count no more, on light paths.
    RouletteUnpaid,
    /// An edge after an ideal reflection is taken for another.
    DeltaFlagStays,
    /// Hits of a lamp count beside light samples in strict `directlight`.
    HitsCountedTwice,
    /// Paths that end at the camera may be one edge too long.
    SplatsTooLong,
    /// Splats land one pixel to the right.
    RasterShifted,
    /// The shading normal decides which side emits.
    EmissionByShadingNormal,
    /// One conversion of densities forgets the distance.
    DistanceForgotten,
    /// Powers of cosines by `powf`.
    PowerByPowf,
    /// Rays start a fixed length off a surface.
    AbsoluteEpsilon,
    /// Light is summed in single precision and in whatever order, as atomics do.
    SplatsAsAtomics,
    /// The bound on error of a flat surface vanishes in a plane of coordinates.
    FlatErrorVanishes,
    /// A product of lengths that meets a ball is formed in single precision.
    ProductLeavesSingle,
    /// Parallelograms end exactly at their edges.
    EdgesExact,
    /// Light samples and light paths leave out a lamp's opacity.
    LampOpacityForgotten,
    /// A lamp is sampled for points of its own convex surface.
    LampLightsItself,
    /// A lamp in the plane of another surface stays where it is.
    LampStaysFlush,
    /// A point light in a surface is taken for one in free space.
    PointInSurfaceLost,
    /// Long paths that survive count no more.
    LongPathsUnpaid,
    /// The light tree takes tubes and cones for flat lamps.
    TubeTakenForFlat,
    /// Lamps are chosen by power alone, so that a faint one starts no light path.
    FaintLampUnchosen,
}

impl Defect {
    /// All of them.
    pub const ALL: [Self; 28] = [
        Self::SplatCosine,
        Self::LightPathsIgnoredInWeights,
        Self::LightPathsDividedTwice,
        Self::EmissionForLightSampling,
        Self::LightChoiceForgotten,
        Self::AdjointMissing,
        Self::LobeAroundNormal,
        Self::BelowHorizonFolded,
        Self::RouletteUnpaid,
        Self::DeltaFlagStays,
        Self::HitsCountedTwice,
        Self::SplatsTooLong,
        Self::RasterShifted,
        Self::EmissionByShadingNormal,
        Self::DistanceForgotten,
        Self::PowerByPowf,
        Self::AbsoluteEpsilon,
        Self::SplatsAsAtomics,
        Self::FlatErrorVanishes,
        Self::ProductLeavesSingle,
        Self::EdgesExact,
        Self::LampOpacityForgotten,
        Self::LampLightsItself,
        Self::LampStaysFlush,
        Self::PointInSurfaceLost,
        Self::LongPathsUnpaid,
        Self::TubeTakenForFlat,
        Self::FaintLampUnchosen,
    ];
}

/// Whether this defect is awake.
#[cfg(not(planted))]
#[inline]
pub const fn planted(_: Defect) -> bool {
    false
}

/// Whether this defect is awake.
///
/// # Panics
/// If the environment names a defect that there is not: a run without it would
/// pass for a proof.
#[cfg(planted)]
pub fn planted(defect: Defect) -> bool {
    use std::sync::LazyLock;
    static AWAKE: LazyLock<Option<Defect>> = LazyLock::new(|| {
        let name = std::env::var(VARIABLE).ok()?;
        let named = Defect::ALL.into_iter().find(|defect| format!("{defect:?}") == name);
        assert!(named.is_some(), "{VARIABLE}: there is no defect {name}");
        named
    });
    *AWAKE == Some(defect)
}
