use super::*;
use crate::report::{Report, SourceText};
use std::sync::Arc;

const WHOLE: &str = r#"
(
    include: ["room.ron"],
    camera: (position: (0, 1, 4.4), target: (0, 1, 0), fov: 32, resolution: (256, 128)),
    exposure: 0.5,
    materials: {
        "b": Lambert(reflectance: (0.1, 0.2, 0.3)),
        "a": Phong(diffuse: (0, 0, 0), specular: (1, 1, 1), exponent: 1e3),
        "b": Mirror(reflectance: (1, 1, 1)),
    },
    objects: [
        (shape: Sphere(center: (0, 0, 0), radius: 1, facing: Inward), material: "a", sides: Front),
        (shape: Mesh(file: "x.3ds"), emission: (1, 2, 3)),
    ],
    lights: [Point(position: (0, 1, 0), intensity: (1, 1, 1))],
    sky: Picture(file: "sky.hdr", turn: 90),
)"#;

/// The message for a text that cannot be decoded.
fn message(text: &str) -> String {
    let error = decode(text).unwrap_err();
    let source = Arc::new(SourceText { name: "bad.ron".to_string(), text: text.to_string() });
    Report::from(syntax::problem(&source, &error)).to_string()
}

#[test]
fn a_file_is_read_with_its_defaults() {
    let document = decode(WHOLE).unwrap();
    let camera = document.camera.unwrap();
    assert_eq!((camera.up, camera.resolution), ([0.0, 1.0, 0.0], (256, 128)));
    assert_eq!((document.exposure, document.spp), (Some(0.5), None));
    let names: Vec<&str> = document.materials.0.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["b", "a", "b"]);
    let Material::Mirror(mirror) = &document.materials.0[2].1 else { panic!("not a mirror") };
    assert_eq!(mirror.diffuse, [0.0; 3]);
    assert_eq!(document.objects[0].sides, Some(Sides::Front));
    assert_eq!(document.objects[0].material.as_deref(), Some("a"));
    let Shape::Mesh(mesh) = &document.objects[1].shape else { panic!("not a mesh") };
    assert_eq!((mesh.scale, mesh.rotate), (1.0, [0.0; 3]));
    assert_eq!(document.objects[1].emission, Some([1.0, 2.0, 3.0]));
    assert_eq!(document.lights.len(), 1);
    let Some(Sky::Picture(sky)) = &document.sky else { panic!("not a picture") };
    assert_eq!((sky.file.as_str(), sky.scale, sky.turn), ("sky.hdr", 1.0, 90.0));
    let constant =
        WHOLE.replace("Picture(file: \"sky.hdr\", turn: 90)", "Constant(radiance: (1, 2, 3))");
    let Some(Sky::Constant(sky)) = decode(&constant).unwrap().sky else { panic!("not constant") };
    assert_eq!(sky.radiance, [1.0, 2.0, 3.0]);
}

#[test]
fn a_misspelt_field_gets_a_suggestion() {
    let text = WHOLE.replace("exponent:", "exponnt:");
    let expected = r#"unknown field `exponnt` in `Phong`
 --> bad.ron:8:61
  |
8 |         "a": Phong(diffuse: (0, 0, 0), specular: (1, 1, 1), exponnt: 1e3),
  |                                                             ^^^^^^^ did you mean `exponent`?
  |
  = help: expected one of `diffuse`, `specular`, `exponent`"#;
    assert_eq!(message(&text), expected);
}

#[test]
fn a_misspelt_variant_gets_a_suggestion() {
    let text = WHOLE.replace("Mirror", "Mirorr");
    let expected = r#"unknown material `Mirorr`
 --> bad.ron:9:14
  |
9 |         "b": Mirorr(reflectance: (1, 1, 1)),
  |              ^^^^^^ did you mean `Mirror`?
  |
  = help: expected one of `Lambert`, `Phong`, `MaxPhong`, `Mirror`, `Sheet`, `Glass`, `Pane`, `Gauze`, `Textured`"#;
    assert_eq!(message(&text), expected);
}

#[test]
fn a_wrong_type_is_pointed_at() {
    let text = WHOLE.replace("fov: 32", "fov: \"forty\"");
    let shown = message(&text);
    assert!(shown.starts_with("`fov` wants a number, as `1.5`\n --> bad.ron:4:61\n"), "{shown}");
    assert!(shown.contains("^^^^^^^ this is a text"), "{shown}");
}

