//! The libraries as packages: whether each is whole, and could be published.

use crate::workspace::{cargo, finish};
use anyhow::Result;
use std::process::Command;

/// The libraries that can be published, from the lowest floor up.
const LIBRARIES: [&str; 6] = [
    "traylib-math",
    "traylib-geometry",
    "traylib-materials",
    "traylib-scene",
    "traylib-io",
    "traylib-integrators",
];

/// Packs them, unpacks them elsewhere and builds them there, each against the
/// others' packages. Needs no registry.
pub(crate) fn pack() -> Result<()> {
    of_libraries(cargo(&["package", "--allow-dirty", "--offline"]))
}

/// Does what [`pack`] does, and all that publishing does in their order but to upload them.
/// Asks the registry.
pub(crate) fn publish_dry() -> Result<()> {
    of_libraries(cargo(&["publish", "--dry-run", "--allow-dirty"]))
}

fn of_libraries(mut command: Command) -> Result<()> {
    // Cargo keeps the packages in a registry below the target folder, and takes what it once
    // unpacked from a registry of that path for its content ever after: an earlier version of
    // a library would be built here. A folder that was never used before has no past.
    let folder = tempfile::tempdir()?;
    command.arg("--target-dir").arg(folder.path());
    for package in LIBRARIES {
        command.args(["--package", package]);
    }
    finish(&mut command)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workspace::root;
    use std::fs::read;
    use std::path::{Path, PathBuf};

    fn files(package: &str) -> Vec<String> {
        let list = ["package", "--list", "--allow-dirty", "--offline", "--package", package];
        let output = cargo(&list).output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&output.stdout).lines().map(String::from).collect()
    }

    #[test]
    fn packages_bring_their_licences_and_say_what_they_are() {
        for package in LIBRARIES {
            let files = files(package);
            for wanted in ["README.md", "LICENSE-MIT", "LICENSE-APACHE", "src/lib.rs"] {
                assert!(files.iter().any(|file| file == wanted), "{package}: no {wanted}");
            }
            let foreign = files.iter().find(|file| {
                ["peers", "tests", "scenes/pictures"].iter().any(|of| file.starts_with(of))
            });
            assert_eq!(foreign, None, "{package}");
        }
    }

    #[test]
    fn their_licences_are_the_projects() {
        for file in ["LICENSE-MIT", "LICENSE-APACHE"] {
            let whole = read(root().join(file)).unwrap();
            for package in LIBRARIES {
                let folder = package.replace("traylib-", "crates/");
                assert!(read(root().join(&folder).join(file)).unwrap() == whole, "{folder}/{file}");
            }
        }
    }

    /// Nobody outside can match an error type in full, so causes can be added.
    #[test]
    fn errors_may_get_more_causes() {
        let mut found = 0;
        for file in sources(&root().join("crates")) {
            let text = std::fs::read_to_string(&file).unwrap();
            let lines: Vec<&str> = text.lines().collect();
            for (number, line) in lines.iter().enumerate() {
                let name = line.strip_prefix("pub enum ").unwrap_or_default();
                if name.trim_end_matches(" {").ends_with("Error") {
                    let attributes = &lines[number.saturating_sub(2)..number];
                    assert!(
                        attributes.contains(&"#[non_exhaustive]"),
                        "{}: {line}",
                        file.display()
                    );
                    found += 1;
                }
            }
        }
        assert!(found > 5, "{found}");
    }

    fn sources(folder: &Path) -> Vec<PathBuf> {
        let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let (folders, files): (Vec<PathBuf>, Vec<PathBuf>) =
            entries.partition(|path| path.is_dir());
        let own = files.into_iter().filter(|file| file.extension().is_some_and(|e| e == "rs"));
        own.chain(folders.iter().flat_map(|folder| sources(folder))).collect()
    }

    /// Without a version a package cannot say what it depends on.
    #[test]
    fn what_they_depend_on_has_a_version() {
        let output = cargo(&["metadata", "--format-version", "1", "--no-deps"]).output().unwrap();
        let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let packages = metadata["packages"].as_array().unwrap();
        for package in packages.iter().filter(|p| LIBRARIES.iter().any(|name| p["name"] == *name)) {
            for field in ["description", "readme", "license"] {
                assert!(package[field].is_string(), "{}: no {field}", package["name"]);
            }
            assert!(!package["keywords"].as_array().unwrap().is_empty());
            let used = package["dependencies"].as_array().unwrap().iter();
            for dependency in used.filter(|dependency| dependency["kind"] != "dev") {
                assert_ne!(dependency["req"], "*", "{}", dependency["name"]);
            }
        }
    }
}
