//! Errors in scene files, shown with the lines they are in.

use crate::locate::{Path, locate_near};
use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
use std::borrow::Cow;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A text file that errors can point into.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceText {
    /// Name to show.
    pub name: String,
    /// The whole text.
    pub text: String,
}

/// The place of an error in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Spot {
    /// Nowhere in it.
    Nowhere,
    /// These bytes.
    Bytes(Range<usize>),
    /// The value at the end of a path. Looked for when the error is shown.
    Value(Path),
}

/// One error in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The file.
    pub source: Arc<SourceText>,
    /// The place, and what is wrong there.
    pub spot: Spot,
    /// The fault, in a few words.
    pub title: String,
    /// Words to stand beside the place.
    pub label: String,
    /// Advice on what to do about it.
    pub help: Option<String>,
}

/// The errors found in a scene, at least one.
///
/// Shown as a compiler does: what is wrong, the file with line and column, the
/// line, and what to do. The first error begins without "error:".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    /// The first of them.
    pub problems: Vec<Problem>,
    /// The number of faults that are not listed.
    pub more: usize,
}

/// Errors that are shown; more are counted. Nobody reads them, and each takes a search
/// through the text.
const MOST_SHOWN: usize = 20;

/// The errors found so far.
#[derive(Debug, Default)]
pub(crate) struct Problems {
    first: Vec<Problem>,
    more: usize,
}

impl Problems {
    pub(crate) fn push(&mut self, problem: Problem) {
        self.push_with(|| problem);
    }

    /// Makes the error only if it will be shown.
    pub(crate) fn push_with(&mut self, problem: impl FnOnce() -> Problem) {
        if self.first.len() < MOST_SHOWN {
            self.first.push(problem());
        } else {
            self.more += 1;
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.first.is_empty()
    }

    pub(crate) fn into_report(self) -> Report {
        Report { problems: self.first, more: self.more }
    }
}

impl From<Problem> for Report {
    fn from(problem: Problem) -> Self {
        Self { problems: vec![problem], more: 0 }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, problem) in self.problems.iter().enumerate() {
            if index > 0 {
                f.write_str("\n\n")?;
            }
            f.write_str(&problem.render(index == 0))?;
        }
        match self.more {
            0 => Ok(()),
            1 => f.write_str("\n\nand 1 more error"),
            more => write!(f, "\n\nand {more} more errors"),
        }
    }
}

/// Characters of a title, label or help that are shown. Names of any length may stand in
/// a file.
const LONGEST: usize = 500;

fn cut(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
        None => Cow::Borrowed(text),
    }
}

impl Problem {
    /// Adds advice.
    #[must_use]
    pub fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    /// Adds advice, if there is any.
    #[must_use]
    pub(crate) fn with_help_if_any(self, help: Option<String>) -> Self {
        Self { help, ..self }
    }

    /// Renders a problem; of a value that cannot be found in the text its path is given.
    fn render(&self, is_first: bool) -> String {
        let level = if is_first { Level::ERROR.no_name() } else { Level::ERROR };
        let SourceText { name, text } = &*self.source;
        let (span, title) = match &self.spot {
            Spot::Nowhere => (None, self.title.clone()),
            Spot::Bytes(bytes) => (Some(bytes.clone()), self.title.clone()),
            Spot::Value(path) => match locate_near(text, path) {
                Some(bytes) => (Some(bytes), self.title.clone()),
                None => (None, format!("{path}: {}", self.title)),
            },
        };
        let (title, label) = (cut(&title), cut(&self.label));
        let title = level.primary_title(&*title);
        let group = match span {
            Some(span) => {
                let mark = AnnotationKind::Primary.span(visible(text, span)).label(&*label);
                let snippet = Snippet::source(text.as_str()).path(name.as_str()).annotation(mark);
                title.element(snippet)
            }
            None => title.element(Origin::path(name.as_str())),
        };
        let help = self.help.as_ref().map(|help| cut(help));
        let help = help.as_ref().map(|help| Level::HELP.message(&**help));
        Renderer::plain().render(&[group.elements(help)])
    }
}

/// The part of a span to underline: on one line, at least a character long,
/// inside the text.
fn visible(text: &str, span: Range<usize>) -> Range<usize> {
    let start = text.floor_char_boundary(span.start);
    let line = text[start..].find('\n').map_or(text.len(), |length| start + length);
    let end = text.floor_char_boundary(span.end.min(line));
    let one = start + text[start..].chars().next().map_or(0, char::len_utf8);
    start..end.max(one)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(span: Option<Range<usize>>) -> Problem {
        let text = "(\n    fov: 0,\n)\n".to_string();
        Problem {
            source: Arc::new(SourceText { name: "a.ron".to_string(), text }),
            spot: span.map_or(Spot::Nowhere, Spot::Bytes),
            title: "the view is closed".to_string(),
            label: "here".to_string(),
            help: None,
        }
    }

    #[test]
    fn the_place_is_shown() {
        let shown = Report::from(problem(Some(11..12)).with_help("open it")).to_string();
        let expected = "\
the view is closed
 --> a.ron:2:10
  |
2 |     fov: 0,
  |          ^ here
  |
  = help: open it";
        assert_eq!(shown, expected);
    }

    #[test]
    fn several_problems_are_shown_in_order() {
        let shown = Report { problems: vec![problem(None), problem(None)], more: 0 }.to_string();
        let expected = "the view is closed\n--> a.ron\n\nerror: the view is closed\n--> a.ron";
        assert_eq!(shown, expected);
    }

    #[test]
    fn any_span_can_be_shown() {
        for (start, end) in [(0, 99), (99, 99), (16, 17), (1, 1), (5, 2)] {
            let shown = Report::from(problem(Some(start..end))).to_string();
            assert!(shown.contains("a.ron:"), "{shown}");
        }
    }

    #[test]
    fn only_the_first_are_shown() {
        let mut problems = Problems::default();
        (0..100).for_each(|_| problems.push(problem(None)));
        let shown = problems.into_report().to_string();
        assert_eq!(shown.matches("closed").count(), 20);
        assert!(shown.ends_with("\n\nand 80 more errors"), "{shown}");
    }

    #[test]
    fn long_words_are_cut() {
        let title = "ä".repeat(100_000);
        let long = Problem { title, ..problem(None) };
        assert!(Report::from(long).to_string().chars().count() < 600);
    }
}
