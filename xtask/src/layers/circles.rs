//! Circles of files: modules side by side that need one another.
//!
//! A parent and what is below it count as one, seen from outside; between the two an arrow
//! may go either way.

use super::modules::{Module, Names};
use std::collections::{BTreeMap, BTreeSet};

/// An arrow between two modules of one parent, and the file that draws it.
type Arrows = BTreeMap<(Names, Names), Names>;

/// A line for each arrow that is part of a circle.
pub(super) fn circles(modules: &BTreeMap<Names, Module>) -> Vec<String> {
    let mut arrows = Arrows::new();
    for (from, module) in modules {
        for path in &module.paths {
            let to = home(modules, path);
            if let Some(arrow) = between(from, &to) {
                arrows.entry(arrow).or_insert_with(|| from.clone());
            }
        }
    }
    let circular = arrows.iter().filter(|((from, to), _)| leads(&arrows, to, from));
    circular
        .map(|((from, to), file)| {
            let [from, to, file] = [from, to, file].map(|path| path.join("::"));
            let by = if file == from { String::new() } else { format!(" (by {file})") };
            format!("{from} -> {to}{by}: part of a circle")
        })
        .collect()
}

/// The module that a path leads into, names that are passed on followed to where they are
/// at home.
fn home(modules: &BTreeMap<Names, Module>, path: &[String]) -> Names {
    let mut path = path.to_vec();
    // A name that is passed on in a circle does not compile.
    for _ in 0..16 {
        let depth = (0..=path.len()).rev().find(|&depth| modules.contains_key(&path[..depth]));
        let depth = depth.unwrap_or(0);
        let next = path.get(depth).and_then(|name| modules.get(&path[..depth])?.imports.get(name));
        match next {
            Some(next) => path = [next.as_slice(), &path[depth + 1..]].concat(),
            None => return path[..depth].to_vec(),
        }
    }
    path
}

/// The two below the last common parent, if neither is above the other.
fn between(from: &[String], to: &[String]) -> Option<(Names, Names)> {
    let common = from.iter().zip(to).take_while(|(a, b)| a == b).count();
    let is_beside = from.len() > common && to.len() > common;
    is_beside.then(|| (from[..=common].to_vec(), to[..=common].to_vec()))
}

/// Tells whether arrows lead from one to the other.
fn leads(arrows: &Arrows, from: &Names, to: &Names) -> bool {
    let mut seen = BTreeSet::new();
    let mut open = vec![from];
    while let Some(at) = open.pop() {
        if at == to {
            return true;
        }
        if seen.insert(at) {
            open.extend(arrows.keys().filter(|(start, _)| start == at).map(|(_, end)| end));
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layers::modules::parse;

    /// The circles of a package with these files.
    fn found(files: &[(&str, &str)]) -> Vec<String> {
        let modules = files.iter().map(|(path, text)| {
            let path: Names = path.split("::").filter(|n| !n.is_empty()).map(Into::into).collect();
            (path.clone(), parse(&path, text).unwrap().0)
        });
        circles(&modules.collect())
    }

    #[test]
    fn two_that_need_each_other_are_a_circle() {
        let a = ("a", "use crate::b::B; pub struct A(B);");
        let back = found(&[("", "mod a; mod b;"), a, ("b", "pub type B = crate::a::A;")]);
        assert_eq!(back, ["a -> b: part of a circle", "b -> a: part of a circle"]);
        assert!(found(&[("", "mod a; mod b;"), a, ("b", "pub struct B;")]).is_empty());
    }

    #[test]
    fn a_name_that_is_passed_on_leads_to_its_home() {
        let root = ("", "mod a; mod b; mod c; pub use a::A; pub use c::C;");
        let files = [root, ("a", "use crate::C; pub struct A;"), ("b", ""), ("c", "use super::A;")];
        assert_eq!(found(&files).len(), 2);
    }

    #[test]
    fn parents_and_children_are_one() {
        let inside =
            [("", "mod a;"), ("a", "mod b; use b::B; pub struct A;"), ("a::b", "use super::A;")];
        assert!(found(&inside).is_empty());
        let outside = [
            ("", "mod a; mod c;"),
            ("a", "mod b; pub struct A;"),
            ("a::b", "use crate::c::C;"),
            ("c", "use crate::a::A;"),
        ];
        assert_eq!(
            found(&outside),
            ["a -> c (by a::b): part of a circle", "c -> a: part of a circle"]
        );
    }

    #[test]
    fn what_is_for_tests_alone_does_not_count() {
        let tests = "pub struct B; #[cfg(test)] mod tests { use crate::a::A; }";
        assert!(
            found(&[("", "mod a; mod b;"), ("a", "use crate::b::B;"), ("b", tests)]).is_empty()
        );
    }
}
