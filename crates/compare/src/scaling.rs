//! Measures how time and memory grow: with triangles, lamps, path length, pixels and threads.

mod axis;
mod measure;
mod scenes;
mod text;

pub use axis::{Axis, AxisResults, Level};
pub use text::{csv, table};

use serde::Serialize;
use traylib_integrators::Method;

/// The methods whose growth is charted.
pub const METHODS: [Method; 2] = [Method::COMBINED, Method::BDPT];

/// The measurements along every axis.
#[derive(Clone, Debug, Serialize)]
pub struct Scaling {
    /// One an axis.
    pub axes: Vec<AxisResults>,
}

/// Measures all levels of these axes that are at most `largest`; `tell` hears of each before
/// it begins.
///
/// # Errors
/// The system refuses threads, or a sphere has more triangles than a mesh may have.
pub fn measure(
    axes: &[Axis],
    largest: u64,
    mut tell: impl FnMut(Axis, u64),
) -> Result<Scaling, String> {
    let axes = axes.iter().map(|&axis| {
        let sizes = axis.sizes().into_iter().filter(|size| *size <= largest);
        let levels = sizes.map(|size| {
            tell(axis, size);
            measure::level(axis, size)
        });
        Ok(AxisResults { axis, levels: levels.collect::<Result<_, String>>()? })
    });
    Ok(Scaling { axes: axes.collect::<Result<_, String>>()? })
}
