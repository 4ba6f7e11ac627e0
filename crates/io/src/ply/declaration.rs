//! Elements, as the header of a PLY file declares them.

use super::kind::Kind;

/// A kind of element: its name, how many there are, and what each consists of.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

#[derive(Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
}
