use super::*;
use std::fs;

/// Loads a scene text as a file in a folder of its own, beside other files.
fn load_text(test: &str, text: &str, others: &[(&str, &[u8])]) -> Result<Loaded, Error> {
    load_text_with(test, text, others, LoadOptions::default())
}

fn load_text_with(
    test: &str,
    text: &str,
    others: &[(&str, &[u8])],
    options: LoadOptions<'_>,
) -> Result<Loaded, Error> {
    let folder = std::env::temp_dir().join(format!("traylib-{}-{test}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("scene.ron"), text).unwrap();
    for (name, bytes) in others {
        fs::write(folder.join(name), bytes).unwrap();
    }
    let loaded = load_scene_with(&folder.join("scene.ron").to_string_lossy(), options);
    fs::remove_dir_all(&folder).unwrap();
    loaded
}

/// The report for a faulty text, without the folder's name.
fn report(test: &str, text: &str, others: &[(&str, &[u8])]) -> String {
    let error = load_text(test, text, others).unwrap_err();
    assert!(matches!(error, Error::Scene(_)), "{error:?}");
    let folder = std::env::temp_dir().join(format!("traylib-{}-{test}/", std::process::id()));
    error.to_string().replace(&*folder.to_string_lossy(), "")
}

const CAMERA: &str =
    "camera: (position: (0, 0, 4), target: (0, 0, 0), fov: 40, resolution: (40, 30)),";
const CUBE: &[u8] = include_bytes!("../../../../scenes/models/cube.3ds");

fn lit(inside: &str) -> String {
    format!("({CAMERA} lights: [Point(position: (0, 9, 0), intensity: (1, 1, 1))],\n{inside})")
}

#[test]
fn every_built_in_scene_loads() {
    for name in builtin_names() {
        let loaded = load_scene(name).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(loaded.name, *name);
        assert!(loaded.scene.primitive_count() > 0 && !loaded.scene.lights().is_empty(), "{name}");
    }
}

#[test]
fn settings_come_from_the_file_and_resolution_from_the_caller() {
    let options = LoadOptions { resolution: Some((12, 34)), ..LoadOptions::default() };
    let loaded = load_scene_with("furnace", options).unwrap();
    let camera = loaded.scene.camera();
    assert_eq!((camera.width(), camera.height()), (12, 34));
    let said = load_text("settings", &lit("spp: 3, exposure: 0.25"), &[]);
    assert_eq!(said.unwrap().settings, SceneSettings { spp: 3, exposure: 0.25 });
    let plain = load_text("defaults", &lit(""), &[]);
    // A light and nothing to see is a scene, if a dull one.
    assert_eq!(plain.unwrap().settings, SceneSettings { spp: 64, exposure: 1.0 });
}

#[test]
fn an_unknown_name_is_an_error_with_a_suggestion() {
    let message = load_scene("funrace").unwrap_err().to_string();
    assert!(message.contains("did you mean `furnace`?") && message.contains("`cornell`"));
}

#[test]
fn a_file_that_is_not_text_is_refused() {
    let path = std::env::temp_dir().join(format!("traylib-{}-bytes.ron", std::process::id()));
    fs::write(&path, [0x28, 0xff]).unwrap();
    let error = load_scene(&path.to_string_lossy()).unwrap_err();
    fs::remove_file(&path).unwrap();
    let expected =
        "cannot be read: it is not UTF-8 text, the first time in line 1: save it as UTF-8";
    assert!(error.to_string().ends_with(expected), "{error}");
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_text() {
    let text = format!("\u{feff}{}", lit(""));
    assert!(load_text("mark", &text, &[]).is_ok());
    let shown = report("marked", &text.replace("fov: 40", "fov: x"), &[]);
    let plain = report("plain", &lit("").replace("fov: 40", "fov: x"), &[]);
    assert_eq!(shown, plain);
    let path = std::env::temp_dir().join(format!("traylib-{}-utf16.ron", std::process::id()));
    fs::write(&path, [0xff, 0xfe, 0x28, 0]).unwrap();
    let error = load_scene(&path.to_string_lossy()).unwrap_err();
    fs::remove_file(&path).unwrap();
    assert!(error.to_string().ends_with("it is UTF-16 text: save it as UTF-8"), "{error}");
}

#[test]
fn all_errors_are_reported_together_with_their_places() {
    let text = r#"(
    spp: 0,
    materials: {
        "white": Lambert(reflectance: (0.7, 0.7, 1.7)),
        "gloss": Phong(diffuse: (0.7, 0.7, 0.7), specular: (0.5, 0.5, 0.5), exponent: 10),
        "grey": Mirror(reflectance: (NaN, 0, 0)),
        "grey": Lambert(reflectance: (0, 0, 0)),
    },
    objects: [
        (shape: Sphere(center: (0, 0, 0), radius: 0), material: "white"),
        (shape: Sphere(center: (0, 0, 0), radius: 1), material: "whit"),
        (shape: Quad(corner: (0, 0, 0), edge_u: (1, 0, 0), edge_v: (2, 0, 0)), material: "white"),
        (shape: Sphere(center: (0, 0, 0), radius: 1), emission: (1, -1, 1)),
        (shape: Mesh(file: "none.3ds")),
        (shape: Mesh(file: "scene.ron", scale: -1)),
    ],
)"#;
    let shown = report("together", text, &[]);
    for part in [
        "the scene has no camera\n--> scene.ron\n",
        "at least 1 sample per pixel is needed\n --> scene.ron:2:10",
        "reflectance [0.7, 0.7, 1.7] must lie between 0 and 1 in each band\n --> scene.ron:4:39",
        "diffuse + specular reflects up to 1.2, more than arrives; scale them to a sum of 1\n \
         --> scene.ron:5:18",
        "reflectance [NaN, 0.0, 0.0] must lie between 0 and 1 in each band\n --> scene.ron:6:37",
        "two materials are named `grey`\n --> scene.ron:7:9",
        "the radius is not positive\n  --> scene.ron:10:51",
        "no material is named `whit`\n  --> scene.ron:11:65",
        "^^^^^^ did you mean `white`?",
        "the materials are `white`, `gloss`, `grey`",
        "the shape has no area, or one beyond all measure\n  --> scene.ron:12:17",
        "the emission must be finite and not negative in each band\n  --> scene.ron:13:65",
        "the object has no material\n  --> scene.ron:13:9",
        "none.3ds cannot be used: there is no such file",
        "--> scene.ron:14:28",
        "the scale must be positive and finite\n  --> scene.ron:15:48",
        "scene.ron cannot be used: it is no 3DS file",
    ] {
        assert!(shown.contains(part), "missing: {part}\nin:\n{shown}");
    }
    assert_eq!(shown.matches("-->").count(), 14, "{shown}");
}

#[test]
fn a_scene_without_light_is_refused() {
    let shown = report("dark", &format!("({CAMERA})"), &[]);
    assert!(shown.starts_with("nothing in the scene emits light\n--> scene.ron"), "{shown}");
}

#[test]
fn a_camera_that_sees_nothing_is_refused() {
    for (from, to, words, place) in [
        ("fov: 40", "fov: 180", "field of view", ":1:56"),
        ("target: (0, 0, 0)", "target: (0, 0, 4)", "same point", ":1:40"),
        ("target: (0, 0, 0)", "target: (0, NaN, 4)", "must be finite", ":1:40"),
        ("(40, 30)", "(0, 30)", "no pixels", ":1:72"),
        ("fov: 40", "fov: 40, up: (0, 0, 9)", "up points along the view", ":1:64"),
        // Where it is a default, the camera is shown.
        ("position: (0, 0, 4)", "position: (0, 4, 0)", "up points along the view", ":1:10"),
        ("(40, 30)", "(100000, 100000)", "more than 2^28 pixels", ":1:72"),
    ] {
        let shown = report("camera", &lit("").replace(from, to), &[]);
        assert!(shown.contains(words) && shown.contains(place), "{to}: {shown}");
    }
}

#[test]
fn exposure_and_point_lights_are_checked() {
    let shown = report("exposure", &lit("exposure: inf"), &[]);
    assert!(shown.starts_with("the exposure must be positive"), "{shown}");
    let shown = report("lights", &lit("").replace("(1, 1, 1)", "(1, NaN, 1)"), &[]);
    assert!(shown.starts_with("the intensity must be finite and not negative"), "{shown}");
    let shown = report("position", &lit("").replace("(0, 9, 0)", "(0, 1e40, 0)"), &[]);
    assert!(shown.starts_with("the position must be finite"), "{shown}");
}

/// A Radiance picture of two pixels: (1, 2, 4) on the left, black on the right.
const HALF_SKY: &[u8] =
    b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x20\x40\x80\x83\0\0\0\0";

#[test]
fn a_sky_is_a_light_from_everywhere() {
    use traylib_math::{Rgb, Vec3};
    let sky = |sky: &str| {
        let loaded = load_text("sky", &format!("({CAMERA} sky: {sky})"), &[("a.hdr", HALF_SKY)]);
        let scene = loaded.unwrap().scene;
        let sky = scene.sky().unwrap();
        [-Vec3::X, Vec3::X].map(|toward| sky.radiance(toward))
    };
    assert_eq!(sky("Constant(radiance: (1, 2, 3))"), [Rgb::new(1.0, 2.0, 3.0); 2]);
    let bright = Rgb::new(1.0, 2.0, 4.0);
    assert_eq!(sky("Picture(file: \"a.hdr\")"), [bright, Rgb::BLACK]);
    let turned = "Picture(file: \"a.hdr\", scale: 0.5, turn: 180)";
    assert_eq!(sky(turned), [Rgb::BLACK, bright * 0.5]);
    // That of an included file is its own matter.
    let room: &[u8] = b"(sky: Constant(radiance: (1, 1, 1)))";
    let loaded =
        load_text("skies", &lit("include: [\"room.ron\"]"), &[("room.ron", room)]).unwrap();
    assert!(loaded.scene.sky().is_none());
}

#[test]
fn a_sky_is_checked() {
    for (sky, words) in [
        ("Constant(radiance: (1, -1, 1))", "the radiance must be finite and not negative"),
        ("Constant(radiance: (0, 0, 0))", "nothing in the scene emits light"),
        ("Picture(file: \"a.hdr\", scale: -1)", "the scale must be finite and not negative"),
        ("Picture(file: \"a.hdr\", turn: inf)", "the turn must be finite"),
        ("Picture(file: \"none.hdr\")", "none.hdr"),
        ("Picture(file: \"a.hdr\", scale: (1, 2))", "`scale` wants a number"),
    ] {
        let text = format!("({CAMERA} sky: {sky})");
        let shown = report("wrong-sky", &text, &[("a.hdr", HALF_SKY)]);
        assert!(shown.contains(words), "{sky}: {shown}");
    }
}

#[test]
fn included_files_bring_materials_objects_and_lights_once() {
    let room = br#"(
        materials: { "white": Lambert(reflectance: (0.5, 0.5, 0.5)) },
        objects: [(shape: Box(min: (0, 0, 0), max: (1, 1, 1)), material: "white")],
        lights: [Point(position: (0, 9, 0), intensity: (1, 1, 1))],
        spp: 1,
    )"#;
    let other = br#"(include: ["room.ron"])"#;
    let text = format!(
        r#"({CAMERA} include: ["room.ron", "other.ron"],
        objects: [(shape: Disk(center: (0, 0, 0), normal: (0, 9, 0), radius: 1), material: "white")])"#
    );
    let others: [(&str, &[u8]); 2] = [("room.ron", room), ("other.ron", other)];
    let loaded = load_text("include", &text, &others).unwrap();
    assert_eq!((loaded.scene.primitive_count(), loaded.scene.lights().len()), (7, 1));
    assert_eq!(loaded.settings.spp, 64);
}

