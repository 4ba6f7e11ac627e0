//! Where the methods reach the errors that are asked for.

use crate::chart::axis::Decades;
use crate::chart::canvas::{Failed, LETTER, Place, breadth, text};
use crate::chart::colour::MUTED;
use crate::chart::palette::{Look, Palette};
use crate::chart::plot::{Plot, Stroke};
use crate::page::number;
use crate::results::SceneResults;
use plotters::style::text_anchor::{HPos, VPos};
use std::ops::Range;

/// Half the height of the mark at a crossing.
const TICK: i32 = 12;

/// A method reaches an error.
struct Crossing {
    seconds: f64,
    look: Look,
}

/// A level line for each target, a tick where a method crosses it, and the time
/// beside the tick where there is room.
pub(crate) fn crossings(
    plot: &Plot<'_, '_>,
    scene: &SceneResults,
    palette: &Palette,
    targets: &[f64],
    x: &Decades,
) -> Result<(), Failed> {
    let mut taken = Taken::default();
    for &error in targets {
        let (from, to) = x.ends();
        plot.line(&[(from, error), (to, error)], MUTED, 2, Stroke::Dashed(6))?;
        for crossing in reached(scene, palette, error, x) {
            tick(plot, (crossing.seconds, error), crossing.look, &mut taken)?;
        }
    }
    Ok(())
}

/// Who reaches the error at a time that the chart shows, soonest first.
fn reached(scene: &SceneResults, palette: &Palette, error: f64, x: &Decades) -> Vec<Crossing> {
    let crossing = |method: &crate::results::MethodResults| {
        let target = method.targets.iter().find(|target| target.error == error)?;
        let seconds = target.seconds?.value;
        x.holds(seconds).then(|| Crossing { seconds, look: palette.look(&method.name) })
    };
    let mut found: Vec<_> = scene.methods.iter().filter_map(crossing).collect();
    found.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    found
}

fn tick(
    plot: &Plot<'_, '_>,
    point: (f64, f64),
    look: Look,
    taken: &mut Taken,
) -> Result<(), Failed> {
    let (x, y) = plot.place(point);
    plot.segment((x, y - TICK), (x, y + TICK), look.colour(), 4)?;
    let words = number::seconds(point.0);
    match taken.place(&words, (x, y), plot.right_end()) {
        Some(at) => {
            text(plot.area(), &words, at, (HPos::Left, VPos::Bottom), look.colour())
        }
        None => Ok(()),
    }
}

/// Where texts are already.
#[derive(Default)]
struct Taken(Vec<(Range<i32>, i32)>);

impl Taken {
    /// A free place for a text beside a tick, above the line if possible, below it
    /// otherwise.
    fn place(&mut self, words: &str, (x, y): Place, end: i32) -> Option<Place> {
        let across = x + 6..x + 6 + breadth(words);
        let rows = [y - TICK + 2, y + TICK + LETTER as i32 + 2];
        let row = rows.into_iter().find(|&row| across.end < end && self.is_free(&across, row))?;
        self.0.push((across, row));
        Some((x + 6, row))
    }

    fn is_free(&self, across: &Range<i32>, row: i32) -> bool {
        let touches = |(other, at): &(Range<i32>, i32)| {
            (row - at).abs() < LETTER as i32
                && across.start < other.end + 8
                && other.start < across.end + 8
        };
        !self.0.iter().any(touches)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_go_above_then_below_then_nowhere() {
        let mut taken = Taken::default();
        let places: Vec<_> =
            [100, 110, 120, 400].map(|x| taken.place("12 s", (x, 300), 900)).to_vec();
        let (first, second) = (places[0].unwrap(), places[1].unwrap());
        assert!(first.1 < 300 && second.1 > 300);
        assert_eq!((places[2], places[3]), (None, Some((406, first.1))));
    }

    #[test]
    fn no_text_leaves_the_chart() {
        assert_eq!(Taken::default().place("12 s", (880, 300), 900), None);
    }
}
