//! The chart of how a quantity grows along an axis.

use crate::chart::alone::{Key, alone, named};
use crate::chart::axis::{Decades, drawable};
use crate::chart::canvas::{BREADTH, svg};
use crate::chart::plot::{Plot, Stroke};
use crate::chart::styles::MethodStyles;
use crate::scaling::{AxisResults, METHODS};

/// Seconds of a sample by each method against what grows, as a file of its own; `None` if it
/// could not be drawn.
pub(crate) fn scaling(results: &AxisResults) -> Option<String> {
    let names = METHODS.map(|method| method.to_string());
    let styles = MethodStyles::of_names(&names);
    let levels = || results.levels.iter();
    let label = format!("Seconds of a sample against {}", results.axis.name());
    let chart = svg(&label, (BREADTH, 700), |area| {
        let x = Decades::around(levels().map(|level| level.size as f64));
        let times = levels().flat_map(|level| &level.sample_seconds);
        let y = Decades::around(times.flat_map(|time| [time.low, time.high]));
        let plot = Plot::new(area, (x, results.axis.name()), (y, "seconds of a sample"))?;
        for (number, name) in names.iter().enumerate() {
            let style = styles.style(name);
            let points: Vec<_> = levels()
                .map(|level| (level.size as f64, level.sample_seconds[number].value))
                .filter(|point| drawable(point.1))
                .collect();
            plot.line(&points, style.colour(), 3, Stroke::Solid)?;
            points.iter().try_for_each(|&point| plot.marker(point, style.mark(), 9.0, true))?;
        }
        Ok(())
    });
    let keys: Vec<Key> = names.iter().map(|name| named(name, &styles)).collect();
    alone(&chart, &keys)
}
