//! The style of each method, the same everywhere on the page.

use crate::chart::colour::{METHODS, method};
use crate::chart::marker::SHAPES;
use crate::chart::plot::Mark;
use crate::results::Results;
use plotters::style::RGBColor;

/// Colour and marker of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Style {
    /// Number of the colour, from zero.
    pub(crate) slot: usize,
    /// Number of the marker.
    pub(crate) shape: usize,
}

impl Style {
    fn of(index: usize) -> Self {
        let slot = index % METHODS;
        Self { slot, shape: (slot + index / METHODS) % SHAPES }
    }

    /// The colour in charts.
    pub(crate) fn colour(self) -> RGBColor {
        method(self.slot)
    }

    /// The marker in charts.
    pub(crate) fn mark(self) -> Mark {
        (self.shape, self.colour())
    }
}

/// All methods of a comparison, in the order in which they first appear.
#[derive(Debug)]
pub(crate) struct MethodStyles {
    names: Vec<String>,
}

impl MethodStyles {
    /// Gives colours to the methods of all scenes and of the oracle.
    pub(crate) fn of(results: &Results) -> Self {
        let methods = results.scenes.iter().flat_map(|scene| &scene.methods).map(|m| &m.name);
        let curves = results.oracle.iter().flat_map(|oracle| &oracle.curves).map(|c| &c.method);
        Self::of_names(methods.chain(curves))
    }

    /// Gives colours to methods by their names.
    pub(crate) fn of_names<'a>(all: impl IntoIterator<Item = &'a String>) -> Self {
        let mut names: Vec<String> = Vec::new();
        for name in all {
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
        Self { names }
    }

    /// The style of a method; one that is not known looks like one more.
    pub(crate) fn style(&self, name: &str) -> Style {
        Style::of(self.names.iter().position(|n| n == name).unwrap_or(self.names.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forty_methods_look_different() {
        let styles: Vec<Style> = (0..METHODS * SHAPES).map(Style::of).collect();
        for (i, style) in styles.iter().enumerate() {
            assert!(!styles[..i].contains(style), "{style:?}");
        }
    }
}
