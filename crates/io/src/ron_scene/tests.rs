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
)"#;

/// The message for a text that cannot be decoded.
fn message(text: &str) -> String {
    let error = decode(text).unwrap_err();
    let source = Arc::new(SourceText { name: "bad.ron".to_string(), text: text.to_string() });
    Report(vec![syntax::problem(&source, &error)]).to_string()
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
  = help: expected one of `Lambert`, `Phong`, `MaxPhong`, `Mirror`, `Sheet`, `Glass`, `Pane`, `Textured`"#;
    assert_eq!(message(&text), expected);
}

#[test]
fn a_wrong_type_is_pointed_at() {
    let text = WHOLE.replace("fov: 32", "fov: \"forty\"");
    let shown = message(&text);
    assert!(shown.starts_with("expected a number\n --> bad.ron:4:61\n"), "{shown}");
    assert!(shown.contains("^ here"), "{shown}");
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