#[test]
fn missing_and_doubled_fields_are_named() {
    let missing = message(&WHOLE.replace("fov: 32, ", ""));
    assert!(missing.starts_with("missing field `fov` in `Camera`\n --> bad.ron:4:"), "{missing}");
    let doubled = message(&WHOLE.replace("fov: 32", "fov: 32, fov: 33"));
    assert!(doubled.starts_with("field `fov` is given twice"), "{doubled}");
    assert!(doubled.contains("bad.ron:4:65"), "{doubled}");
}

#[test]
fn texts_cut_anywhere_have_a_message() {
    for end in (0..WHOLE.len() - 1).step_by(7) {
        let shown = message(&WHOLE[..end]);
        assert!(shown.contains(" --> bad.ron"), "{end}: {shown}");
    }
}

/// What is said of a text that has this instead of that: the title, the place, what is
/// underlined with words beside it, and the help.
#[track_caller]
fn said(instead: &str, of: &str, title: &str, place: &str, label: &str, help: &str) {
    assert!(WHOLE.contains(of), "{of}");
    let shown = message(&WHOLE.replace(of, instead));
    let (first, rest) = shown.split_once('\n').unwrap();
    let place = format!("--> bad.ron:{place}\n");
    assert!(first == title && rest.trim_start().starts_with(&place), "{shown}");
    assert!(shown.lines().any(|line| line.trim_start_matches([' ', '|']) == label), "{shown}");
    let found = shown.split_once("= help: ").map_or("", |(_, help)| help);
    assert_eq!(found, help, "{shown}");
}

const FIELD: &str = "a field is wanted here, as `name: value`";
const THREE: &str = "`position` wants three numbers, as `(0, 1, 4)`";

#[test]
fn values_of_another_kind_are_told_in_the_words_of_the_manual() {
    said("(0, 1)", "(0, 1, 4.4)", THREE, "4:24", "^^^^^^ these are 2", "");
    said("(0, 1, 2, 3)", "(0, 1, 4.4)", THREE, "4:24", "^^^^^^^^^^^^ these are 4", "");
    let list = "[0, 1, 4.4]";
    said(list, "(0, 1, 4.4)", THREE, "4:24", "^^^^^^^^^^^ this is a list", "write `(0, 1, 4.4)`");
    said("(0, nan, 4.4)", "(0, 1, 4.4)", THREE, "4:28", "^^^ this is a word", "");
    let size = "`resolution` wants width and height in pixels, as `(400, 300)`";
    said("(-256, 128)", "(256, 128)", size, "4:78", "^^^^ it is negative", "");
    said("(256.5, 128)", "(256, 128)", size, "4:78", "^^^^^ this is no whole number", "");
    said(
        "spp: 6.5",
        "exposure: 0.5",
        "`spp` wants a whole number above 0, as `64`",
        "5:10",
        "^^^ this is no whole number",
        "",
    );
    let colour = "`reflectance` wants red, green and blue, as `(0.5, 0.5, 0.5)`";
    let hex = "colours are linear: this one is `(0.578, 0.456, 0.352)`";
    said("\"#c8b4a0\"", "(0.1, 0.2, 0.3)", colour, "7:35", "^^^^^^^^^ this is a text", hex);
    said("0.5", "(0.1, 0.2, 0.3)", colour, "7:35", "^^^ this is one number", "");
    let name = "`material` wants the name of a material in quotes, as `\"white\"`";
    said("material: a", "material: \"a\"", name, "12:81", "^ this is a word", "write `\"a\"`");
    let inline = "give it a name in `materials: { \"name\": … }`, and write the name here";
    said(
        "material: Glass(index: 2)",
        "material: \"a\"",
        name,
        "12:81",
        "^^^^^^^^^^^^^^^ this is a word",
        inline,
    );
    let size = "`scale` wants one number, as `0.5`: a mesh keeps its proportions";
    let text = "\"x.3ds\", scale: (1, 1, 1)";
    said(text, "\"x.3ds\"", size, "13:44", "^^^^^^^^^ these are several values", "");
    let material = "`a` wants a material, as `Lambert(reflectance: (0.5, 0.5, 0.5))`";
    let phong = "Phong(diffuse: (0, 0, 0), specular: (1, 1, 1), exponent: 1e3)";
    said("0.5", phong, material, "8:14", "^^^ this is one number", "");
    let spp = "`spp` wants a whole number above 0, as `64`";
    said("spp: -1", "exposure: 0.5", spp, "5:10", "^^ it is negative", "");
    let picture = "`scale` wants two numbers, as `(4, 4)`";
    let textured = "Textured(base: Glass(index: 2), diffuse: (file: \"a\", scale: 6))";
    said(textured, "Mirror(reflectance: (1, 1, 1))", picture, "9:74", "^ this is one number", "");
    let files = "`include` wants a list of files, as `[\"room.ron\"]`";
    said("\"room.ron\"", "[\"room.ron\"]", files, "3:14", "^^^^^^^^^^ this is a text", "");
}

