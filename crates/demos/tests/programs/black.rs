//! Pictures that are black say why.

use crate::common::{Folder, programs};

/// A scene of these objects, seen from z = 4.
fn scene(target: &str, objects: &str, lights: &str) -> String {
    format!(
        "(camera: (position: (0, 0, 4), target: {target}, fov: 40, resolution: (16, 12)),
          materials: {{ \"grey\": Lambert(reflectance: (0.5, 0.5, 0.5)),
                       \"black\": Lambert(reflectance: (0, 0, 0)) }},
          objects: [{objects}], lights: [{lights}])"
    )
}

const BALL: &str = "(shape: Sphere(center: (0, 0, 0), radius: 1), material: \"grey\"),";
const DARK_BALL: &str = "(shape: Sphere(center: (0, 0, 0), radius: 1), material: \"black\"),";
const POINT: &str = "Point(position: (0, 3, 3), intensity: (10, 10, 10))";
const LAMP: &str = "(shape: Quad(corner: (-1, 5, -1), edge_u: (2, 0, 0), edge_v: (0, 0, 2)),
    material: \"black\", emission: (9, 9, 9)),";
const SHUT: &str = "(shape: Sphere(center: (0, 3, 3), radius: 0.5), material: \"grey\"),";
const BACKDROP: &str = "(shape: Quad(corner: (-9, -9, -2), edge_u: (18, 0, 0),
    edge_v: (0, 18, 0)), material: \"grey\", sides: Front),";
/// Its back is turned to the camera.
const TURNED: &str = "(shape: Quad(corner: (-9, -9, -2), edge_u: (0, 18, 0),
    edge_v: (18, 0, 0)), material: \"grey\", sides: Front),";

/// Returns the reason that a program gives for a black picture.
fn said(program: &str, text: &str, arguments: &str) -> Option<String> {
    let folder = Folder::new();
    folder.write("a.ron", text);
    let run = folder.run(program, &format!("a.ron --spp 4 {arguments}"));
    assert_eq!(run.status, Some(0), "{program}: {}", run.err);
    let mut found = run
        .err
        .lines()
        .filter_map(|line| line.strip_prefix("warning: the picture is black: ").map(str::to_owned));
    let first = found.next();
    assert_eq!(found.next(), None, "{program}: {}", run.err);
    first
}

#[test]
fn the_reason_is_told_by_every_program() {
    let middle = "(0, 0, 0)";
    let past = scene("(0, 0, 9)", BALL, POINT);
    let behind = scene(middle, TURNED, POINT);
    let dark = scene(middle, &DARK_BALL.replace("radius: 1", "radius: 3"), POINT);
    let shut = scene(middle, &format!("{BALL}{SHUT}{BACKDROP}"), POINT);
    for program in programs() {
        for (text, reason) in [
            (&past, "the camera looks past everything: no ray of the picture"),
            (&behind, "behind surfaces of one side, whose backs are not there"),
            (&dark, "all surfaces in view are black"),
            (&shut, "no light was found on what is in view: something may stand between"),
        ] {
            let found = said(program, text, "").unwrap_or_default();
            assert!(found.contains(reason), "{program}: {found}, not {reason}");
        }
        assert_eq!(said(program, &scene(middle, BALL, POINT), ""), None, "{program}");
        assert_eq!(said(program, &past, "--quiet"), None, "{program}");
    }
}

#[test]
fn the_program_the_length_and_the_exposure_are_reasons_too() {
    let lit = scene("(0, 0, 0)", &format!("{BALL}{LAMP}"), "");
    let trace = said("trace", &lit, "").unwrap();
    assert!(trace.starts_with("trace sees no light of lamps that have an area"), "{trace}");
    let short = said("bdpt", &lit, "--max-depth 1").unwrap();
    assert!(short.starts_with("--max-depth 1 shows lamps alone"), "{short}");
    let stepped = said("bdpt", &lit, "--exposure 1e-9").unwrap();
    assert!(stepped.contains("below the first of 255 steps; try --exposure "), "{stepped}");
    assert_eq!(said("bdpt", &lit, "--exposure 1e-9 -o a.exr"), None);
    let inside = scene(
        "(0, 0, 0)",
        "(shape: Sphere(center: (0, 0, 4), radius: 1), material: \"grey\"),",
        POINT,
    );
    let inside = said("bdpt", &inside, "").unwrap();
    assert!(inside.contains("the camera may stand inside of something"), "{inside}");
}
