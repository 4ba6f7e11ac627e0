//! Which method looks how, everywhere on the page.

use crate::chart::colour::{METHODS, method};
use crate::chart::marker::SHAPES;
use crate::chart::plot::Mark;
use crate::results::Results;
use plotters::style::RGBColor;

/// Colour and marker of a method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Look {
    /// Number of the colour, from zero.
    pub(crate) slot: usize,
    /// Number of the marker.
    pub(crate) shape: usize,
}

impl Look {
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
pub(crate) struct Palette {
    names: Vec<String>,
}

impl Palette {
    /// Of all scenes and of the oracle.
    pub(crate) fn of(results: &Results) -> Self {
        let methods = results.scenes.iter().flat_map(|scene| &scene.methods).map(|m| &m.name);
        let curves = results.oracle.iter().flat_map(|oracle| &oracle.curves).map(|c| &c.method);
        Self::of_names(methods.chain(curves))
    }

    /// Of methods by their names.
    pub(crate) fn of_names<'a>(all: impl IntoIterator<Item = &'a String>) -> Self {
        let mut names: Vec<String> = Vec::new();
        for name in all {
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
        Self { names }
    }

    /// The look of a method; one that is not known looks like one more.
    pub(crate) fn look(&self, name: &str) -> Look {
        Look::of(self.names.iter().position(|n| n == name).unwrap_or(self.names.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forty_methods_look_different() {
        let looks: Vec<Look> = (0..METHODS * SHAPES).map(Look::of).collect();
        for (i, look) in looks.iter().enumerate() {
            assert!(!looks[..i].contains(look), "{look:?}");
        }
    }
}
