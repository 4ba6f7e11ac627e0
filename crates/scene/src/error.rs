//! The reasons why a scene cannot be built.

/// A scene that makes no sense.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The camera has no direction, no extent, or is not finite.
    #[error("camera: {0}")]
    Camera(&'static str),
    /// Emitted radiance or intensity is negative or not a number.
    #[error("{what} {value:?} must be finite and not negative")]
    Emission {
        /// Radiance or intensity.
        what: &'static str,
        /// The value that was given.
        value: [f32; 3],
    },
    /// A position is not finite.
    #[error("position {0:?} must be finite")]
    Position([f32; 3]),
    /// A spot light's cone makes no sense.
    #[error("spot light: {0}")]
    Spot(&'static str),
    /// A shape that cannot be built or stored.
    #[error(transparent)]
    Geometry(#[from] traylib_geometry::Error),
    /// Nothing emits light.
    #[error("nothing in the scene emits light; give an object an emission, or add a light")]
    Dark,
    /// A mesh has no triangle with an area.
    #[error("the mesh has no triangle with an area")]
    EmptyMesh,
}
