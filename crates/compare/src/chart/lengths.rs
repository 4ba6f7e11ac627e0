//! The chart of what paths of each length bring and cost.

use crate::chart::canvas::{Area, BREADTH, Failed, LETTER, axis_text, svg, text};
use crate::chart::colour::{GRID, INK, MUTED, PALE};
use crate::results::LengthShare;
use maud::Markup;
use plotters::chart::ChartBuilder;
use plotters::element::Rectangle;
use plotters::style::text_anchor::{HPos, VPos};
use plotters::style::{Color, RGBColor};

const SIZE: (u32, u32) = (BREADTH, 560);

/// A share, its name and its grey: by lightness alone, since hues are for methods.
type Kind = (&'static str, RGBColor, fn(&LengthShare) -> f64);
const KINDS: [Kind; 3] = [
    ("light", INK, |share| share.light),
    ("noise", MUTED, |share| share.variance),
    ("rays", PALE, |share| share.rays),
];

/// Shares of light, noise and rays, three bars each length.
pub(crate) fn lengths(scene: &str, shares: &[LengthShare]) -> Markup {
    let label = format!("Shares of light, noise and rays by path length on {scene}");
    svg(&label, SIZE, |area| {
        draw(area, shares)?;
        key(area)
    })
}

fn draw(area: &Area<'_>, shares: &[LengthShare]) -> Result<(), Failed> {
    let top = highest(shares);
    let mut chart = ChartBuilder::on(area)
        .margin_top(LETTER + 20)
        .margin_right(44)
        .x_label_area_size(84)
        .y_label_area_size(124)
        .build_cartesian_2d(-0.5..shares.len() as f64 - 0.5, 0.0..top)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .x_labels(shares.len().max(2))
        .y_labels(6)
        .x_label_formatter(&|place| length_name(shares, *place))
        .y_label_formatter(&|share| format!("{:.0} %", 100.0 * share))
        .bold_line_style(GRID.stroke_width(2))
        .light_line_style(GRID.mix(0.0))
        .axis_style(INK.stroke_width(2))
        .label_style(axis_text())
        .axis_desc_style(axis_text())
        .x_desc("edges of the path")
        .draw()?;
    for (i, share) in shares.iter().enumerate() {
        for (k, (_, colour, of)) in KINDS.iter().enumerate() {
            let left = i as f64 - 0.39 + 0.26 * k as f64;
            let corners = [(left, 0.0), (left + 0.26, finite(of(share)))];
            chart.plotting_area().draw(&Rectangle::new(corners, colour.filled()))?;
        }
    }
    Ok(())
}

fn highest(shares: &[LengthShare]) -> f64 {
    let all = shares.iter().flat_map(|share| KINDS.map(|(_, _, of)| finite(of(share))));
    1.05 * all.fold(0.1, f64::max)
}

fn finite(share: f64) -> f64 {
    if share.is_finite() { share.max(0.0) } else { 0.0 }
}

/// `3`, or `≥ 8` for the last; nothing between two lengths.
fn length_name(shares: &[LengthShare], place: f64) -> String {
    let index = place.round();
    if (place - index).abs() > 0.01 || index < 0.0 {
        return String::new();
    }
    match shares.get(index as usize) {
        Some(share) if index as usize + 1 == shares.len() => format!("≥ {}", share.edges),
        Some(share) => share.edges.to_string(),
        None => String::new(),
    }
}

fn key(area: &Area<'_>) -> Result<(), Failed> {
    for (x, (name, colour, _)) in (150..).step_by(170).zip(KINDS) {
        area.draw(&Rectangle::new([(x, 8), (x + 24, 32)], colour.filled()))?;
        text(area, name, (x + 34, 20), (HPos::Left, VPos::Center), INK)?;
    }
    Ok(())
}
