//! The contents of a scene file, as plain data.

use super::{Error, Fault, WarningKind};
use crate::warning_counts::WarningCounts;
use traylib_math::glam::DAffine3;

/// The contents of a file and of all that it includes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// All objects, in the order in which they begin in the file.
    pub objects: Vec<Object>,
    /// The indices of the objects that stand in the scene itself.
    pub roots: Vec<usize>,
    /// The names of the files, the first of which includes the others.
    pub files: Vec<String>,
    /// The warnings: what was skipped.
    pub warnings: WarningCounts<WarningKind>,
}

impl Document {
    /// Makes a fault at a place of this document an error.
    pub fn error(&self, place: Place, fault: Fault) -> Error {
        let Place { file, line, column } = place;
        let file = self.files.get(file).cloned().unwrap_or_default();
        Error { file, line, column, fault }
    }
}

/// A place in one of the files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// Index of the file.
    pub file: usize,
    /// The line, from 1.
    pub line: u32,
    /// The character in it, from 1.
    pub column: u32,
}

/// An object of the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// Its class.
    pub class: Class,
    /// Its type, as `sphere` or `diffuse`.
    pub kind: String,
    /// The name by which others refer to it, or none.
    pub id: String,
    /// The place at which it begins.
    pub place: Place,
    /// Whether its file is of a version before 2.
    pub is_old: bool,
    /// Its properties in the order of the file.
    pub properties: Vec<Property>,
    /// The objects within it, also those that it refers to.
    pub children: Vec<Child>,
}

/// The classes of objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Class {
    /// Something to be seen.
    Shape,
    /// A way to scatter light.
    Bsdf,
    /// A light.
    Emitter,
    /// A camera.
    Sensor,
    /// The film of a camera.
    Film,
    /// A source of random numbers.
    Sampler,
    /// Values over a surface.
    Texture,
    /// An algorithm.
    Integrator,
    /// A filter of pixels.
    Filter,
    /// Fog and the like, and what belongs to it.
    Medium,
}

impl Class {
    /// The class of an element, if it is an object.
    pub(super) fn of(tag: &str) -> Option<Self> {
        Some(match tag {
            "shape" => Self::Shape,
            "bsdf" => Self::Bsdf,
            "emitter" => Self::Emitter,
            "sensor" => Self::Sensor,
            "film" => Self::Film,
            "sampler" => Self::Sampler,
            "texture" => Self::Texture,
            "integrator" => Self::Integrator,
            "rfilter" => Self::Filter,
            "medium" | "volume" | "phase" | "subsurface" => Self::Medium,
            _ => return None,
        })
    }

    /// Returns the name of its elements.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shape => "shape",
            Self::Bsdf => "bsdf",
            Self::Emitter => "emitter",
            Self::Sensor => "sensor",
            Self::Film => "film",
            Self::Sampler => "sampler",
            Self::Texture => "texture",
            Self::Integrator => "integrator",
            Self::Filter => "rfilter",
            Self::Medium => "medium",
        }
    }
}

/// A value of an object.
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// Its name.
    pub name: String,
    /// Its value.
    pub value: Value,
}

/// The values that there are. All numbers are finite.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `float` or `integer`.
    Number(f64),
    /// `boolean`.
    Boolean(bool),
    /// `string`.
    Text(String),
    /// `point` or `vector`.
    Vector([f64; 3]),
    /// `rgb`, or what comes to it: linear, by the primaries of Rec. 709.
    Colour([f64; 3]),
    /// A `spectrum` that is the same at all wavelengths.
    Even(f64),
    /// A `spectrum` by wavelengths in nm, ascending, with values between which it is linear.
    Spectrum(Vec<[f64; 2]>),
    /// A `spectrum` that stands elsewhere, or a black body's.
    OtherSpectrum,
    /// `transform`.
    Transform(DAffine3),
}

/// An object within another.
#[derive(Clone, Debug, PartialEq)]
pub struct Child {
    /// The name by which the object around it uses it, or empty.
    pub name: String,
    /// Its index among all objects.
    pub object: usize,
}
