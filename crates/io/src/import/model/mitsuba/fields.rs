//! The properties of an object, of which none is passed over in silence.

use crate::import::counter::Counter;
use crate::mitsuba::{Class, Document, Object, Value};
use crate::suggest::shown;
use traylib_math::glam::DAffine3;

/// An object whose properties are asked for by name.
pub(super) struct Fields<'a> {
    document: &'a Document,
    pub(super) object: &'a Object,
    /// Flags of the properties, and of the children, that have been asked for.
    used: Vec<bool>,
    used_children: Vec<bool>,
}

impl<'a> Fields<'a> {
    pub(super) fn of(document: &'a Document, object: usize) -> Self {
        let object = &document.objects[object];
        let used = vec![false; object.properties.len()];
        let used_children = vec![false; object.children.len()];
        Self { document, object, used, used_children }
    }

    pub(super) fn value(&mut self, name: &str) -> Option<&'a Value> {
        let all = &self.object.properties;
        let index = all.iter().position(|property| property.name == name)?;
        self.used[index] = true;
        Some(&all[index].value)
    }

    /// Returns what `of` makes of a property; one of another kind counts as not asked for.
    pub(super) fn of_kind<T>(
        &mut self,
        name: &str,
        of: impl Fn(&'a Value) -> Option<T>,
    ) -> Option<T> {
        let all = &self.object.properties;
        let index = all.iter().position(|property| property.name == name)?;
        let found = of(&all[index].value);
        self.used[index] |= found.is_some();
        found
    }

    pub(super) fn number(&mut self, name: &str) -> Option<f64> {
        self.of_kind(name, |value| {
            if let Value::Number(number) | Value::Even(number) = value {
                Some(*number)
            } else {
                None
            }
        })
    }

    pub(super) fn flag(&mut self, name: &str) -> Option<bool> {
        self.of_kind(
            name,
            |value| if let Value::Boolean(flag) = value { Some(*flag) } else { None },
        )
    }

    pub(super) fn text(&mut self, name: &str) -> Option<&'a str> {
        self.of_kind(
            name,
            |value| if let Value::Text(text) = value { Some(text.as_str()) } else { None },
        )
    }

    pub(super) fn vector(&mut self, name: &str) -> Option<[f64; 3]> {
        self.of_kind(name, |value| if let Value::Vector(v) = value { Some(*v) } else { None })
    }

    pub(super) fn transform(&mut self, name: &str) -> Option<DAffine3> {
        self.of_kind(name, |value| if let Value::Transform(t) = value { Some(*t) } else { None })
    }

    /// The place of an object in its own space, `to_world`.
    pub(super) fn place(&mut self) -> DAffine3 {
        self.transform("to_world").unwrap_or(DAffine3::IDENTITY)
    }

    /// The object within that is there for `name`.
    pub(super) fn child(&mut self, name: &str) -> Option<usize> {
        let all = &self.object.children;
        let index = all.iter().position(|child| child.name == name)?;
        self.used_children[index] = true;
        Some(all[index].object)
    }

    /// The objects of a class within, whatever they are there for.
    pub(super) fn children(&mut self, class: Class) -> Vec<usize> {
        let mut found = Vec::new();
        for (index, child) in self.object.children.iter().enumerate() {
            if self.document.objects[child.object].class == class {
                self.used_children[index] = true;
                found.push(child.object);
            }
        }
        found
    }

    /// Lets properties pass that change no picture of ours.
    pub(super) fn ignore(&mut self, names: &[&str]) {
        for (property, used) in self.object.properties.iter().zip(&mut self.used) {
            *used |= names.contains(&property.name.as_str());
        }
    }

    /// Counts what nobody has asked for.
    pub(super) fn finish(self, counter: &mut Counter) {
        let kind = shown(&self.object.kind);
        for (property, used) in self.object.properties.iter().zip(self.used) {
            if !used {
                counter.add(format!("`{}` of `{kind}` skipped", shown(&property.name)));
            }
        }
        for (child, used) in self.object.children.iter().zip(self.used_children) {
            if !used {
                let child = &self.document.objects[child.object];
                let class = child.class.name();
                counter.add(format!("{class} `{}` within `{kind}` skipped", shown(&child.kind)));
            }
        }
    }
}
