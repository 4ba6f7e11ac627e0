//! Lines, bands and markers over two logarithmic axes.

use crate::chart::axis::Decades;
use crate::chart::canvas::{Area, Failed, Place, axis_text};
use crate::chart::colour::{GRID, INK, PAPER};
use crate::chart::marker::{HOLE, corners};
use plotters::chart::{ChartBuilder, ChartContext};
use plotters::coord::cartesian::Cartesian2d;
use plotters::element::{DashedPathElement, PathElement, Polygon};
use plotters::prelude::SVGBackend;
use plotters::style::{Color, RGBColor, ShapeStyle};

/// An area with two axes.
pub(crate) struct Plot<'a, 'b> {
    area: &'a Area<'b>,
    chart: ChartContext<'a, SVGBackend<'b>, Cartesian2d<Decades, Decades>>,
}

/// Shape and colour of a marker.
pub(crate) type Mark = (usize, RGBColor);

/// The stroke of a line.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Stroke {
    /// Unbroken.
    Solid,
    /// Dashes and gaps of this length.
    Dashed(u32),
}

impl<'a, 'b> Plot<'a, 'b> {
    /// Draws axes with their names.
    pub(crate) fn new(
        area: &'a Area<'b>,
        (x, x_name): (Decades, &str),
        (y, y_name): (Decades, &str),
    ) -> Result<Self, Failed> {
        let mut chart = ChartBuilder::on(area)
            .margin_top(14)
            // The last tick's text is centred on the corner.
            .margin_right(44)
            .x_label_area_size(84)
            .y_label_area_size(124)
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .bold_line_style(GRID.stroke_width(2))
            .light_line_style(GRID.mix(0.0))
            .axis_style(INK.stroke_width(2))
            .label_style(axis_text())
            .axis_desc_style(axis_text())
            .x_desc(x_name)
            .y_desc(y_name)
            .draw()?;
        Ok(Self { area, chart })
    }

    /// Returns the area that it is drawn on.
    pub(crate) fn area(&self) -> &'a Area<'b> {
        self.area
    }

    /// Both ends of the vertical axis.
    pub(crate) fn y_ends(&self) -> (f64, f64) {
        self.chart.as_coord_spec().y_spec().ends()
    }

    /// Returns the pixel column where the axes end at the right.
    pub(crate) fn right_end(&self) -> i32 {
        self.chart.plotting_area().get_pixel_range().0.end
    }

    /// Returns the pixel row where the axes end at the bottom.
    pub(crate) fn bottom_end(&self) -> i32 {
        self.chart.plotting_area().get_pixel_range().1.end
    }

    /// Returns the place of a point, moved to the edge if it is outside.
    pub(crate) fn place(&self, point: (f64, f64)) -> Place {
        self.chart.backend_coord(&point)
    }

    /// A line through points.
    pub(crate) fn line(
        &self,
        points: &[(f64, f64)],
        colour: RGBColor,
        breadth: u32,
        stroke: Stroke,
    ) -> Result<(), Failed> {
        let places: Vec<Place> = points.iter().map(|&point| self.place(point)).collect();
        self.stroke(places, colour.stroke_width(breadth), stroke)
    }

    fn stroke(&self, places: Vec<Place>, style: ShapeStyle, stroke: Stroke) -> Result<(), Failed> {
        if places.len() < 2 {
            return Ok(());
        }
        match stroke {
            Stroke::Solid => self.area.draw(&PathElement::new(places, style)),
            Stroke::Dashed(length) => {
                self.area.draw(&DashedPathElement::new(places, length, length, style))
            }
        }
    }

    /// The space between two lines.
    pub(crate) fn band(
        &self,
        low: &[(f64, f64)],
        high: &[(f64, f64)],
        colour: RGBColor,
    ) -> Result<(), Failed> {
        let around = low.iter().chain(high.iter().rev());
        let places: Vec<Place> = around.map(|&point| self.place(point)).collect();
        if places.len() < 4 {
            return Ok(());
        }
        self.area.draw(&Polygon::new(places, colour.mix(0.16).filled()))
    }

    /// A marker; hollow unless solid.
    pub(crate) fn marker(
        &self,
        point: (f64, f64),
        (shape, colour): Mark,
        radius: f64,
        solid: bool,
    ) -> Result<(), Failed> {
        let place = self.place(point);
        marker(self.area, place, (shape, colour), radius)?;
        if solid {
            return Ok(());
        }
        marker(self.area, place, (shape, PAPER), HOLE * radius)
    }

    /// A straight line between two places.
    pub(crate) fn segment(
        &self,
        from: Place,
        to: Place,
        colour: RGBColor,
        breadth: u32,
    ) -> Result<(), Failed> {
        self.area.draw(&PathElement::new(vec![from, to], colour.stroke_width(breadth)))
    }
}

/// A filled marker of a shape and colour.
pub(crate) fn marker(
    area: &Area<'_>,
    (x, y): Place,
    (shape, colour): Mark,
    radius: f64,
) -> Result<(), Failed> {
    let moved = |(dx, dy): (f64, f64)| (x + dx.round() as i32, y + dy.round() as i32);
    let places: Vec<Place> = corners(shape, radius).into_iter().map(moved).collect();
    area.draw(&Polygon::new(places, colour.filled()))
}
