//! Places on the page that links lead to.

/// The name of a scene's place on the page.
pub(crate) fn anchor(index: usize) -> String {
    format!("scene-{}", index + 1)
}
