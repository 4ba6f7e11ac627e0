//! Bounds on what is taken in of a file.

use super::{WarningKind, Warnings};

/// Bounds on what is taken in of a file. What exceeds it is skipped with a warning.
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

/// The numbers of items and maps that the limit leaves.
#[derive(Debug)]
pub(super) struct Remaining {
    items: usize,
    maps: usize,
}

impl Remaining {
    pub(super) fn new(limits: Limits) -> Self {
        Self { items: limits.items, maps: limits.items }
    }

    /// Takes one item off, if any is left.
    pub(super) fn take(&mut self, warnings: &mut Warnings) -> bool {
        take(&mut self.items, warnings)
    }

    /// Takes one map off, if any is left.
    pub(super) fn take_map(&mut self, warnings: &mut Warnings) -> bool {
        take(&mut self.maps, warnings)
    }
}

fn take(remaining: &mut usize, warnings: &mut Warnings) -> bool {
    let left = remaining.checked_sub(1);
    match left {
        Some(left) => *remaining = left,
        None => warnings.add(WarningKind::TooManyItems),
    }
    left.is_some()
}
