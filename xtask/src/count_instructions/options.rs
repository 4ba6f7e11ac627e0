//! The options of counting instructions: what is counted, and where it is kept.

use anyhow::{Context, Result, bail};
use std::path::PathBuf;

pub(super) const HELP: &str = "\
Instructions a ray and a triangle, counted by valgrind.

Usage: cargo xtask count-instructions [PART…] [OPTIONS]

  PART            only cases whose name contains one of these, as `small` or `bounces`
  --save FILE     keep the counts, as JSON
  --against FILE  and show the change from these";

#[derive(Debug, Default, PartialEq)]
pub(super) struct Options {
    parts: Vec<String>,
    pub(super) save: Option<PathBuf>,
    pub(super) against: Option<PathBuf>,
}

impl Options {
    /// `None` where help was asked for.
    pub(super) fn parse(arguments: &[&str]) -> Result<Option<Self>> {
        let mut options = Self::default();
        let mut words = arguments.iter();
        while let Some(&word) = words.next() {
            let mut file = || {
                let name = words.next().with_context(|| format!("{word} which file?\n\n{HELP}"));
                // File names are meant from where the user stands.
                anyhow::Ok(Some(std::env::current_dir()?.join(name?)))
            };
            match word {
                "--save" => options.save = file()?,
                "--against" => options.against = file()?,
                "--help" | "-h" => return Ok(None),
                _ if word.starts_with('-') => bail!("no option is named `{word}`\n\n{HELP}"),
                part => options.parts.push(part.to_owned()),
            }
        }
        Ok(Some(options))
    }

    pub(super) fn wants(&self, case: &str) -> bool {
        self.parts.is_empty() || self.parts.iter().any(|part| case.contains(part.as_str()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_and_files_in_any_order() {
        let options = Options::parse(&["small", "--against", "/a", "shadow"]).unwrap().unwrap();
        assert_eq!((options.against.clone(), options.save.clone()), (Some("/a".into()), None));
        assert!(options.wants("medium/shadow") && options.wants("small/primary"));
        assert!(!options.wants("medium/primary") && Options::default().wants("medium/primary"));
    }

    #[test]
    fn what_is_not_understood_is_an_error() {
        assert!(Options::parse(&["--save"]).is_err());
        assert!(Options::parse(&["--safe", "a"]).is_err());
        assert_eq!(Options::parse(&["small", "--help"]).unwrap(), None);
    }
}
