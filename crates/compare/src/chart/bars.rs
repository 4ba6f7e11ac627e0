//! Bars over a logarithmic axis, a row each method.

use crate::chart::axis::{Decades, drawable};
use crate::chart::canvas::{Area, BREADTH, Failed, HALF, axis_text, svg, text};
use crate::chart::colour::{GRID, INK, PAPER};
use crate::results::Estimate;
use maud::Markup;
use plotters::chart::{ChartBuilder, ChartContext};
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::types::RangedCoordf64;
use plotters::element::{PathElement, Rectangle};
use plotters::prelude::SVGBackend;
use plotters::style::text_anchor::{HPos, VPos};
use plotters::style::{Color, RGBColor};

/// Height of a row, with its name above the bar.
const ROW: u32 = 92;
/// From the top of a row to that of its bar, as a share of the row.
const NAME: f64 = 0.45;
const BAR_END: f64 = 0.88;

/// A row.
#[derive(Clone, Debug)]
pub(crate) struct Bar {
    pub(crate) name: String,
    pub(crate) colour: RGBColor,
    /// An outline alone: the number is not what it seems.
    pub(crate) hollow: bool,
    pub(crate) estimate: Estimate,
    /// The number in words.
    pub(crate) words: String,
}

/// The place where bars begin, which decides how broad their chart is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Baseline {
    /// At the left end, in a chart by itself.
    Left,
    /// At one, in one of two charts.
    One,
}

impl Baseline {
    fn breadth(self) -> u32 {
        match self {
            Self::Left => BREADTH,
            Self::One => HALF,
        }
    }
}

type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Decades, RangedCoordf64>>;

/// Bars from the first down, with whiskers from the low to the high end.
pub(crate) fn bars(label: &str, axis_name: &str, rows: &[Bar], baseline: Baseline) -> Markup {
    let rows: Vec<&Bar> = rows.iter().filter(|row| drawable(row.estimate.value)).collect();
    let height = ROW * rows.len().max(1) as u32 + 110;
    svg(label, (baseline.breadth(), height), |area| {
        let axis = axis(&rows, baseline);
        let mut chart = frame(area, axis.clone(), rows.len(), axis_name)?;
        let from = if baseline == Baseline::Left { axis.ends().0 } else { 1.0 };
        for (i, row) in rows.iter().enumerate() {
            bar(&mut chart, row, i as f64, from)?;
            words(area, &chart, row, (i as f64, axis.ends().0))?;
        }
        Ok(())
    })
}

/// Holds all bars; whiskers up to a decade beyond them.
fn axis(rows: &[&Bar], baseline: Baseline) -> Decades {
    let values = || rows.iter().map(|row| row.estimate.value).chain([1.0]);
    let low = values().fold(f64::INFINITY, f64::min) / 10.0;
    let high = values().fold(0.0, f64::max) * 10.0;
    let ends = rows.iter().filter_map(|row| whisker(row.estimate)).flatten();
    let whiskers = ends.filter(|end| drawable(*end)).map(|end| end.clamp(low, high));
    let around = Decades::around(values().chain(whiskers));
    match baseline {
        Baseline::Left => around.with_room_below(),
        Baseline::One => around,
    }
}

fn frame<'a, 'b>(
    area: &'a Area<'b>,
    axis: Decades,
    rows: usize,
    name: &str,
) -> Result<Chart<'a, 'b>, Failed> {
    let mut chart = ChartBuilder::on(area)
        .margin(10)
        .margin_left(30)
        .margin_right(44)
        .x_label_area_size(84)
        .build_cartesian_2d(axis, rows.max(1) as f64..0.0)?;
    chart
        .configure_mesh()
        .disable_y_mesh()
        .disable_y_axis()
        .bold_line_style(GRID.stroke_width(2))
        .light_line_style(GRID.mix(0.0))
        .axis_style(INK.stroke_width(2))
        .label_style(axis_text())
        .axis_desc_style(axis_text())
        .x_desc(name)
        .draw()?;
    Ok(chart)
}

fn bar(chart: &mut Chart<'_, '_>, row: &Bar, top: f64, from: f64) -> Result<(), Failed> {
    let value = row.estimate.value;
    let (name, end) = (top + NAME, top + BAR_END);
    if row.hollow {
        // An outline of a path has the breadth it is given, one of a rectangle has not.
        let around = vec![(from, name), (value, name), (value, end), (from, end), (from, name)];
        let outline = PathElement::new(around, row.colour.stroke_width(5));
        chart.plotting_area().draw(&outline)?;
    } else {
        let corners = [(from, name), (value, end)];
        chart.plotting_area().draw(&Rectangle::new(corners, row.colour.mix(0.8).filled()))?;
    }
    let Some([low, high]) = whisker(row.estimate) else { return Ok(()) };
    let middle = top + NAME.midpoint(BAR_END);
    let cap = 0.1;
    let strokes = [
        vec![(low, middle), (high, middle)],
        vec![(low, middle - cap), (low, middle + cap)],
        vec![(high, middle - cap), (high, middle + cap)],
    ];
    for (colour, breadth) in [(PAPER, 8), (INK, 3)] {
        for stroke in &strokes {
            let path = PathElement::new(stroke.clone(), colour.stroke_width(breadth));
            chart.plotting_area().draw(&path)?;
        }
    }
    Ok(())
}

/// Both ends, where both are known and can be drawn.
fn whisker(estimate: Estimate) -> Option<[f64; 2]> {
    let Estimate { low, high, .. } = estimate;
    let known = estimate.knows_low() && estimate.knows_high();
    (known && drawable(low) && drawable(high) && low < high).then_some([low, high])
}

fn words(
    area: &Area<'_>,
    chart: &Chart<'_, '_>,
    row: &Bar,
    (top, left): (f64, f64),
) -> Result<(), Failed> {
    let (x, y) = chart.backend_coord(&(left, top + NAME));
    let words = format!("{}  {}", row.name, row.words);
    text(area, &words, (x + 6, y), (HPos::Left, VPos::Bottom), INK)
}
