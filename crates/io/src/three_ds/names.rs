//! Materials by their names.

use super::Material;
use std::collections::HashMap;

/// Looks materials up by name: byte for byte, else without case and trailing
/// blanks.
pub(super) struct MaterialNames {
    exact: HashMap<String, usize>,
    loose: HashMap<String, usize>,
}

impl MaterialNames {
    pub(super) fn new(materials: &[Material]) -> Self {
        let mut names = Self { exact: HashMap::new(), loose: HashMap::new() };
        for (index, material) in materials.iter().enumerate() {
            names.exact.entry(material.name.clone()).or_insert(index);
            names.loose.entry(loose(&material.name)).or_insert(index);
        }
        names
    }

    pub(super) fn find(&self, name: &str) -> Option<usize> {
        self.exact.get(name).or_else(|| self.loose.get(&loose(name))).copied()
    }
}

fn loose(name: &str) -> String {
    name.trim_end().to_lowercase()
}
