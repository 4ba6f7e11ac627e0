//! Pictures of other programs, to stand on the same chart.

use crate::picture::double;
use crate::radiance;
use crate::reference::Reference;
use crate::results::OutsidePoint;
use serde::Deserialize;
use std::path::{Path, PathBuf};
use traylib_demos::{Failure, say};
use traylib_io::builtin_names;
use traylib_math::{Grid, Rgb};

/// One picture, as a file of outside points lists it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OutsideEntry {
    /// The scene that it shows, by its name: of a file, that without folder and ending.
    scene: String,
    /// The name under which it is shown.
    name: String,
    /// The time that it took, in seconds.
    seconds: f64,
    /// Linear radiance, EXR or Radiance; relative names are looked up beside the list.
    picture: PathBuf,
}

/// Reads a list of pictures: JSON, an array of objects with `scene`, `name`,
/// `seconds` and `picture`.
///
/// # Errors
/// The file cannot be read or makes no sense.
pub fn read(file: &Path) -> Result<Vec<OutsideEntry>, Failure> {
    let failure = |text: String| Failure::scene(format_args!("{}: {text}", file.display()));
    let text = std::fs::read_to_string(file)
        .map_err(|error| failure(format!("cannot be read: {error}")))?;
    let mut entries: Vec<OutsideEntry> = serde_json::from_str(&text).map_err(|error| {
        let wanted = r#"wanted: [{"scene": "cornell", "name": "mine", "seconds": 8, "picture": "mine.exr"}]"#;
        failure(format!("{error}; {wanted}"))
    })?;
    if let Some(entry) = entries.iter().find(|entry| entry.seconds <= 0.0) {
        return Err(failure(format!("`{}` took {} s, wanted more", entry.name, entry.seconds)));
    }
    let folder = file.parent().unwrap_or(Path::new(""));
    for entry in &mut entries {
        entry.picture = folder.join(&entry.picture);
    }
    Ok(entries)
}

/// Refuses pictures of scenes that are not there, which would otherwise never be
/// looked at. Tells, by their number, of those of built-in scenes that are not `compared`:
/// one list may serve several comparisons.
///
/// # Errors
/// A scene is neither compared nor built in.
pub fn check_scenes(
    file: &Path,
    entries: &[OutsideEntry],
    compared: &[&str],
) -> Result<Option<String>, Failure> {
    let left: Vec<&OutsideEntry> =
        entries.iter().filter(|entry| !compared.contains(&entry.scene.as_str())).collect();
    if let Some(entry) = left.iter().find(|e| !builtin_names().contains(&e.scene.as_str())) {
        return Err(Failure::usage(format_args!(
            "--outside {}: `{}` is a picture of `{}`, which is not compared; {}",
            file.display(),
            entry.name,
            entry.scene,
            wanted(compared)
        )));
    }
    let warning = format!(
        "{}: {} of {} pictures are of scenes that are not compared",
        file.display(),
        left.len(),
        entries.len()
    );
    Ok((!left.is_empty()).then_some(warning))
}

fn wanted(compared: &[&str]) -> String {
    if compared.is_empty() {
        return "no scene is".into();
    }
    let quoted: Vec<String> = compared.iter().map(|name| format!("`{name}`")).collect();
    format!("compared: {}", quoted.join(", "))
}

/// Reads the pictures of a scene, before hours of work, to see whether they have its size.
///
/// # Errors
/// A picture cannot be read, or has another size.
pub fn check_pictures(
    entries: &[OutsideEntry],
    scene: &str,
    size: (usize, usize),
) -> Result<(), Failure> {
    entries.iter().filter(|entry| entry.scene == scene).try_for_each(|entry| {
        let picture = radiance::load(&entry.picture)?;
        warn_of_another(&entry.picture, scene);
        same_size(&entry.picture, &picture, size)
    })
}

/// Tells of a picture that says it shows another scene.
pub fn warn_of_another(picture: &Path, scene: &str) {
    if let Some(what) = radiance::another_scene(picture, scene) {
        say(format_args!("warning: {what}"));
    }
}

