//! Files that name files.

use super::*;

const BALL: &str = "v centre =\np 0 0 0\nsph centre 1\n";

fn message(result: Result<Document, Error>, folder: &Folder) -> String {
    let message = result.unwrap_err().to_string();
    let folder = folder.0.canonicalize().unwrap();
    message.replace(&format!("{}/", folder.display()), "")
}

#[test]
fn names_are_relative_to_the_file_that_includes() {
    let folder = Folder::new(&[
        ("a.mgf", "i parts/b.mgf\nm inner\nsph centre 2\n"),
        ("parts/b.mgf", "i ./c.mgf\ni ../d.mgf\n"),
        ("parts/c.mgf", BALL),
        // Contexts are one for all files and stay as they are.
        ("d.mgf", "m inner =\nrd .5\n"),
    ]);
    let document = folder.decode("a.mgf").unwrap();
    let amounts: Vec<f32> =
        document.surfaces.iter().map(|s| document.materials[s.material].rd.amount).collect();
    assert_eq!(amounts, [0.0, 0.5]);
    assert_eq!(document.counts.entities_after_include_and_array["i"], 3);
}

#[test]
fn names_are_tried_in_lower_and_upper_case() {
    let folder = Folder::new(&[
        ("a.mgf", "i BALL.MGF\ni Cube.mgf\n"),
        ("ball.mgf", BALL),
        ("CUBE.MGF", BALL),
    ]);
    assert_eq!(folder.decode("a.mgf").unwrap().surfaces.len(), 2);
}

