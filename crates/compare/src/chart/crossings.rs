//! The crossings of the methods' curves with the errors that are asked for.
//!
//! Curves fall from left to right. Below a level line and to the left of a crossing,
//! and above it to the right of the last, there is nothing but paper: there the
//! times are written.

use crate::chart::axis::Decades;
use crate::chart::canvas::{Failed, LETTER, Place, breadth, text};
use crate::chart::colour::MUTED;
use crate::chart::plot::{Plot, Stroke};
use crate::chart::styles::{MethodStyles, Style};
use crate::number;
use crate::results::{MethodResults, SceneResults};
use plotters::style::text_anchor::{HPos, VPos};

/// Half the height of the mark at a crossing.
const TICK: i32 = 12;
/// Between texts, and between a text and a tick.
const GAP: i32 = 14;

/// A method reaches an error.
#[derive(Clone, Debug)]
struct Crossing {
    x: i32,
    words: String,
    style: Style,
}

/// A text and its place.
pub(crate) struct Label {
    words: String,
    left: i32,
    middle: i32,
    style: Style,
}

/// A level line for each target and a tick where a method crosses it; the times beside
/// the ticks, where there is room, are for [`write`] when all else is drawn.
pub(crate) fn crossings(
    plot: &Plot<'_, '_>,
    scene: &SceneResults,
    styles: &MethodStyles,
    targets: &[f64],
    x: &Decades,
) -> Result<Vec<Label>, Failed> {
    let mut labels = Vec::new();
    for &error in targets {
        let (from, to) = x.ends();
        plot.line(&[(from, error), (to, error)], MUTED, 2, Stroke::Dashed(6))?;
        let (left, y) = plot.place((from, error));
        let found = reached(plot, scene, styles, error, x);
        for Crossing { x, style, .. } in &found {
            plot.segment((*x, y - TICK), (*x, y + TICK), style.colour(), 4)?;
        }
        for (left, side, Crossing { words, style, .. }) in
            written(&found, text_space(plot, (left, y)))
        {
            let middle = y + side.rise();
            labels.push(Label { words: words.clone(), left, middle, style: *style });
        }
    }
    Ok(labels)
}

/// The times, over lines and markers, which would hide digits.
pub(crate) fn write(plot: &Plot<'_, '_>, labels: &[Label]) -> Result<(), Failed> {
    labels.iter().try_for_each(|Label { words, left, middle, style }| {
        text(plot.area(), words, (*left, *middle), (HPos::Left, VPos::Center), style.colour())
    })
}

/// Returns the methods that reach the error at a time that the chart shows, soonest first.
fn reached(
    plot: &Plot<'_, '_>,
    scene: &SceneResults,
    styles: &MethodStyles,
    error: f64,
    axis: &Decades,
) -> Vec<Crossing> {
    let crossing = |method: &MethodResults| {
        let target = method.targets.iter().find(|target| target.error == error)?;
        let seconds = target.seconds?.value;
        axis.holds(seconds).then(|| Crossing {
            x: plot.place((seconds, error)).0,
            words: words(seconds, method.badge()),
            style: styles.style(&method.name),
        })
    };
    let mut found: Vec<_> = scene.methods.iter().filter_map(crossing).collect();
    found.sort_by_key(|crossing| crossing.x);
    found
}

fn words(seconds: f64, badge: Option<&str>) -> String {
    let badge = badge.map(|badge| format!(" {badge}"));
    format!("{}{}", number::seconds(seconds), badge.unwrap_or_default())
}

/// The side of its tick on which a time is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    /// Below the line, left of the first tick of a group.
    LeftBelow,
    /// Above the line, right of the last of all.
    RightAbove,
}

impl Side {
    /// From the line to the middle of the text.
    fn rise(self) -> i32 {
        let half = LETTER / 2 + 8;
        match self {
            Self::LeftBelow => half,
            Self::RightAbove => -half,
        }
    }
}

/// The space where texts may stand.
#[derive(Clone, Copy, Debug)]
struct TextSpace {
    left: i32,
    right: i32,
    /// True if a line of text fits between the level line and the axis.
    below: bool,
}

fn text_space(plot: &Plot<'_, '_>, (left, y): Place) -> TextSpace {
    let end = y + Side::LeftBelow.rise() + LETTER / 2;
    TextSpace { left, right: plot.right_end(), below: end < plot.bottom_end() }
}

/// Left end and side of the times that there is room for.
fn written(
    found: &[Crossing],
    TextSpace { left, right, below }: TextSpace,
) -> Vec<(i32, Side, &Crossing)> {
    let mut free_from = left;
    let mut placed = Vec::new();
    // Ticks too close for a text between them share one row of texts.
    let groups: Vec<_> = found.chunk_by(|a, b| b.x - a.x < breadth(&b.words) + 2 * GAP).collect();
    for (i, group) in groups.iter().enumerate() {
        let (first, last) = (group[0].x, group[group.len() - 1].x);
        let start = first - GAP - length(group);
        if below && start >= free_from + GAP {
            placed.extend(in_a_row(group, start, Side::LeftBelow));
        } else if i + 1 == groups.len() && last + GAP + length(group) <= right {
            placed.extend(in_a_row(group, last + GAP, Side::RightAbove));
        }
        free_from = last;
    }
    placed
}

fn length(group: &[Crossing]) -> i32 {
    group.iter().map(|crossing| breadth(&crossing.words) + GAP).sum::<i32>() - GAP
}

fn in_a_row(group: &[Crossing], start: i32, side: Side) -> Vec<(i32, Side, &Crossing)> {
    let starts = group.iter().scan(start, |at, crossing| {
        let here = *at;
        *at += breadth(&crossing.words) + GAP;
        Some(here)
    });
    starts.zip(group).map(|(at, crossing)| (at, side, crossing)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sides(places: &[i32], below: bool) -> Vec<(i32, Side)> {
        let style = Style { slot: 0, shape: 0 };
        let crossing = |x: &i32| Crossing { x: *x, words: "12 s".into(), style };
        let found: Vec<_> = places.iter().map(crossing).collect();
        let space = TextSpace { left: 100, right: 1000, below };
        written(&found, space).into_iter().map(|(at, side, _)| (at, side)).collect()
    }

    #[test]
    fn close_ticks_share_a_row_left_of_the_first() {
        let found = sides(&[500, 510, 900], true);
        assert!(found.iter().all(|(_, side)| *side == Side::LeftBelow));
        assert!(found[0].0 < found[1].0 && found[1].0 + breadth("12 s") < 500);
        assert!(found[2].0 > 510 && found[2].0 + breadth("12 s") < 900);
    }

    #[test]
    fn without_room_at_the_left_they_go_to_the_right() {
        assert!(matches!(
            sides(&[110, 120], true)[..],
            [(134, Side::RightAbove), (_, Side::RightAbove)]
        ));
    }

    #[test]
    fn no_text_lies_on_the_axis() {
        assert!(matches!(sides(&[500, 800], false)[..], [(814, Side::RightAbove)]));
    }

    #[test]
    fn without_any_room_they_are_left_to_the_table() {
        assert!(sides(&(100..1000).step_by(20).collect::<Vec<_>>(), true).is_empty());
    }
}