/// Measures the pictures of a scene.
///
/// # Errors
/// A picture cannot be read, or has another size than the reference.
pub fn measure(
    entries: &[OutsideEntry],
    scene: &str,
    reference: &Reference,
) -> Result<Vec<(OutsidePoint, Grid<Rgb>)>, Failure> {
    entries.iter().filter(|entry| entry.scene == scene).map(|e| one(e, reference)).collect()
}

fn one(entry: &OutsideEntry, reference: &Reference) -> Result<(OutsidePoint, Grid<Rgb>), Failure> {
    let picture = radiance::load(&entry.picture)?;
    same_size(&entry.picture, &picture, (reference.picture.width(), reference.picture.height()))?;
    let error = reference.less_own(reference.rel_mse(&double(&picture)));
    let solid = reference.is_solid_at(error);
    let point = OutsidePoint { name: entry.name.clone(), seconds: entry.seconds, error, solid };
    Ok((point, picture))
}

/// A picture must have the size of those it is compared with.
///
/// # Errors
/// It has not.
pub fn same_size(
    file: &Path,
    picture: &Grid<Rgb>,
    (width, height): (usize, usize),
) -> Result<(), Failure> {
    if (picture.width(), picture.height()) == (width, height) {
        return Ok(());
    }
    let (found_width, found_height) = (picture.width(), picture.height());
    Err(Failure::scene(format_args!(
        "{}: has {found_width}x{found_height} pixels where {width}x{height} are compared; \
         ask for --resolution {found_width}x{found_height}",
        file.display()
    )))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_text(text: &str) -> Result<Vec<OutsideEntry>, Failure> {
        let name = format!("traylib-outside-{}-{:p}.json", std::process::id(), text);
        let file = std::env::temp_dir().join(name);
        std::fs::write(&file, text).unwrap();
        let entries = read(&file);
        std::fs::remove_file(file).unwrap();
        entries
    }

    #[test]
    fn a_list_names_pictures_beside_it() {
        let text = r#"[{"scene": "s", "name": "mine", "seconds": 2.5, "picture": "a.exr"}]"#;
        let entries = read_text(text).unwrap();
        assert_eq!(entries[0].picture, std::env::temp_dir().join("a.exr"));
        assert_eq!(entries[0].seconds, 2.5);
    }

    #[test]
    fn a_list_that_makes_no_sense_is_refused_with_an_example() {
        let error = read_text(r#"[{"scene": "s"}]"#).unwrap_err().to_string();
        assert!(error.contains("wanted: [{"), "{error}");
        let slow = r#"[{"scene": "s", "name": "n", "seconds": 0, "picture": "a.exr"}]"#;
        assert!(read_text(slow).unwrap_err().to_string().contains("wanted more"));
    }

    #[test]
    fn pictures_of_no_scene_are_refused_and_of_another_told() {
        let of = |scene: &str| OutsideEntry {
            scene: scene.into(),
            name: "mine".into(),
            seconds: 1.0,
            picture: PathBuf::new(),
        };
        let check = |scenes: &[&str]| {
            let entries: Vec<OutsideEntry> = scenes.iter().map(|scene| of(scene)).collect();
            check_scenes(Path::new("l.json"), &entries, &["cornell", "my"])
        };
        assert_eq!(check(&["cornell", "my"]).unwrap(), None);
        let told = check(&["cornell", "pyramid"]).unwrap().unwrap();
        assert!(told.contains("1 of 2 pictures"), "{told}");
        let refused = check(&["cornell", "cornel"]).unwrap_err().to_string();
        let expected = "error: --outside l.json: `mine` is a picture of `cornel`, which is not \
                        compared; compared: `cornell`, `my`";
        assert_eq!(refused, expected);
    }

    #[test]
    fn another_size_is_refused() {
        let picture = Grid::filled(3, 2, Rgb::BLACK);
        let error = same_size(Path::new("a.exr"), &picture, (4, 2)).unwrap_err().to_string();
        assert!(error.contains("--resolution 3x2"), "{error}");
        assert!(same_size(Path::new("a.exr"), &picture, (3, 2)).is_ok());
    }
}
