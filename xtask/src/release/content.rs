//! What is in an archive.

use super::PROGRAMS;
use super::archive::File;
use crate::workspace::root;
use anyhow::{Context, Result, ensure};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Pages that everybody needs who gets the programs.
const PAGES: [&str; 4] = ["README.md", "CHANGELOG.md", "LICENSE-MIT", "LICENSE-APACHE"];

/// Folders of scenes, all of whose files come along.
const SCENES: [&str; 4] = ["scenes", "scenes/models", "scenes/textures", "scenes/pictures"];

/// Where shells look for completions of a program, and what its file is called there.
const SHELLS: [(&str, &str, &str, &str); 3] = [
    ("bash", "share/bash-completion/completions", "", ""),
    ("zsh", "share/zsh/site-functions", "_", ""),
    ("fish", "share/fish/vendor_completions.d", "", ".fish"),
];

/// Collects the files: programs of the folder `built`, which end in `ending`, and what those of
/// the folder `own`, which run here, tell of themselves.
pub(super) fn files(own: &Path, built: &Path, ending: &str) -> Result<Vec<File>> {
    let mut files = Vec::new();
    for page in PAGES {
        files.push(File::plain(page, read(&root().join(page))?));
    }
    for folder in SCENES {
        for entry in fs::read_dir(root().join(folder))? {
            let path = entry?.path();
            let name = path.file_name().and_then(|name| name.to_str()).context("a strange name")?;
            if path.is_file() {
                files.push(File::plain(&format!("{folder}/{name}"), read(&path)?));
            }
        }
    }
    for program in PROGRAMS {
        let name = format!("{program}{ending}");
        files.push(File::program(&format!("bin/{name}"), read(&built.join(&name))?));
        let tell = |words: &[&str]| told(&own.join(program), words);
        files.push(File::plain(&format!("share/man/man1/{program}.1"), tell(&["--man"])?));
        for (shell, folder, before, after) in SHELLS {
            let path = format!("{folder}/{before}{program}{after}");
            files.push(File::plain(&path, tell(&["--completions", shell])?));
        }
    }
    Ok(files)
}

fn read(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).with_context(|| format!("{} cannot be read", path.display()))
}

/// What a program prints.
fn told(program: &Path, words: &[&str]) -> Result<Vec<u8>> {
    let output = Command::new(program).args(words).output();
    let output = output.with_context(|| format!("{} does not start", program.display()))?;
    let is_something = output.status.success() && !output.stdout.is_empty();
    ensure!(is_something, "{} {} says nothing", program.display(), words.join(" "));
    Ok(output.stdout)
}

#[cfg(test)]
mod tests {
    use super::super::PACKAGES;
    use super::*;
    use crate::workspace::cargo;

    /// A program that is added to the packages is not forgotten here.
    #[test]
    fn all_programs_of_the_packages_come_along() {
        let output = cargo(&["metadata", "--format-version", "1", "--no-deps"]).output().unwrap();
        let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let packages = metadata["packages"].as_array().unwrap().iter();
        let of_ours =
            packages.filter(|package| PACKAGES.iter().any(|name| package["name"] == *name));
        let targets = of_ours.flat_map(|package| package["targets"].as_array().unwrap());
        let programs = targets.filter(|target| target["kind"][0] == "bin");
        let mut names: Vec<&str> =
            programs.map(|target| target["name"].as_str().unwrap()).collect();
        let mut packed = PROGRAMS.to_vec();
        names.sort_unstable();
        packed.sort_unstable();
        assert_eq!(names, packed);
    }

    /// With a program that says its own name in place of all of them.
    #[cfg(unix)]
    #[test]
    fn an_archive_has_programs_pages_and_licences() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        for program in PROGRAMS {
            let path = folder.path().join(program);
            fs::write(&path, "#!/bin/sh\necho \"$0 $*\"\n").unwrap();
            fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
        }
        let files = files(folder.path(), folder.path(), "").unwrap();
        for path in [
            "bin/bdpt",
            "share/man/man1/film.1",
            "share/zsh/site-functions/_trace",
            "LICENSE-MIT",
            "scenes/cornell.ron",
            "scenes/textures/sky.hdr",
        ] {
            assert!(files.iter().any(|file| file.path == path), "{path}");
        }
        let page = files.iter().find(|file| file.path == "share/man/man1/film.1").unwrap();
        assert!(String::from_utf8_lossy(&page.bytes).ends_with("film --man\n"));
        assert!(files.iter().filter(|file| file.is_program).count() == PROGRAMS.len());
    }
}
