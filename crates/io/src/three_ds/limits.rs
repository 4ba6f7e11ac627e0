//! How much of a file is taken in.

use super::{WarningKind, Warnings};

/// How much of a file is taken in. What exceeds it is skipped with a warning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The most meshes, lights, cameras, materials and nodes together.
    pub items: usize,
}

impl Default for Limits {
    /// A million items.
    fn default() -> Self {
        Self { items: 1_000_000 }
    }
}

/// What is left of the limit.
#[derive(Debug)]
pub(super) struct Room(usize);

impl Room {
    pub(super) fn new(limits: Limits) -> Self {
        Self(limits.items)
    }

    /// Takes room for one item, if there is any.
    pub(super) fn take(&mut self, warnings: &mut Warnings) -> bool {
        let left = self.0.checked_sub(1);
        match left {
            Some(left) => self.0 = left,
            None => warnings.add(WarningKind::TooManyItems),
        }
        left.is_some()
    }
}
