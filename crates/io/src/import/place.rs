//! Places in scene files that errors can name.

use crate::locate::{Path, Step};
use crate::report::{Problem, Problems, SourceText, Spot};
use std::fmt::Display;
use std::sync::Arc;
use traylib_math::Rgb;

/// A value in a scene file.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub(super) source: Arc<SourceText>,
    pub(super) path: Path,
}

impl Place {
    pub(super) fn field(&self, name: &'static str) -> Self {
        Self { source: Arc::clone(&self.source), path: self.path.field(name) }
    }

    pub(super) fn then(&self, step: Step) -> Self {
        Self { source: Arc::clone(&self.source), path: self.path.then(step) }
    }

    /// Something is wrong with this value.
    pub(super) fn problem(&self, message: impl Display) -> Problem {
        self.labelled(message, "")
    }

    /// [`problem`](Self::problem) with words beside the value.
    pub(super) fn labelled(&self, message: impl Display, label: impl Into<String>) -> Problem {
        let spot = Spot::Value(self.path.clone());
        Problem { spot, label: label.into(), ..self.missing(message) }
    }

    /// Something is wrong with the file that stands nowhere in it.
    pub(super) fn missing(&self, message: impl Display) -> Problem {
        Problem {
            source: Arc::clone(&self.source),
            spot: Spot::Nowhere,
            title: message.to_string(),
            label: String::new(),
            help: None,
        }
    }

    /// The value of a result; an error becomes a problem here.
    pub(super) fn note<T, E: Display>(
        &self,
        result: Result<T, E>,
        problems: &mut Problems,
    ) -> Option<T> {
        result.map_err(|error| problems.push(self.problem(error))).ok()
    }

    /// Refuses light that is negative or not finite.
    pub(super) fn check_light(&self, what: &str, light: Rgb, problems: &mut Problems) {
        if !(light.is_finite() && light.min_band() >= 0.0) {
            let message = format!("the {what} must be finite and not negative in each band");
            problems.push(self.problem(message));
        }
    }
}
