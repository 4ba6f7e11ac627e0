//! `--crop` and `--pixelbounds`: a part of the picture.

use crate::common::{Folder, SCENE};
use traylib_io::{load_exr, open_exr};

/// The light that camera paths find in a pixel does not depend on other pixels, and rounding of its
/// place on the film is all that is left: to a hundredth.
#[test]
fn a_part_shows_what_the_whole_does() {
    let folder = Folder::new();
    folder.write("a.ron", SCENE);
    let run = |words: &str| {
        let run = folder.run("puremc", &format!("a.ron --spp 400 -q {words}"));
        assert_eq!(run.status, Some(0), "{}", run.err);
    };
    run("-o whole.exr");
    run("--pixelbounds 8,24,0,12 -o bounds.exr");
    run("--crop 0.25,0.75,0,0.5 -o crop.exr");
    let load = |name| load_exr(&folder.path().join(name)).unwrap();
    let [whole, part, bounds] = ["whole.exr", "crop.exr", "bounds.exr"].map(load);
    assert!(part == bounds, "two ways to say the same");
    // The rest of the frame is black.
    assert_eq!((part.width(), part.height()), (32, 24));
    assert_eq!(part.get(7, 11).g, 0.0);
    let mean = |of: &dyn Fn(usize, usize) -> f32| {
        let sum: f32 =
            (0..12).flat_map(|y| (0..16).map(move |x| (x, y))).map(|(x, y)| of(x, y)).sum();
        sum / (16.0 * 12.0)
    };
    let (whole, part) = (mean(&|x, y| whole.get(x + 8, y).g), mean(&|x, y| part.get(x + 8, y).g));
    assert!(part > 0.01 && (part / whole - 1.0).abs() < 0.05, "{whole} {part}");
}

#[test]
fn an_exr_keeps_the_place_of_the_part() {
    let folder = Folder::new();
    let words = "cornell --resolution 20x10 --pixelbounds 3,7,4,6 --spp 1 -q";
    assert_eq!(folder.run("bdpt", &format!("{words} -o a.exr")).status, Some(0));
    let file = open_exr(&folder.path().join("a.exr")).unwrap();
    let info = folder.run("film", "info a.exr");
    assert!(info.out.contains("--pixelbounds 3,7,4,6"), "{}", info.out);
    assert_eq!(file.layers.len(), 1);
    // The command makes the same picture again, and so does a film of it.
    let command = info.out.lines().find_map(|line| line.split_once("bdpt cornell ")).unwrap().1;
    assert_eq!(folder.run("bdpt", &format!("cornell {command} -q -o b.exr")).status, Some(0));
    let film = format!("{words} --checkpoint a.film -o c.exr");
    assert_eq!(folder.run("bdpt", &film).status, Some(0));
    assert_eq!(folder.run("film", "convert a.film d.exr").status, Some(0));
    assert_eq!(folder.bytes("c.exr"), folder.bytes("d.exr"));
}

#[test]
fn what_is_no_part_is_told() {
    let folder = Folder::new();
    for (words, told) in [
        ("--pixelbounds 0,999,0,9", "--pixelbounds 0,999,0,9: no pixels of a picture of 8x6"),
        ("--crop 0.01,0.02,0,1", "no pixels of a picture of 8x6"),
        ("--crop 0,2,0,1", "wanted as 0.25,0.75,0,0.5"),
        ("--crop 0,1,0,1 --pixelbounds 0,1,0,1", "cannot be used with"),
    ] {
        let run = folder.run("bdpt", &format!("cornell --resolution 8x6 {words}"));
        assert_eq!(run.status, Some(2), "{words}: {}", run.err);
        assert!(run.err.contains(told), "{words}: {}", run.err);
    }
    // Pixels are counted in the whole.
    let pixel = "cornell --resolution 8x6 --spp 1 --pixelbounds 4,8,0,6 --pixel";
    assert_eq!(folder.run("bdpt", &format!("{pixel} 5,3")).status, Some(0));
    let outside = folder.run("bdpt", &format!("{pixel} 3,3"));
    assert_eq!(outside.status, Some(2));
    assert!(outside.err.contains("outside the 4x6 picture, 4,8,0,6"), "{}", outside.err);
}

/// The camera that `realtime` prints can be pasted; the command of the picture has it.
#[test]
fn a_camera_takes_the_place_of_the_scenes() {
    let folder = Folder::new();
    folder.write("a.ron", SCENE);
    let moved = SCENE.replace("(0, 0, 3)", "(0, 1, 4)").replace("fov: 40", "fov: 30");
    folder.write("b.ron", &moved);
    let film = |scene: &str, words: &[&str], name: &str| {
        let mut command = folder.command("puremc", &format!("{scene} --spp 2 -q -o {name}"));
        let run = command.args(words).output().unwrap();
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        folder.bytes(name)
    };
    let expected = film("b.ron", &[], "b.hdr");
    assert!(expected != film("a.ron", &[], "a.hdr"));
    let pasted = ["--camera", "camera: (position: (0, 1, 4), target: (0, 0, 0), fov: 30),"];
    assert!(expected == film("a.ron", &pasted, "c.hdr"));
    let defined = ["-D", "camera.fov=30", "-D", "camera.position=(0, 1, 4)"];
    assert!(expected == film("a.ron", &defined, "d.hdr"));
    film("a.ron", &defined, "e.png");
    let info = folder.run("film", "info e.png").out;
    let camera =
        "--camera 'camera: (position: (0, 1, 4), target: (0, 0, 0), up: (0, 1, 0), fov: 30";
    assert!(info.contains(camera), "{info}");
    for (words, told) in [
        (["-D", "lens=3"], "wanted as camera.fov=35"),
        (["-D", "camera.fov=x"], "wanted as `position"),
        (["--camera", "up: (0, 0, 3)"], "--camera: camera: up points along the view"),
    ] {
        let run = folder.command("bdpt", "a.ron").args(words).output().unwrap();
        assert_eq!(run.status.code(), Some(2));
        let err = String::from_utf8_lossy(&run.stderr);
        assert!(err.contains(told), "{err}");
    }
}
