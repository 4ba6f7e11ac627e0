//! Materials of surfaces.

use std::sync::Arc;
use traylib_math::Rgb;

/// An amount of light with its colour.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Part {
    /// The amount: a fraction in 0..1 of what arrives, or lm/m².
    pub amount: f32,
    /// Its colour in linear Rec. 709, with a luminance of one: equal energy is
    /// white. Saturated colours have bands over one.
    pub colour: Rgb,
}

impl Part {
    /// Amount and colour together.
    pub fn rgb(self) -> Rgb {
        self.colour * self.amount
    }
}

/// A material of a surface. The four fractions sum to one at most.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Its name; empty for the unnamed one.
    pub name: Arc<str>,
    /// True if the back is like the front; else it is invisible.
    pub two_sided: bool,
    /// Diffuse reflectance.
    pub rd: Part,
    /// Diffuse transmittance.
    pub td: Part,
    /// Specular reflectance.
    pub rs: Part,
    /// Roughness of the reflection: the rms slope of its facets, 0 for a mirror.
    pub rs_roughness: f32,
    /// Specular transmittance.
    pub ts: Part,
    /// Roughness of the transmission.
    pub ts_roughness: f32,
    /// Emittance in lm/m², of each side that is there.
    pub ed: Part,
    /// Index of refraction, real and imaginary.
    pub ir: [f32; 2],
}

impl Material {
    /// Tells whether it emits light.
    pub fn emits(&self) -> bool {
        self.ed.amount > 0.0
    }
}
