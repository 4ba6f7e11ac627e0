//! `--aov`: layers beside the light.

use crate::common::{Folder, SCENE};
use traylib_io::open_exr;

#[test]
fn layers_stand_beside_the_light() {
    let folder = Folder::new();
    folder.write("a.ron", SCENE);
    let run = |words: &str| folder.run("puremc", &format!("a.ron --spp 16 -q {words}"));
    let words = "--aov depth,normal,albedo,variance,depth -o a.exr -o a.png";
    assert_eq!(run(words).status, Some(0));
    assert_eq!(run("-o plain.exr").status, Some(0));
    let file = open_exr(&folder.path().join("a.exr")).unwrap();
    let names: Vec<&str> = file.layers[0].channels.iter().map(|c| c.name.as_str()).collect();
    let expected = [
        "B",
        "G",
        "R",
        "albedo.B",
        "albedo.G",
        "albedo.R",
        "depth.Z",
        "normal.X",
        "normal.Y",
        "normal.Z",
        "variance.B",
        "variance.G",
        "variance.R",
    ];
    assert_eq!(names, expected);
    // The ball's nearest point is two metres away and faces the camera.
    let middle = 12 * 32 + 16;
    let value = |name: &str| {
        let channel = file.layers[0].channels.iter().find(|channel| channel.name == name);
        channel.unwrap().values[middle]
    };
    assert!((value("depth.Z") - 2.0).abs() < 0.01, "{}", value("depth.Z"));
    assert!((value("normal.Z") - 1.0).abs() < 0.01 && value("normal.X").abs() < 0.1);
    assert!((value("albedo.G") - 0.5).abs() < 1e-3);
    assert!(value("variance.G") >= 0.0);
    // The light is that of a picture without them.
    let same = folder.run("film", "diff a.exr plain.exr --max-relmse 0");
    assert_eq!(same.status, Some(0), "{}", same.err);
    let png = run("--aov depth -o b.png");
    assert_eq!(png.status, Some(2));
    assert!(png.err.contains("layers of an .exr"), "{}", png.err);
}
