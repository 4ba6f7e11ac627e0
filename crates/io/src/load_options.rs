//! The settings of a scene file for rendering, and the options of the caller that replace them.

use crate::ReadLimits;
use std::path::Path;

/// The settings of a scene file for rendering it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneSettings {
    /// Samples per pixel, at least one.
    pub spp: u32,
    /// Factor on radiance in 8-bit pictures, positive.
    pub exposure: f32,
}

/// The options of the caller, which replace what the file says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoadOptions<'a> {
    /// Width and height of the picture in pixels.
    pub resolution: Option<(u32, u32)>,
    /// Factor on radiance in 8-bit pictures, positive; that of the file, or one that
    /// suits its light, if none is given.
    pub exposure: Option<f32>,
    /// The folder that files included by scene files and MGF files may not leave;
    /// that of the scene, if none is given.
    pub root: Option<&'a Path>,
    /// The condition on which a file of shapes gets a point light at the camera, with a warning.
    pub headlight: Headlight,
    /// Bounds on what files may ask for.
    pub limits: ReadLimits,
}

/// The condition on which a file of shapes gets a point light at the camera.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Headlight {
    /// Never: a file without any light is an error.
    #[default]
    Never,
    /// A file in which nothing emits light gets one.
    WithoutLight,
    /// A file without a point or spot light gets one, for programs that see by these alone: also if
    /// something in it shines by itself, be it a lamp or no more than an eye.
    WithoutPointLight,
}
