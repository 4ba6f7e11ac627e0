//! `cargo xtask check-data DIR`: real files, and what others found in them.

mod agree;
mod pixels;

use agree::differences;
use anyhow::{Context, Result, ensure};
use serde_json::Value;
use std::path::{Path, PathBuf};
use traylib_io::{LoadOptions, inventory, printable};

/// The entries of the lists on which ours differs from another reader for a reason: file, key,
/// reason.
const OTHERWISE: [(&str, &str, &str); 1] = [(
    "player02.3DS",
    "pose_at_frame_0",
    "its mesh has mirrored axes: lib3ds reflects the vertices and turns the closed surface \
     inside out, here they stay as stored",
)];

/// A scene of the list: its files, and what should be found in them, or the place of
/// the error that they should end with.
struct Expected<'a> {
    files: Vec<PathBuf>,
    found: Result<&'a Value, &'a str>,
}

/// Reads every file that the lists name; an error unless all are as expected.
pub(crate) fn run(folder: &str) -> Result<()> {
    let folder = Path::new(folder);
    let three_ds = list(&folder.join("3ds/expected.json"))?;
    let mgf = list(&folder.join("mgf/expected.json"))?;
    let expected: Vec<Expected<'_>> =
        meshes(folder, &three_ds)?.into_iter().chain(scenes(folder, &mgf)?).collect();
    ensure!(!expected.is_empty(), "{}: the lists are empty", folder.display());
    let (mut agree, mut count) = pictures(folder)?;
    agree += expected.iter().filter(|expected| holds(expected, folder)).count();
    count += expected.len();
    println!("{agree} of {count} files agree");
    ensure!(agree == count, "not all files agree");
    Ok(())
}

/// Counts the pictures that have the expected pixels, and all pictures.
fn pictures(folder: &Path) -> Result<(usize, usize)> {
    let (mut agree, mut count) = (0, 0);
    for part in ["textures", "pictures"] {
        let folder = folder.join(part);
        let list = &list(&folder.join("expected.json"))?["files"];
        let files = list.as_object().with_context(|| format!("{part} has no `files`"))?;
        for name in files.keys() {
            let complaint = pixels::complaint(&folder, list, name);
            if let Some(complaint) = &complaint {
                tell(&folder.join(name).display().to_string(), complaint);
            }
            agree += usize::from(complaint.is_none());
            count += 1;
        }
    }
    Ok((agree, count))
}

fn list(file: &Path) -> Result<Value> {
    let text = std::fs::read_to_string(file).with_context(|| file.display().to_string())?;
    serde_json::from_str(&text).with_context(|| file.display().to_string())
}

fn meshes<'a>(folder: &Path, list: &'a Value) -> Result<Vec<Expected<'a>>> {
    let files = list["files"].as_object().context("3ds/expected.json has no `files`")?;
    let expected = |(name, found): (&String, &'a Value)| Expected {
        files: vec![folder.join("3ds").join(name)],
        found: Ok(found),
    };
    Ok(files.iter().map(expected).collect())
}

fn scenes<'a>(folder: &Path, list: &'a Value) -> Result<Vec<Expected<'a>>> {
    let scenes = list["scenes"].as_array().context("mgf/expected.json has no `scenes`")?;
    let expected = |scene: &'a Value| {
        let names = scene["files"].as_array()?.iter().filter_map(Value::as_str);
        let files = names.map(|name| folder.join("mgf").join(name)).collect();
        let stopped = scene["parser_stopped_with"]["where"].as_str();
        Some(Expected { files, found: stopped.map_or(Ok(&scene["expanded"]), Err) })
    };
    scenes.iter().map(|scene| expected(scene).context("a scene without `files`")).collect()
}

/// Reads and compares; tells of whatever differs.
fn holds(expected: &Expected<'_>, folder: &Path) -> bool {
    let name = expected.files.last().map_or_else(String::new, |file| file.display().to_string());
    // Some scenes include from the folder beside their own.
    let root = folder.join("mgf");
    let options = LoadOptions { root: Some(&root), ..LoadOptions::default() };
    let found = inventory(&expected.files, options);
    let complaint = match (found, expected.found) {
        (Ok((found, _)), Ok(expected)) => match serde_json::to_value(found) {
            Ok(found) => differences(expected, &found),
            Err(error) => vec![error.to_string()],
        },
        (Err(error), Err(place)) => misplaced(&error.to_string(), place),
        (Ok(_), Err(place)) => vec![format!("no error, expected one at {place}")],
        (Err(error), Ok(_)) => vec![error.to_string()],
    };
    complaint.iter().fold(true, |holds, line| holds & is_meant(&name, line))
}

/// Tells of a difference; whether it is one of [`OTHERWISE`].
fn is_meant(name: &str, line: &str) -> bool {
    let meant =
        |(file, key, _): &&(&str, &str, &str)| name.ends_with(file) && line.starts_with(key);
    match OTHERWISE.iter().find(meant) {
        Some((_, key, reason)) => tell(name, &format!("{key} otherwise: {reason}")),
        None => tell(name, line),
    }
    OTHERWISE.iter().any(|entry| meant(&entry))
}

/// Says something of a file, in words that may be the file's own.
fn tell(name: &str, what: &str) {
    eprintln!("{}", printable(&format!("{name}: {what}")));
}

/// `place` begins with file and line, as `chair.mgf: 4: Undefined reference`.
fn misplaced(error: &str, place: &str) -> Vec<String> {
    let mut words = place.split(':');
    let (file, line) = (words.next().unwrap_or_default(), words.next().unwrap_or_default().trim());
    let wanted = format!("{file}:{line}:");
    if error.contains(&wanted) {
        Vec::new()
    } else {
        vec![format!("{error}, expected at {wanted}")]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_held_to_their_place() {
        let place = "chair.mgf: 4: Undefined reference";
        assert!(misplaced("a/chair.mgf:4: c: no colour", place).is_empty());
        assert_eq!(misplaced("a/chair.mgf:14: c: no colour", place).len(), 1);
    }

    #[test]
    fn a_folder_without_lists_is_an_error() {
        assert!(run("no-such-folder").is_err());
    }
}
