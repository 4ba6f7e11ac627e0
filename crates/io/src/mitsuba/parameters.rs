//! `default` and `$name`: values that a file gives a name.

use super::Fault;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Values by name. The first to be given stays.
#[derive(Default)]
pub(super) struct Parameters(BTreeMap<String, String>);

/// The longest text that may come of one attribute.
const LONGEST: usize = 1 << 16;

impl Parameters {
    pub(super) fn give(&mut self, name: &str, value: &str) {
        self.0.entry(name.to_string()).or_insert_with(|| value.to_string());
    }

    /// Puts values for names into a text; of names of which one begins with the other the longer.
    pub(super) fn filled<'a>(&self, text: &'a str) -> Result<Cow<'a, str>, Fault> {
        if !text.contains('$') {
            return Ok(Cow::Borrowed(text));
        }
        let mut parts = text.split('$');
        let mut filled = parts.next().unwrap_or_default().to_string();
        for part in parts {
            let fits = |name: &&String| part.starts_with(name.as_str());
            let longest = self.0.keys().filter(fits).max_by_key(|name| name.len());
            let Some(name) = longest else { return Err(Fault::Undefined(undefined(part))) };
            filled.push_str(&self.0[name]);
            filled.push_str(&part[name.len()..]);
            if filled.len() > LONGEST {
                return Err(Fault::TooMany { what: "bytes of one value", limit: LONGEST });
            }
        }
        Ok(Cow::Owned(filled))
    }
}

/// Describes a name without a value, for a message.
fn undefined(part: &str) -> String {
    let is_name = |c: &char| c.is_alphanumeric() || *c == '_';
    format!("${}", part.chars().take_while(is_name).take(60).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_name_that_fits_is_meant() {
        let mut parameters = Parameters::default();
        for (name, value) in [("x", "3"), ("xy", "4"), ("x", "5")] {
            parameters.give(name, value);
        }
        assert_eq!(parameters.filled("$x, $xy,$xyz").unwrap(), "3, 4,4z");
        assert_eq!(parameters.filled("plain").unwrap(), "plain");
        assert_eq!(parameters.filled("$y"), Err(Fault::Undefined("$y".to_string())));
    }

    #[test]
    fn values_do_not_grow_without_end() {
        let mut parameters = Parameters::default();
        parameters.give("a", &"b".repeat(1000));
        assert!(matches!(parameters.filled(&"$a".repeat(100)), Err(Fault::TooMany { .. })));
    }
}
