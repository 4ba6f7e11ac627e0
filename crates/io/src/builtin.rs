//! The scenes compiled in, so that a program needs no file at all.

/// A file's name relative to the folder of scenes, and its bytes.
macro_rules! file {
    ($name:literal) => {
        ($name, include_bytes!(concat!(env!("TRAYLIB_SCENES"), "/", $name)))
    };
}

const FILES: &[(&str, &[u8])] = &[
    file!("cornell.ron"),
    file!("small-light.ron"),
    file!("pyramid.ron"),
    file!("office-lamps.ron"),
    file!("office-points.ron"),
    file!("office-room.ron"),
    file!("plates.ron"),
    file!("furnace.ron"),
    file!("spheres.ron"),
    file!("hangar.ron"),
    file!("models/enemy01.3ds"),
    file!("glass.ron"),
    file!("bump.ron"),
    file!("textures/tiles.png"),
    file!("textures/waves.png"),
    file!("bowl.ron"),
    file!("models/bowl.obj"),
    file!("terrace.ron"),
    file!("textures/sky.hdr"),
    file!("reference-a.ron"),
    file!("reference-c.ron"),
];

/// The names that are scenes; the others belong to them.
const NAMES: &[&str] = &[
    "cornell",
    "small-light",
    "pyramid",
    "office-lamps",
    "office-points",
    "plates",
    "furnace",
    "spheres",
    "hangar",
    "glass",
    "bump",
    "bowl",
    "terrace",
    "reference-a",
    "reference-c",
];

/// Names of the built-in scenes, the one to begin with first.
pub fn builtin_names() -> &'static [&'static str] {
    NAMES
}

/// The bytes of a built-in file.
pub(crate) fn file(name: &str) -> Option<&'static [u8]> {
    FILES.iter().find(|(known, _)| *known == name).map(|&(_, bytes)| bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No scene in the folder is forgotten, and each has a name, unless it is
    /// there to be included.
    #[test]
    fn every_scene_in_the_folder_is_built_in() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes");
        for entry in std::fs::read_dir(folder).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            let Some(scene) = name.strip_suffix(".ron") else { continue };
            assert!(file(&name).is_some(), "{name}");
            assert!(NAMES.contains(&scene) || scene == "office-room", "{name}");
        }
    }
}
