//! From drawing to SVG.

use crate::chart::colour::INK;
use maud::{Markup, PreEscaped, html};
use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, IntoFont, RGBColor, TextStyle};

/// The SVG area that a chart is drawn on.
pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// The reason why a drawing failed.
pub(crate) type Failed = DrawingAreaErrorKind<std::io::Error>;
/// A place on it.
pub(crate) type Place = (i32, i32);

/// Height of letters in the charts' own units.
pub(crate) const LETTER: i32 = 26;
/// Breadth of a chart of its own; its units are about half a pixel in a wide window,
/// since the library draws at whole units only.
pub(crate) const BREADTH: u32 = 1300;
/// Breadth of one of two charts beside each other.
pub(crate) const HALF: u32 = 800;

/// An SVG that is as broad as its place on the page, described by `label` for those
/// who do not see it.
pub(crate) fn svg(
    label: &str,
    size: (u32, u32),
    draw: impl FnOnce(&Area<'_>) -> Result<(), Failed>,
) -> Markup {
    let mut text = String::new();
    let drawn = {
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        draw(&area).and_then(|()| area.present())
    };
    match drawn {
        Ok(()) => described(label, &text),
        Err(cause) => html! { p.note { "This chart could not be drawn: " (cause.to_string()) } },
    }
}

fn described(label: &str, svg: &str) -> Markup {
    let label = html! { (label) }.into_string();
    let open = format!("<svg role=\"img\" aria-label=\"{label}\" ");
    PreEscaped(svg.replacen("<svg ", &open, 1))
}

fn text_style(colour: RGBColor) -> TextStyle<'static> {
    // The library divides by this factor before it writes the size.
    ("sans-serif", f64::from(LETTER) * 1.24).into_font().color(&colour.to_rgba())
}

/// Text at a place: which point of the text lies there is told by `h` and `v`.
pub(crate) fn text(
    area: &Area<'_>,
    words: &str,
    at: Place,
    (h, v): (HPos, VPos),
    colour: RGBColor,
) -> Result<(), Failed> {
    let style = text_style(colour).pos(Pos::new(h, v));
    area.draw_text(words, &style, at)
}

/// About how broad a text is, in units.
pub(crate) fn breadth(words: &str) -> i32 {
    (words.chars().count() as f64 * 0.62 * f64::from(LETTER)) as i32
}

/// The style of axis names and ticks.
pub(crate) fn axis_text() -> TextStyle<'static> {
    text_style(INK)
}
