//! How much of a file is taken in.

use super::{WarningKind, Warnings};

/// How much of a file is taken in. What exceeds it is skipped with a warning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The most meshes, lights, cameras, materials and nodes together; and the most
    /// maps.
    pub items: usize,
    /// The most bytes of a file. What is decoded takes up to thirteen times as much
    /// memory.
    pub bytes: usize,
}

impl Default for Limits {
    /// 2¹⁷ items, and 2²⁴ bytes.
    fn default() -> Self {
        Self { items: 1 << 17, bytes: 1 << 24 }
    }
}

/// What is left of the limit.
#[derive(Debug)]
pub(super) struct Room {
    items: usize,
    maps: usize,
}

impl Room {
    pub(super) fn new(limits: Limits) -> Self {
        Self { items: limits.items, maps: limits.items }
    }

    /// Takes room for one item, if there is any.
    pub(super) fn take(&mut self, warnings: &mut Warnings) -> bool {
        take(&mut self.items, warnings)
    }

    /// Takes room for one map, if there is any.
    pub(super) fn take_map(&mut self, warnings: &mut Warnings) -> bool {
        take(&mut self.maps, warnings)
    }
}

fn take(room: &mut usize, warnings: &mut Warnings) -> bool {
    let left = room.checked_sub(1);
    match left {
        Some(left) => *room = left,
        None => warnings.add(WarningKind::TooManyItems),
    }
    left.is_some()
}
