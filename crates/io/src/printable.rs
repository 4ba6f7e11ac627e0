//! Text of files on its way to people.

use std::borrow::Cow;
use std::fmt::Write;

/// The text without what a terminal or a reader's eye would obey: control characters,
/// but for line feeds and tabs, become `\u{1b}` and alike, and so do those that turn the
/// direction of writing or separate lines. Letters of all scripts stay as they are.
pub fn printable(text: &str) -> Cow<'_, str> {
    escape(text, |c, shown| shown.extend(c.escape_unicode()))
}

/// [`printable`] for JSON text, which stays JSON with the same meaning.
pub fn printable_json(text: &str) -> Cow<'_, str> {
    escape(text, |c, shown| {
        for unit in c.encode_utf16(&mut [0; 2]) {
            // A string takes everything.
            let _ = write!(shown, "\\u{unit:04x}");
        }
    })
}

fn escape(text: &str, push_escaped: impl Fn(char, &mut String)) -> Cow<'_, str> {
    if !text.contains(is_obeyed) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        if is_obeyed(c) { push_escaped(c, &mut shown) } else { shown.push(c) }
    }
    Cow::Owned(shown)
}

/// The lists of the last line are Unicode's `Bidi_Control`, its two separators, and the
/// tags, which nobody sees.
fn is_obeyed(c: char) -> bool {
    c.is_control() && !matches!(c, '\n' | '\t')
        || matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}')
        || matches!(c, '\u{2066}'..='\u{2069}' | '\u{2028}' | '\u{2029}')
        || matches!(c, '\u{e0000}'..='\u{e007f}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_be_obeyed_is_shown() {
        let text = "\u{1b}[2J\u{7}\0\r\u{7f}\u{9b}1m a\u{202e}b\u{2066}\u{61c}\u{2028}\u{e0041}";
        let shown =
            r"\u{1b}[2J\u{7}\u{0}\u{d}\u{7f}\u{9b}1m a\u{202e}b\u{2066}\u{61c}\u{2028}\u{e0041}";
        assert_eq!(printable(text), shown);
    }

    #[test]
    fn what_people_write_stays() {
        for text in ["grün, ☃, 漢字, नमस्ते, שלום, 👩‍🚀", "two\n\tlines", "C:\\mesh \"a\""]
        {
            assert!(matches!(printable(text), Cow::Borrowed(same) if same == text), "{text}");
        }
    }

    #[test]
    fn json_means_the_same() {
        let text = "\u{1b}[1m\u{9b}2J\u{202e}\u{e0041}é";
        let json = serde_json::to_string_pretty(&[text]).unwrap();
        let shown = printable_json(&json);
        assert_eq!(shown, "[\n  \"\\u001b[1m\\u009b2J\\u202e\\udb40\\udc41é\"\n]");
        assert_eq!(serde_json::from_str::<[String; 1]>(&shown).unwrap(), [text]);
    }
}
