//! Bounds on how much a file may hold in all.

use super::Cause;
use crate::Limit;

/// A bound with the part of it that is left.
pub(super) struct Budget {
    what: &'static str,
    limit: Limit,
    most: u64,
    left: u64,
}

impl Budget {
    pub(super) fn new(what: &'static str, limit: Limit, most: u64) -> Self {
        Self { what, limit, most, left: most }
    }

    pub(super) fn take(&mut self, count: u64) -> Result<(), Cause> {
        let Self { what, limit, most, .. } = *self;
        self.left = self.left.checked_sub(count).ok_or(Cause::TooMany { what, most, limit })?;
        Ok(())
    }
}
