//! Contexts: values with names, one of which is current.

use super::Cause;
use super::error::shown;
use std::collections::HashMap;
use std::sync::Arc;

/// Memory of a name beside its letters and its value: both counts of the `Arc`, and an
/// entry of a table while it grows.
const ENTRY: usize = 112;

/// The context of one kind: the unnamed value and all named ones.
pub(super) struct Names<T> {
    /// Colour, material or vertex, for messages.
    what: &'static str,
    slots: HashMap<Arc<str>, usize>,
    /// Slot 0 is the unnamed one.
    values: Vec<(Arc<str>, T)>,
    current: usize,
    /// The number of definitions of names, repeated ones included.
    pub(super) definitions: u64,
    /// The memory that the names take, in bytes.
    pub(super) kept: u64,
}

impl<T: Clone + Default> Names<T> {
    pub(super) fn new(what: &'static str) -> Self {
        let values = vec![(Arc::from(""), T::default())];
        Self { what, slots: HashMap::new(), values, current: 0, definitions: 0, kept: 0 }
    }

    /// Carries out `X`, `X id`, `X id =` or `X id = template`.
    pub(super) fn select(&mut self, words: &[&str]) -> Result<(), Cause> {
        match *words {
            [] => {
                self.current = 0;
                *self.current_mut() = T::default();
            }
            [name] => self.current = self.slot(name)?,
            [name, "="] => self.define(name, T::default()),
            [name, "=", template] => self.define(name, self.get(template)?.clone()),
            _ => {
                let expected = "nothing, a name, `name =` or `name = template`";
                return Err(Cause::Arguments { expected, found: words.len() });
            }
        }
        Ok(())
    }

    fn define(&mut self, name: &str, value: T) {
        self.definitions += 1;
        if let Some(&slot) = self.slots.get(name) {
            self.current = slot;
            self.values[slot].1 = value;
            return;
        }
        self.kept += (name.len() + size_of::<(Arc<str>, T)>() + ENTRY) as u64;
        let name: Arc<str> = Arc::from(name);
        self.current = self.values.len();
        self.slots.insert(Arc::clone(&name), self.current);
        self.values.push((name, value));
    }

    fn slot(&self, name: &str) -> Result<usize, Cause> {
        let undefined = || Cause::Undefined { what: self.what, name: shown(name) };
        self.slots.get(name).copied().ok_or_else(undefined)
    }

    /// The value that has a name.
    pub(super) fn get(&self, name: &str) -> Result<&T, Cause> {
        self.slot(name).map(|slot| &self.values[slot].1)
    }

    /// The current value, by the number of its slot, its name and itself.
    pub(super) fn current(&self) -> (usize, &Arc<str>, &T) {
        let (name, value) = &self.values[self.current];
        (self.current, name, value)
    }

    pub(super) fn current_mut(&mut self) -> &mut T {
        &mut self.values[self.current].1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn after(lines: &[&str]) -> Names<i32> {
        let mut names = Names::new("number");
        for line in lines {
            match line.strip_prefix("set ") {
                Some(value) => *names.current_mut() = value.parse().unwrap(),
                None => names.select(&line.split_whitespace().collect::<Vec<_>>()).unwrap(),
            }
        }
        names
    }

    #[test]
    fn the_unnamed_value_is_reset_whenever_it_is_made_current() {
        let names = after(&["set 5", "a =", "set 6", ""]);
        assert_eq!(names.current(), (0, &Arc::from(""), &0));
        assert_eq!(names.get("a").unwrap(), &6);
    }

    #[test]
    fn a_name_made_current_again_changes_for_good() {
        let names = after(&["a =", "set 1", "b =", "set 2", "a", "set 3", "b"]);
        assert_eq!((names.get("a").unwrap(), names.current()), (&3, (2, &Arc::from("b"), &2)));
    }

    #[test]
    fn a_template_is_copied_once() {
        let names = after(&["a =", "set 1", "b = a", "a", "set 2", "a = a"]);
        assert_eq!((names.get("b").unwrap(), names.get("a").unwrap()), (&1, &2));
        assert_eq!(names.definitions, 3);
    }

    #[test]
    fn redefinition_begins_from_the_defaults() {
        assert_eq!(after(&["a =", "set 1", "a ="]).get("a").unwrap(), &0);
    }

    #[test]
    fn undefined_names_and_other_forms_are_refused() {
        let mut names = after(&["a ="]);
        for words in [&["b"][..], &["="], &["b", "=", "b"], &["c", "=", "d"]] {
            assert!(matches!(names.select(words), Err(Cause::Undefined { .. })), "{words:?}");
        }
        for words in [&["a", "a"][..], &["a", "=", "a", "a"], &["a", "is", "a"]] {
            assert!(matches!(names.select(words), Err(Cause::Arguments { .. })), "{words:?}");
        }
        assert_eq!(&**names.current().1, "a");
    }
}
