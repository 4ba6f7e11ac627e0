//! Bounds that are checked before anything is done.

use super::Cause;
use crate::Limit;

/// Checks that a number is within its bound.
pub(super) fn limit(
    what: &'static str,
    value: u64,
    limit: u64,
    option: Limit,
) -> Result<(), Cause> {
    if value <= limit { Ok(()) } else { Err(Cause::Limit { what, limit, option }) }
}

/// A bound with the part of it that may still be used.
pub(super) struct Budget {
    what: &'static str,
    limit: u64,
    left: u64,
    option: Limit,
}

impl Budget {
    pub(super) fn new(what: &'static str, limit: u64, option: Limit) -> Self {
        Self { what, limit, left: limit, option }
    }

    /// Returns the part that is left, and the bound.
    pub(super) fn left(&self) -> (u64, u64) {
        (self.left, self.limit)
    }

    pub(super) fn take(&mut self, amount: u64) -> Result<(), Cause> {
        let Self { what, limit, option, .. } = *self;
        self.left = self.left.checked_sub(amount).ok_or(Cause::Limit { what, limit, option })?;
        Ok(())
    }
}
