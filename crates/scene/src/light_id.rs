//! A lamp by its number.

/// Names a lamp of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LightId(pub(crate) u32);
