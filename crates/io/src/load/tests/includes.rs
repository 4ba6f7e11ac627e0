//! Scene files that include others, and files with many errors.

use super::*;
use crate::picture::tests::Folder;
use std::time::Instant;

fn load_in(folder: &Folder, root: Option<&Path>) -> Result<Loaded, String> {
    let file = folder.path().join("in/scene.ron");
    let options = LoadOptions { root, ..LoadOptions::default() };
    let loaded = load_scene_with(&file.to_string_lossy(), options);
    loaded.map_err(|error| error.to_string().replace(&*folder.path().to_string_lossy(), "@"))
}

/// A folder with `in/scene.ron`, which includes these, and other files.
fn folder(test: &str, includes: &[&str], others: &[(&str, &str)]) -> Folder {
    let folder = Folder::new(test);
    fs::create_dir_all(folder.path().join("in")).unwrap();
    let names: Vec<String> = includes.iter().map(|name| format!("{name:?}")).collect();
    let text = lit(&format!("include: [{}]", names.join(", ")));
    for (name, text) in others.iter().copied().chain([("in/scene.ron", &*text)]) {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

#[test]
fn included_files_stay_in_the_folder_unless_allowed() {
    for name in ["../out.ron", "./../out.ron", "../in/../out.ron", "/etc/hostname", "../none.ron"] {
        let folder = folder("confined", &[name], &[("out.ron", "(spp: 3)")]);
        let shown = load_in(&folder, None).unwrap_err();
        assert!(shown.starts_with(&format!("`{name}` is outside of ")), "{shown}");
        assert!(shown.contains("`--root`") && shown.contains("scene.ron:2:11"), "{shown}");
    }
    let allowed = folder("allowed", &["../out.ron"], &[("out.ron", "(spp: 3)")]);
    assert!(load_in(&allowed, Some(allowed.path())).is_ok());
    let inside = folder("inside", &["../in/a.ron"], &[("in/a.ron", "()")]);
    assert!(load_in(&inside, None).is_ok());
}

#[cfg(unix)]
#[test]
fn links_do_not_lead_outside() {
    let folder = folder("link", &["a.ron"], &[("out.ron", "()")]);
    std::os::unix::fs::symlink("../out.ron", folder.path().join("in/a.ron")).unwrap();
    let shown = load_in(&folder, None).unwrap_err();
    assert!(shown.starts_with("`a.ron` is outside of "), "{shown}");
}

#[test]
fn what_is_no_scene_is_not_shown() {
    for text in ["root:secret:0", "{\"key\": \"secret\"}", "<secret>", ""] {
        let folder = folder("secret", &["a.txt"], &[("in/a.txt", text)]);
        let shown = load_in(&folder, None).unwrap_err();
        let expected = "`a.txt` cannot be read: it is no scene file, which would begin with `(`";
        assert!(shown.starts_with(expected) && !shown.contains("secret"), "{shown}");
    }
    // Where it is one, its faults are.
    let folder = folder("fault", &["a.ron"], &[("in/a.ron", "// A room\n(spp: x)")]);
    let shown = load_in(&folder, None).unwrap_err();
    assert!(shown.contains("a.ron:2:7"), "{shown}");
}

/// 8,000 files, each of which includes the next one, took more stack than there is.
#[test]
fn a_long_chain_of_includes_is_refused() {
    let chain = |length: usize| {
        let folder = folder(&format!("chain{length}"), &["0.ron"], &[]);
        for n in 0..length {
            let text = format!("(include: [\"{}.ron\"])", n + 1);
            fs::write(folder.path().join(format!("in/{n}.ron")), text).unwrap();
        }
        fs::write(folder.path().join(format!("in/{length}.ron")), "()").unwrap();
        load_in(&folder, None).map(drop)
    };
    assert_eq!(chain(60), Ok(()));
    let shown = chain(8000).unwrap_err();
    assert!(shown.starts_with("`63.ron` is the 64th file that the one before includes"), "{shown}");
    assert!(shown.contains("62.ron:1:12"), "{shown}");
}

#[test]
fn a_file_that_is_not_there_may_be_another() {
    let folder = folder("near", &["romm.ron"], &[("in/room.ron", "()")]);
    let shown = load_in(&folder, None).unwrap_err();
    assert!(shown.contains("`romm.ron` cannot be read: there is no such file"), "{shown}");
    assert!(shown.contains("did you mean `room.ron`?"), "{shown}");
}

/// 2,000 materials and as many objects whose materials have other names: 6 seconds and
/// 34 MB of text, before only the first were shown.
#[test]
fn many_errors_are_counted_and_the_first_shown() {
    let material = |n: usize| format!("\"wall {n}\": Mirror(reflectance: (1, 1, 1))");
    let materials = (0..2000).map(material).collect::<Vec<_>>().join(",\n");
    let sphere = "shape: Sphere(center: (0, 0, 0), radius: 1)";
    let object = |n: usize| format!("({sphere}, material: \"hall {n}\")");
    let objects = (0..2000).map(object).collect::<Vec<_>>().join(",\n");
    let text = lit(&format!("materials: {{ {materials} }}, objects: [{objects}]"));
    let start = Instant::now();
    let shown = report("many", &text, &[]);
    // A hundredth of it, on a machine that is ten times slower.
    assert!(start.elapsed().as_secs_f32() < 3.0, "{:?}", start.elapsed());
    assert_eq!(shown.matches("no material is named").count(), 20);
    assert!(shown.ends_with("and 1980 more errors") && shown.len() < 20_000, "{}", shown.len());
    assert!(shown.contains("`wall 15` and 1984 more"), "{shown}");
}

#[test]
fn long_names_are_cut() {
    let name = "n".repeat(1_000_000);
    let object = format!("(shape: Mesh(file: \"{name}\"), material: \"{name}\")");
    let text = lit(&format!("objects: [{object}]"));
    let shown = report("long", &text, &[]);
    assert!(shown.len() < 4000, "{}", shown.len());
}
