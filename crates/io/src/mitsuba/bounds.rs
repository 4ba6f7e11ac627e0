//! The bounds that a text must keep before it is read as XML.
//!
//! The reader of XML compares each attribute with all before it in its element, and hands the
//! namespaces of an element on to all within it. That is no matter for what scenes have, and
//! would be for a file that is made to hurt.

use super::Fault;

/// Elements within each other.
const MOST_DEPTH: usize = 64;
/// Attributes of one element.
const MOST_ATTRIBUTES: usize = 64;

/// Refuses a text that no scene has, with the byte where it does so. Whether it is well formed is
/// not asked here.
pub(super) fn check(text: &str) -> Result<(), (usize, Fault)> {
    let mut depth = 0_usize;
    let mut at = 0;
    while let Some(next) = text[at..].find('<') {
        let start = at + next;
        let rest = &text[start..];
        if rest.starts_with("<!DOCTYPE") {
            return Err((start, Fault::DocumentType));
        }
        if let Some((_, end)) = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")]
            .iter()
            .find(|(open, _)| rest.starts_with(open))
        {
            at = rest.find(end).map_or(text.len(), |found| start + found + end.len());
            continue;
        }
        let tag = Tag::of(rest);
        if tag.attributes > MOST_ATTRIBUTES {
            let fault =
                Fault::TooMany { what: "attributes of one element", limit: MOST_ATTRIBUTES };
            return Err((start, fault));
        }
        depth = if rest.starts_with("</") {
            depth.saturating_sub(1)
        } else {
            depth + usize::from(!tag.is_closed)
        };
        if depth > MOST_DEPTH {
            let fault = Fault::TooMany { what: "elements within each other", limit: MOST_DEPTH };
            return Err((start, fault));
        }
        at = start + tag.length;
    }
    Ok(())
}

/// The text between `<` and `>`.
struct Tag {
    length: usize,
    attributes: usize,
    /// Whether it ends as it begins.
    is_closed: bool,
}

impl Tag {
    fn of(text: &str) -> Self {
        let (mut quote, mut attributes, mut last) = (None, 0, b'<');
        for (index, byte) in text.bytes().enumerate() {
            match (quote, byte) {
                (Some(open), _) if byte == open => quote = None,
                (None, b'"' | b'\'') => quote = Some(byte),
                (None, b'=') => attributes += 1,
                (None, b'>') => {
                    return Self { length: index + 1, attributes, is_closed: last == b'/' };
                }
                (Some(_) | None, _) => {}
            }
            last = byte;
        }
        Self { length: text.len(), attributes, is_closed: false }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_scenes_have_is_let_through() {
        let nested = "<a b='>'>".repeat(MOST_DEPTH) + &"</a>".repeat(MOST_DEPTH);
        for sound in ["", "<a/>", "<!-- <!DOCTYPE <<< --><a/>", &nested, &"<a/>".repeat(1000), "<"]
        {
            assert_eq!(check(sound), Ok(()), "{sound}");
        }
    }

    #[test]
    fn what_would_hurt_is_not() {
        let deep = "<a>".repeat(MOST_DEPTH + 1);
        assert!(matches!(check(&deep), Err((at, Fault::TooMany { .. })) if at == 3 * MOST_DEPTH));
        let wide = format!("<a {}/>", "b='' ".repeat(MOST_ATTRIBUTES + 1));
        assert!(matches!(check(&wide), Err((0, Fault::TooMany { .. }))));
        assert_eq!(check(" <!DOCTYPE x>"), Err((1, Fault::DocumentType)));
    }
}
