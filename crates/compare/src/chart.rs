//! The charts of the page, as SVG inside of it or in files beside it.
//!
//! Every colour of a chart is one of [`colour`]'s, which the page's style replaces
//! by its own in a dark window.

pub(crate) mod alone;
mod axis;
mod bars;
mod canvas;
pub(crate) mod colour;
mod convergence;
mod crossings;
mod lengths;
pub(crate) mod marker;
mod oracle;
mod pareto;
mod plot;
mod scaling;
mod styles;

pub(crate) use bars::{Bar, Baseline, bars};
pub(crate) use convergence::convergence;
pub(crate) use lengths::lengths;
pub(crate) use oracle::{Quantity, oracle};
pub(crate) use pareto::{front, pareto};
pub(crate) use scaling::scaling;
pub(crate) use styles::MethodStyles;
