//! Building a tree.
