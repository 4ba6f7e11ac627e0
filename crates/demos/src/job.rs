//! The task of a program.

use crate::command_line::CommandLine;
use crate::explain::Explain;
use crate::options::RenderOptions;
use std::path::Path;
use traylib_integrators::{Integrator, Limits, Method, Report};
use traylib_io::{Headlight, Loaded};

/// The task of a program.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// The program's name.
    pub program: &'static str,
    /// Options that all programs have.
    pub options: &'a RenderOptions,
    /// The method that renders; `None` for an integrator that is no method.
    pub method: Option<Method>,
    /// Samples a pixel where the command line names none; `None` for the
    /// scene's number.
    pub default_spp: Option<u32>,
    /// True if a picture is wanted, false if only the output of `finish` is.
    pub wants_picture: bool,
    /// The condition on which a model is lit from the camera; one that is only checked is lit if
    /// nothing in it emits light.
    pub headlight: Headlight,
    /// A folder for what `finish` writes.
    pub folder: Option<&'a Path>,
    /// The most pictures that there may be beside the picture, to find out beforehand whether there
    /// is memory for them.
    pub layers: u64,
    /// The form in which a plan is explained, if one is made.
    pub explain: Option<Explain>,
}

impl<'a> Job<'a> {
    /// The usual: a picture.
    pub fn new(program: &'static str, options: &'a RenderOptions) -> Self {
        Self {
            program,
            options,
            method: None,
            default_spp: None,
            wants_picture: true,
            headlight: Headlight::Never,
            folder: None,
            layers: 0,
            explain: None,
        }
    }

    /// A picture by the method of a command line.
    pub fn of<O>(line: &'a CommandLine<O>) -> Self {
        let CommandLine { render, method, .. } = line;
        Self { method: Some(*method), ..Self::new(method.name(), render) }
    }

    /// The integrator of its method, which also records this.
    ///
    /// # Panics
    /// If it has none.
    pub fn build(&self, report: Report) -> Box<dyn Integrator> {
        self.method.expect("a job by a method").build_with(report)
    }

    /// The limits on its paths.
    pub(crate) fn limits(&self) -> Limits {
        self.method.and_then(Method::limits).unwrap_or_default()
    }

    /// Tells whether pictures come of it; a part of a rendering is kept for others.
    pub(crate) fn makes_pictures(&self) -> bool {
        self.options.keep.shard.is_none()
    }

    /// Returns the number of passes that are asked for; `None` if it is the time that ends them.
    pub(crate) fn spp(&self, loaded: &Loaded) -> Option<u32> {
        let default = self.default_spp.unwrap_or(loaded.settings.spp);
        self.options.spp.or(self.options.time_limit.is_none().then_some(default))
    }
}
