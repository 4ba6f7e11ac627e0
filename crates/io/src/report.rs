//! Errors in scene files, shown with the lines they are in.

use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
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

/// One error in a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The file.
    pub source: Arc<SourceText>,
    /// The bytes that are wrong, where they are known.
    pub span: Option<Range<usize>>,
    /// What is wrong.
    pub title: String,
    /// Words to stand beside the place.
    pub label: String,
    /// What to do about it.
    pub help: Option<String>,
}

/// Every error found in a scene, at least one.
///
/// Shown as a compiler does: what is wrong, the file with line and column, the
/// line, and what to do. The first error begins without "error:".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report(pub Vec<Problem>);

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, problem) in self.0.iter().enumerate() {
            if index > 0 {
                f.write_str("\n\n")?;
            }
            f.write_str(&problem.render(index == 0))?;
        }
        Ok(())
    }
}

impl Problem {
    /// The same with advice.
    #[must_use]
    pub fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    fn render(&self, is_first: bool) -> String {
        let level = if is_first { Level::ERROR.no_name() } else { Level::ERROR };
        let SourceText { name, text } = &*self.source;
        let title = level.primary_title(self.title.as_str());
        let group = match &self.span {
            Some(span) => {
                let mark = AnnotationKind::Primary
                    .span(visible(text, span.clone()))
                    .label(self.label.as_str());
                let snippet = Snippet::source(text.as_str()).path(name.as_str()).annotation(mark);
                title.element(snippet)
            }
            None => title.element(Origin::path(name.as_str())),
        };
        let help = self.help.as_ref().map(|help| Level::HELP.message(help.as_str()));
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
            span,
            title: "the view is closed".to_string(),
            label: "here".to_string(),
            help: None,
        }
    }

    #[test]
    fn the_place_is_shown() {
        let shown = Report(vec![problem(Some(11..12)).with_help("open it")]).to_string();
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
        let shown = Report(vec![problem(None), problem(None)]).to_string();
        let expected = "the view is closed\n--> a.ron\n\nerror: the view is closed\n--> a.ron";
        assert_eq!(shown, expected);
    }

    #[test]
    fn any_span_can_be_shown() {
        for (start, end) in [(0, 99), (99, 99), (16, 17), (1, 1), (5, 2)] {
            let shown = Report(vec![problem(Some(start..end))]).to_string();
            assert!(shown.contains("a.ron:"), "{shown}");
        }
    }
}