#[test]
fn faults_of_included_files_are_shown_where_they_are() {
    let other: &[u8] = b"(\n  include: [\"scene.ron\"],\n)";
    let text = lit(r#"include: ["other.ron", "none.ron"]"#);
    let shown = report("cycle", &text, &[("other.ron", other)]);
    assert!(shown.starts_with("`scene.ron` includes this file"), "{shown}");
    assert!(shown.contains("--> other.ron:2:13"), "{shown}");
    assert!(shown.contains("`none.ron` cannot be read"), "{shown}");
    assert!(shown.contains("--> scene.ron:2:24"), "{shown}");
    let itself = report("self", &lit(r#"include: ["./scene.ron"]"#), &[]);
    assert!(itself.contains("includes this file"), "{itself}");
    let broken = report("broken", &lit(r#"include: ["other.ron"]"#), &[("other.ron", b"(spp: x)")]);
    assert!(broken.contains("--> other.ron:1:7"), "{broken}");
}

#[test]
fn meshes_bring_their_materials_and_warnings() {
    let text = lit(r#"
        materials: { "white": Lambert(reflectance: (0.5, 0.5, 0.5)) },
        objects: [
            (shape: Mesh(file: "cube.3ds", scale: 0.5, translate: (0, 0, -2))),
            (shape: Mesh(file: "cube.3ds"), material: "white", emission: (1, 1, 1)),
        ]"#);
    let loaded = load_text("mesh", &text, &[("cube.3ds", CUBE)]).unwrap();
    assert_eq!(loaded.scene.primitive_count(), 24);
    // The point light, and a light for every face of the second cube.
    assert_eq!(loaded.scene.lights().len(), 13);
    assert_eq!(loaded.warnings, []);
    let hangar = load_scene("hangar").unwrap();
    let warnings: Vec<String> = hangar.warnings.iter().map(ToString::to_string).collect();
    // Its keyframer moves nothing.
    let expected = ["built-in models/enemy01.3ds: picture `ENEMY01D.BMP` not found, shown without"];
    assert_eq!(warnings, expected);
}

mod includes;
mod meshes;
mod models;
mod surfaces;

#[test]
fn the_example_in_the_manual_loads() {
    let manual = include_str!("../../../../docs/scene-format.md");
    let text = manual.split("```ron\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let loaded = load_text("manual", text, &[]).unwrap();
    assert_eq!((loaded.scene.primitive_count(), loaded.scene.lights().len()), (3, 1));
}

#[test]
fn every_snippet_in_the_manual_is_understood() {
    let manual = include_str!("../../../../docs/scene-format.md");
    for snippet in manual.split("```ron\n").skip(2) {
        let text = snippet.split("```").next().unwrap();
        let whole = if text.contains("objects") || !text.contains("shape") {
            format!("({text})")
        } else {
            format!("(objects: [{text}])")
        };
        crate::ron_scene::decode(&whole).unwrap_or_else(|error| panic!("{error}\n{whole}"));
    }
}
