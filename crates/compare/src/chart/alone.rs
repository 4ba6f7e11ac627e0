//! A chart as a file of its own: on white, with its legend inside.

use crate::chart::canvas::{Area, Failed, LETTER, breadth, svg, text};
use crate::chart::colour::{INK, PAPER};
use crate::chart::marker::HOLE;
use crate::chart::plot::{Mark, marker};
use crate::chart::styles::MethodStyles;
use crate::results::{MethodResults, OracleCurve, SceneResults};
use maud::Markup;
use plotters::style::text_anchor::{HPos, VPos};

/// Height of a row of the legend, and of the space around it.
const ROW: i32 = LETTER + 18;
/// From a marker's middle to its name.
const BESIDE: i32 = 22;
/// From the end of a name to the next marker's middle.
const GAP: i32 = 48;
const LEFT: i32 = 30;
const RADIUS: f64 = 10.0;

/// The style of text in a chart by itself, in place of the page's style.
const STYLE: &str = "text{paint-order:stroke;stroke:#FFFFFF;stroke-width:6px;\
    stroke-linejoin:round}";

/// A marker and what it stands for.
pub(crate) struct Key {
    words: String,
    mark: Mark,
    hollow: bool,
}

/// All methods of a scene.
pub(crate) fn methods(scene: &SceneResults, styles: &MethodStyles) -> Vec<Key> {
    let key = |method: &MethodResults| Key {
        words: method.marked_name(),
        mark: styles.style(&method.name).mark(),
        hollow: method.badge().is_some(),
    };
    scene.methods.iter().map(key).collect()
}

/// A method by its name.
pub(crate) fn named(name: &str, styles: &MethodStyles) -> Key {
    Key { words: name.into(), mark: styles.style(name).mark(), hollow: false }
}

/// All estimators of the oracle.
pub(crate) fn curves(curves: &[OracleCurve], styles: &MethodStyles) -> Vec<Key> {
    curves.iter().map(|curve| named(&curve.method, styles)).collect()
}

/// The document; `None` if the chart could not be drawn.
pub(crate) fn alone(chart: &Markup, keys: &[Key]) -> Option<String> {
    let chart = &chart.0;
    let (width, height) = (size(chart, "width")?, size(chart, "height")?);
    let places = places(keys, width);
    let rows = places.last().map_or(0, |(row, _)| row + 1);
    let above = ROW * rows;
    let legend = svg("Legend", (width as u32, above.max(1) as u32), |area| {
        places.iter().zip(keys).try_for_each(|((row, x), key)| {
            let y = ROW * row + ROW / 2;
            draw(area, key, (*x, y))
        })
    });
    let whole = height + above;
    let chart = chart.replacen("<svg ", &format!("<svg y=\"{above}\" "), 1);
    Some(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{whole}\" \
         viewBox=\"0 0 {width} {whole}\">\n<style>{STYLE}</style>\n\
         <rect width=\"{width}\" height=\"{whole}\" fill=\"#FFFFFF\"/>\n{}\n{chart}</svg>\n",
        if rows > 0 { legend.0.as_str() } else { "" },
    ))
}

/// An attribute of the outermost element, in units.
fn size(chart: &str, name: &str) -> Option<i32> {
    let open = chart.strip_prefix("<svg ")?.split('>').next()?;
    let value = open.split(&format!(" {name}=\"")).nth(1)?;
    value.split('"').next()?.parse().ok()
}

/// Row and middle of each marker, as many in a row as there is room for.
fn places(keys: &[Key], width: i32) -> Vec<(i32, i32)> {
    let (mut row, mut x) = (0, LEFT);
    let mut place = |key: &Key| {
        let end = x + BESIDE + breadth(&key.words);
        if end > width && x > LEFT {
            (row, x) = (row + 1, LEFT);
        }
        let here = (row, x);
        x += BESIDE + breadth(&key.words) + GAP;
        here
    };
    keys.iter().map(&mut place).collect()
}

fn draw(area: &Area<'_>, key: &Key, at: (i32, i32)) -> Result<(), Failed> {
    marker(area, at, key.mark, RADIUS)?;
    if key.hollow {
        marker(area, at, (key.mark.0, PAPER), HOLE * RADIUS)?;
    }
    text(area, &key.words, (at.0 + BESIDE, at.1), (HPos::Left, VPos::Center), INK)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(words: &str) -> Key {
        Key { words: words.into(), mark: (0, INK), hollow: false }
    }

    #[test]
    fn keys_wrap_where_there_is_no_room() {
        let keys = [key("bdpt"), key("directlight"), key("a name longer than any row can be")];
        let found = places(&keys, 500);
        assert_eq!(found.iter().map(|(row, _)| *row).collect::<Vec<_>>(), [0, 0, 1]);
        assert_eq!((found[0].1, found[2].1), (LEFT, LEFT));
        assert!(found[1].1 > LEFT + BESIDE + breadth("bdpt"));
    }
}
