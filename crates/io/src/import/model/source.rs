//! A file of shapes while it is imported.

use crate::source::Location;
use crate::{Error, FormatError};
use std::borrow::Cow;

/// Reads a file of shapes, and says in its name what is wrong with it.
pub(super) struct ModelSource<'a> {
    location: &'a Location,
    /// The name in messages.
    pub(super) name: String,
}

impl<'a> ModelSource<'a> {
    pub(super) fn new(location: &'a Location) -> Self {
        Self { location, name: location.to_string() }
    }

    /// Reads all of it.
    pub(super) fn bytes(&self) -> Result<Cow<'static, [u8]>, Error> {
        self.location.read().map_err(|cause| Error::Read { file: self.name.clone(), cause })
    }

    /// Its bytes make no sense.
    pub(super) fn malformed(&self, cause: impl Into<FormatError>) -> Error {
        Error::Format { file: self.name.clone(), cause: cause.into() }
    }

    /// One of its materials cannot be rendered.
    pub(super) fn bad_material(&self, cause: traylib_materials::Error) -> Error {
        Error::Material { file: self.name.clone(), cause }
    }

    /// One of its meshes makes no scene.
    pub(super) fn bad_mesh(&self, cause: traylib_geometry::Error) -> Error {
        Error::Model { file: self.name.clone(), cause: cause.into() }
    }

    /// It has no face that can be drawn.
    pub(super) fn nothing_to_see(&self) -> Error {
        Error::NothingToSee(self.name.clone())
    }
}
