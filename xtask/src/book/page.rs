//! What a page of Markdown holds, and where it can be linked at.

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// A page as far as tests look into it.
#[derive(Debug, Default)]
pub(super) struct Page {
    /// Blocks of code, in their order.
    pub(super) blocks: Vec<Block>,
    /// Names of its headings, by which links end at them.
    pub(super) anchors: Vec<String>,
    /// Code within lines.
    pub(super) spans: Vec<String>,
}

/// A block of code with its language.
#[derive(Debug, PartialEq)]
pub(super) struct Block {
    pub(super) language: String,
    pub(super) text: String,
    /// The line of its first fence, from 1 on.
    pub(super) line: usize,
}

impl Page {
    /// Reads the text of a page.
    #[expect(clippy::wildcard_enum_match_arm, reason = "most of a page is not looked at")]
    pub(super) fn of(text: &str) -> Self {
        let mut page = Self::default();
        let (mut heading, mut block): (Option<String>, Option<Block>) = (None, None);
        let events = Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter();
        for (event, range) in events {
            match event {
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
                    let line = text[..range.start].split('\n').count();
                    let (language, text) = (language.into_string(), String::new());
                    block = Some(Block { language, text, line });
                }
                Event::End(TagEnd::CodeBlock) => page.blocks.extend(block.take()),
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::End(TagEnd::Heading(_)) => page.add_anchor(heading.take()),
                Event::Text(part) | Event::Code(part) if heading.is_some() => {
                    heading = heading.map(|before| before + &part);
                }
                Event::Text(part) => {
                    if let Some(block) = &mut block {
                        block.text.push_str(&part);
                    }
                }
                Event::Code(part) => page.spans.push(part.into_string()),
                _ => {}
            }
        }
        page
    }

    fn add_anchor(&mut self, heading: Option<String>) {
        let anchor = anchor(&heading.unwrap_or_default());
        let before = self.anchors.iter().filter(|other| **other == anchor).count();
        self.anchors.push(if before == 0 { anchor } else { format!("{anchor}-{before}") });
    }
}

/// Returns the name of a heading in links: small letters, figures and hyphens.
fn anchor(heading: &str) -> String {
    let letters = heading.chars().filter_map(|letter| match letter {
        ' ' => Some('-'),
        '-' | '_' => Some(letter),
        other => other.is_alphanumeric().then_some(other),
    });
    letters.flat_map(char::to_lowercase).collect()
}

#[test]
fn a_page_is_read() {
    let text =
        "# One `thing`, twice\n\n[a](b.md#c) `span`\n\n  ```sh\n  go # on\n  ```\n# 2\n# 2\n";
    let page = Page::of(text);
    assert_eq!(page.anchors, ["one-thing-twice", "2", "2-1"]);
    let block = Block { language: "sh".into(), text: "go # on\n".into(), line: 5 };
    assert_eq!((page.blocks, page.spans), (vec![block], vec![String::from("span")]));
}
