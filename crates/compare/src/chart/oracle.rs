//! Measured noise over what theory says.

use crate::chart::axis::{Decades, drawable};
use crate::chart::canvas::{Failed, HALF, svg};
use crate::chart::colour::{INK, MUTED};
use crate::chart::plot::{Plot, Stroke};
use crate::chart::styles::{MethodStyles, Style};
use crate::results::{Estimate, Oracle, OracleCrossing, OraclePoint};
use maud::Markup;

const SIZE: (u32, u32) = (HALF, 640);

/// The quantity drawn over R/h.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    /// Variance of one sample, in units of (ρ·Le)².
    Variance,
    /// Variance times seconds of a sample.
    Cost,
}

impl Quantity {
    fn name(self) -> &'static str {
        match self {
            Self::Variance => "variance of a sample, in (ρ·Le)²",
            Self::Cost => "variance × seconds",
        }
    }

    fn factor(self, point: &OraclePoint) -> f64 {
        match self {
            Self::Variance => 1.0,
            Self::Cost => point.seconds,
        }
    }

    fn crossing(self, oracle: &Oracle) -> OracleCrossing {
        match self {
            Self::Variance => oracle.crossing,
            Self::Cost => oracle.crossing_in_time,
        }
    }
}

/// Theory as lines, measurements as points over them, the crossing as a level.
pub(crate) fn oracle(oracle: &Oracle, quantity: Quantity, styles: &MethodStyles) -> Markup {
    let label = format!("{} against R/h, measured and by theory", quantity.name());
    svg(&label, SIZE, |area| {
        let points = || oracle.curves.iter().flat_map(|curve| &curve.points);
        let both = |p: &OraclePoint| [p.theory, p.variance.value].map(|v| v * quantity.factor(p));
        let x = Decades::around(points().map(|point| point.radius));
        let y = Decades::around(points().flat_map(both));
        let plot = Plot::new(area, (x, "R/h"), (y, quantity.name()))?;
        crossing(&plot, quantity.crossing(oracle).measured.value)?;
        for curve in &oracle.curves {
            let style = styles.style(&curve.method);
            theory(&plot, &curve.points, quantity, style)?;
            measured(&plot, &curve.points, quantity, style)?;
        }
        Ok(())
    })
}

fn crossing(plot: &Plot<'_, '_>, radius: f64) -> Result<(), Failed> {
    if !drawable(radius) {
        return Ok(());
    }
    let (low, high) = plot.y_ends();
    plot.line(&[(radius, low), (radius, high)], MUTED, 2, Stroke::Dashed(6))
}

fn theory(
    plot: &Plot<'_, '_>,
    points: &[OraclePoint],
    quantity: Quantity,
    style: Style,
) -> Result<(), Failed> {
    let along = points.iter().map(|p| (p.radius, p.theory * quantity.factor(p)));
    let drawn: Vec<_> = along.filter(|(x, y)| drawable(*x) && drawable(*y)).collect();
    plot.line(&drawn, style.colour(), 3, Stroke::Solid)
}

fn measured(
    plot: &Plot<'_, '_>,
    points: &[OraclePoint],
    quantity: Quantity,
    style: Style,
) -> Result<(), Failed> {
    for point in points.iter().filter(|p| drawable(p.radius) && drawable(p.variance.value)) {
        let Estimate { value, low, high } = point.variance;
        let [value, low, high] = [value, low, high].map(|v| v * quantity.factor(point));
        let ends = [low, high].map(|v| plot.place((point.radius, v)));
        plot.segment(ends[0], ends[1], INK, 3)?;
        plot.marker((point.radius, value), style.mark(), 9.0, true)?;
    }
    Ok(())
}