#[test]
fn arguments_transform_and_repeat_the_file() {
    let folder =
        Folder::new(&[("a.mgf", "xf -s 2\ni b.mgf -t 1 0 0 -a 3 -t 0 1 0\nxf\n"), ("b.mgf", BALL)]);
    let document = folder.decode("a.mgf").unwrap();
    let centres: Vec<[f64; 3]> = document
        .surfaces
        .iter()
        .map(|surface| {
            let Shape::Sphere { centre, radius: 2.0, .. } = surface.shape else {
                panic!("{surface:?}")
            };
            centre.to_array()
        })
        .collect();
    assert_eq!(centres, [[2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [2.0, 4.0, 0.0]]);
    assert_eq!(document.counts.entities_after_include_and_array["xf"], 2 + 1 + 3);
}

#[test]
fn files_given_together_share_their_contexts() {
    let folder = Folder::new(&[("a.mgf", "v centre =\np 0 0 5\n"), ("b.mgf", "sph centre 1\n")]);
    let files = ["a.mgf", "b.mgf"].map(|name| folder.0.join(name));
    assert_eq!(decode(&files, &Options::default()).unwrap().surfaces.len(), 1);
    assert!(decode(&files[1..], &Options::default()).is_err());
    assert_eq!(decode(&[], &Options::default()).unwrap(), Document::default());
}

#[test]
fn circles_of_includes_are_refused() {
    let folder = Folder::new(&[
        ("self.mgf", "\n i ./self.mgf\n"),
        ("a.mgf", "i sub/b.mgf\n"),
        ("sub/b.mgf", "i ../a.mgf -a 5 -mx\n"),
    ]);
    let error = folder.decode("self.mgf").unwrap_err();
    let Error::Entity { place, entity, cause: Cause::Circle(name) } = error else { panic!() };
    assert_eq!((place.line, entity, name.as_str()), (2, "i", "./self.mgf"));
    let error = folder.decode("a.mgf").unwrap_err();
    assert!(matches!(error, Error::Entity { cause: Cause::Circle(_), .. }), "{error}");
}

#[test]
fn includes_stay_below_the_root() {
    let folder = Folder::new(&[
        ("secret.mgf", BALL),
        ("scene/a.mgf", "i ../secret.mgf\n"),
        ("scene/b.mgf", "i ../nothing.mgf\n"),
        ("scene/c.mgf", "i /etc/passwd\n"),
        ("scene/d.mgf", "i x/../../scene/../secret.mgf\n"),
    ]);
    for name in ["scene/a.mgf", "scene/b.mgf", "scene/d.mgf"] {
        let error = folder.decode(name).unwrap_err();
        assert!(matches!(error, Error::Entity { cause: Cause::Outside { .. }, .. }), "{error}");
    }
    let error = folder.decode("scene/c.mgf").unwrap_err();
    assert!(matches!(error, Error::Entity { cause: Cause::Absolute(_), .. }), "{error}");
    let options = Options { root: Some(folder.0.clone()), ..Options::default() };
    let document = decode(&[folder.0.join("scene/a.mgf")], &options).unwrap();
    assert_eq!(document.surfaces.len(), 1);
}

#[cfg(unix)]
#[test]
fn links_do_not_lead_out_of_the_root() {
    let folder = Folder::new(&[("secret.mgf", BALL), ("scene/a.mgf", "i link.mgf\n")]);
    let link = folder.0.join("scene/link.mgf");
    std::os::unix::fs::symlink(folder.0.join("secret.mgf"), link).unwrap();
    let error = folder.decode("scene/a.mgf").unwrap_err();
    assert!(matches!(error, Error::Entity { cause: Cause::Outside { .. }, .. }), "{error}");
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let folder = Folder::new(&[("a.mgf", "\n\ni none.mgf\n"), ("b.mgf", "i sub\n"), ("sub/x", "")]);
    let text = message(folder.decode("a.mgf"), &folder);
    assert!(text.contains("a.mgf:3: i: `none.mgf` cannot be read: "), "{text}");
    let text = message(folder.decode("b.mgf"), &folder);
    assert!(text.contains("b.mgf:1: i: `sub` is not a file"), "{text}");
    let error = folder.decode("missing.mgf").unwrap_err();
    assert!(matches!(error, Error::File { fault: FileFault::Read(_), .. }), "{error}");
    let error = decode(std::slice::from_ref(&folder.0), &Options::default()).unwrap_err();
    assert!(matches!(error, Error::File { fault: FileFault::NotAFile, .. }), "{error}");
}

#[test]
fn errors_inside_of_an_include_name_that_file() {
    let folder = Folder::new(&[("a.mgf", "i b.mgf\n"), ("b.mgf", "# one\nsph x 1\n")]);
    let text = message(folder.decode("a.mgf"), &folder);
    assert!(text.ends_with("b.mgf:2: sph: no vertex is named `x`"), "{text}");
}

#[test]
fn a_file_closes_what_it_opens_and_nothing_else() {
    let folder = Folder::new(&[
        ("a.mgf", "xf -t 1 0 0\no x\ni close.mgf\n"),
        ("close.mgf", "xf\n"),
        ("b.mgf", "o x\ni end.mgf\n"),
        ("end.mgf", "o\n"),
        ("c.mgf", "i open.mgf\nsph centre 1\n"),
        ("open.mgf", "v centre =\np 0 0 0\no x\nxf -t 1 0 0\n"),
    ]);
    for name in ["a.mgf", "b.mgf"] {
        let error = folder.decode(name).unwrap_err();
        assert!(matches!(error, Error::Entity { cause: Cause::Unmatched, .. }), "{error}");
    }
    let document = folder.decode("c.mgf").unwrap();
    let Shape::Sphere { centre, .. } = document.surfaces[0].shape else { panic!() };
    assert_eq!(centre.x, 0.0);
    let kinds: Vec<WarningKind> = document.warnings.iter().map(|warning| warning.kind).collect();
    assert_eq!(kinds, [WarningKind::TransformLeftOpen, WarningKind::ObjectLeftOpen]);
}

#[test]
fn depth_is_bounded() {
    let folder = Folder::new(&[]);
    for level in 0..10 {
        let text = format!("i {}.mgf\ni {}.mgf\n", level + 1, level + 1);
        folder.write(&format!("{level}.mgf"), text.as_bytes());
    }
    folder.write("10.mgf", BALL.as_bytes());
    assert_eq!(folder.decode("0.mgf").unwrap().surfaces.len(), 1024);
    let options = Options { max_depth: 5, ..Options::default() };
    let error = decode(&[folder.0.join("0.mgf")], &options).unwrap_err();
    assert!(error.to_string().contains("5.mgf:1: i: more than 5 files"), "{error}");
    let options = Options { max_work: 100_000, ..Options::default() };
    let error = decode(&[folder.0.join("0.mgf")], &options).unwrap_err();
    assert!(error.to_string().contains("bytes of text"), "{error}");
}

#[test]
fn looking_for_files_is_work() {
    let names =
        (1..100).fold(String::new(), |text, i| text + &format!("i {}b.mgf\n", "./".repeat(i)));
    let folder = Folder::new(&[("a.mgf", &names), ("b.mgf", "")]);
    assert!(folder.decode("a.mgf").is_ok());
    let options = Options { max_work: 500_000, ..Options::default() };
    let error = decode(&[folder.0.join("a.mgf")], &options).unwrap_err();
    assert!(error.to_string().contains("`--limit work=1000000` allows more"), "{error}");
}

#[test]
fn carriage_returns_end_lines_and_continue_them() {
    let text = "v e =\n\tp 1 \\\n 2 3\n# note \\\n sph e 1\nsph e 4\n";
    for end in ["\n", "\r", "\r\n"] {
        let document = read(&text.replace('\n', end)).unwrap();
        let Shape::Sphere { centre, radius, .. } = document.surfaces[0].shape else { panic!() };
        assert_eq!((centre.to_array(), radius), ([1.0, 2.0, 3.0], 4.0), "{end:?}");
        assert_eq!(document.surfaces.len(), 1);
    }
}
