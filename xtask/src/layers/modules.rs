//! The modules of a package and what their files name of one another, read from source.
//!
//! Names inside of macros are not seen. What is compiled for tests alone is left out.

use anyhow::{Context, Result};
use std::collections::BTreeMap;
use std::fs::read_to_string;
use std::path::Path;
use syn::visit::{self, Visit};
use syn::{Attribute, Ident, ItemFn, ItemImpl, ItemMod, ItemUse, UseTree};

/// A path of names below the root of the package.
pub(super) type Names = Vec<String>;

/// The names in a file.
#[derive(Debug, Default)]
pub(super) struct Module {
    /// Paths that begin at the root.
    pub(super) paths: Vec<Names>,
    /// Names that it imports or passes on, and what they stand for.
    pub(super) imports: BTreeMap<String, Names>,
}

/// All modules of a package by their path, from its first file on; the root is the
/// empty path.
pub(super) fn read(root: &Path) -> Result<BTreeMap<Names, Module>> {
    let mut modules = BTreeMap::new();
    let folder = root.parent().unwrap_or(Path::new("")).to_path_buf();
    let mut open = vec![(Names::new(), root.to_path_buf(), folder)];
    while let Some((path, file, folder)) = open.pop() {
        let text = read_to_string(&file).with_context(|| file.display().to_string())?;
        let (module, children) = parse(&path, &text).with_context(|| file.display().to_string())?;
        for child in children {
            let flat = folder.join(format!("{child}.rs"));
            let below = folder.join(&child);
            let file = if flat.exists() { flat } else { below.join("mod.rs") };
            let path = [path.as_slice(), &[child]].concat();
            open.push((path, file, below));
        }
        modules.insert(path, module);
    }
    Ok(modules)
}

/// Returns the names in a file at this path, and the modules that have files of their own below.
pub(super) fn parse(path: &[String], text: &str) -> Result<(Module, Names)> {
    let mut reader =
        Reader { path: path.to_vec(), module: Module::default(), children: Names::new() };
    reader.visit_file(&syn::parse_file(text)?);
    Ok((reader.module, reader.children))
}

struct Reader {
    path: Names,
    module: Module,
    children: Names,
}

impl Reader {
    /// The path from the root that these names spell, if they begin with `crate`, `self`
    /// or `super`.
    fn absolute(&self, names: &[String]) -> Option<Names> {
        let (first, mut rest) = names.split_first()?;
        let mut path = match first.as_str() {
            "crate" => Names::new(),
            "self" => self.path.clone(),
            "super" => self.path.split_last()?.1.to_vec(),
            _ => return None,
        };
        while let Some((_, further)) = rest.split_first().filter(|(name, _)| *name == "super") {
            path.pop();
            rest = further;
        }
        path.extend_from_slice(rest);
        Some(path)
    }

    fn import(&mut self, before: &mut Names, tree: &UseTree) {
        match tree {
            UseTree::Path(inner) => {
                before.push(inner.ident.to_string());
                self.import(before, &inner.tree);
                before.pop();
            }
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.import(before, tree)),
            UseTree::Name(name) => self.import_one(before, &name.ident, &name.ident),
            UseTree::Rename(rename) => self.import_one(before, &rename.ident, &rename.rename),
            UseTree::Glob(_) => self.module.paths.extend(self.absolute(before)),
        }
    }

    fn import_one(&mut self, before: &[String], name: &Ident, known_as: &Ident) {
        let mut names = before.to_vec();
        if name != "self" {
            names.push(name.to_string());
        }
        // What begins with the name of a child, as where a parent passes names on.
        let path = self.absolute(&names).unwrap_or_else(|| [self.path.as_slice(), &names].concat());
        self.module.imports.insert(known_as.to_string(), path.clone());
        self.module.paths.push(path);
    }
}

impl Visit<'_> for Reader {
    fn visit_item_mod(&mut self, module: &ItemMod) {
        if is_for_tests(&module.attrs) {
            return;
        }
        if module.content.is_none() {
            self.children.push(module.ident.to_string());
            return;
        }
        self.path.push(module.ident.to_string());
        visit::visit_item_mod(self, module);
        self.path.pop();
    }

    fn visit_item_use(&mut self, item: &ItemUse) {
        if !is_for_tests(&item.attrs) {
            self.import(&mut Names::new(), &item.tree);
        }
    }

    fn visit_item_fn(&mut self, item: &ItemFn) {
        if !is_for_tests(&item.attrs) {
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_item_impl(&mut self, item: &ItemImpl) {
        if !is_for_tests(&item.attrs) {
            visit::visit_item_impl(self, item);
        }
    }

    fn visit_path(&mut self, path: &syn::Path) {
        let names: Names = path.segments.iter().map(|part| part.ident.to_string()).collect();
        self.module.paths.extend(self.absolute(&names));
        visit::visit_path(self, path);
    }
}

fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let is_test = |name: Ident| name == "test" || name == "doctest";
        attribute.path().is_ident("cfg") && attribute.parse_args().is_ok_and(is_test)
    })
}
