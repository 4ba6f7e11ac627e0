//! Circles of files that are as they should be, each with its reason.

/// Package, the module that names and the one that is named, why.
const NATURAL: &[[&str; 4]] = &[];

/// Whether the arrow is one of these.
pub(super) fn is(package: &str, from: &str, to: &str) -> bool {
    NATURAL.iter().any(|[of, a, b, _]| [*of, *a, *b] == [package, from, to])
}