#[test]
fn signs_out_of_place_are_told() {
    said("fov: 32 res", "fov: 32, res", "`,` is missing", "4:61", "^^ after this", "");
    let equals = "`=` stands where `:` is wanted";
    said("fov = 32", "fov: 32", equals, "4:60", "^ here", "write `fov: …`");
    let point = "fractions have a point: `32.5`";
    said("fov: 32,5,", "fov: 32,", FIELD, "4:64", "^ this is none", point);
    let comment = "comments begin with `//`";
    said("# half\n    exposure", "exposure", "`#` begins no comment", "5:5", "^ here", comment);
    let line = "open is the `[` of line 11";
    said("Front)),", "Front),", "`)` closes no bracket", "12:99", "^ one too many", line);
    let missing = "is a bracket missing? The `(` of line 12 is open";
    said("Front,", "Front),", FIELD, "13:9", "^ this is none", missing);
    let quotes = "names are in double quotes, as `\"white\"`";
    said("fov: 32, 'x'", "fov: 32", "`'` is no quotation mark", "4:65", "^ here", quotes);
    said("fov:", "fov: 32", "`fov` wants a number, as `1.5`", "4:60", "^ here", "");
    let names = "`materials` wants names with materials, as `{ \"white\": Lambert(…) }`";
    said("a: Phong", "\"a\": Phong", names, "8:9", "^ this is a word", "write `\"a\"`");
    said("3\u{0}2", "32", "U+0000 is no character of a scene", "4:62", "^ here", "");
}

#[test]
fn files_that_are_no_scene_are_told() {
    let first = |text: &str| message(text).lines().next().unwrap_or_default().to_string();
    assert_eq!(first("// nothing"), "the file has no scene");
    assert_eq!(first(""), "the file has no scene");
    for text in ["{\"camera\": 1}", "<scene/>", "camera: ()"] {
        assert_eq!(first(text), "a scene begins with `(`", "{text}");
    }
    assert!(message("{\"a\": 1}").contains("this looks like JSON; scenes are in RON"));
    assert!(message("<scene/>").contains("this looks like XML; scenes are in RON"));
    let unclosed = message("(\n  objects: [\n");
    assert!(unclosed.starts_with("`[` is not closed\n --> bad.ron:2:12\n"), "{unclosed}");
    let more = message("()\n)");
    assert!(more.starts_with("the scene is closed before the end of the file"), "{more}");
    let text = message("(include: [\"a]\n)");
    assert!(text.starts_with("a text in quotes has no end\n --> bad.ron:1:12\n"), "{text}");
}

/// Words of the parser, which say nothing to whoever writes a scene.
#[test]
fn the_parsers_words_are_not_shown() {
    const WORDS: [&str; 8] =
        ["struct ", "identifier", "opening", "array", "integer", "float", "raw ", "enum "];
    let signs = [
        "", "(", ")", "[", "]", "{", "}", ":", ",", "x", "5", "-5", "5.5", "\"a\"", "#", "\\",
        "NaN",
    ];
    for at in (0..WHOLE.len()).step_by(3) {
        for sign in signs {
            let text = format!("{}{sign}{}", &WHOLE[..at], &WHOLE[at + 1..]);
            if decode(&text).is_ok() {
                continue;
            }
            let shown = message(&text);
            let title = shown.lines().next().unwrap_or_default();
            assert!(!WORDS.iter().any(|word| title.contains(word)), "{at} {sign}: {shown}");
        }
    }
}
