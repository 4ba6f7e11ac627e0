//! `scene convert`: the scene that is written renders to the same picture, and nothing that is
//! there is lost.

use crate::common::{Folder, SCENE};

const DATA: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../io/tests/data");
const MODELS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/models");

/// A lamp of two sides, a ball, a cylinder, a cone and a ring that let light through, and a block.
const ROOM: &str = "m lamp =\n ed 562.345\nv a =\n p 0 0 2\nv b =\n p 1 0 2\nv c =\n p 1 1 2\n\
                    v d =\n p 0 1 2\nf a b c d\nm grey =\n rd .5\n ts .2 0\nv e =\n p .2 .1 .3\n\
                    v h =\n p .9 .7 .8\nsph a .25\ncyl e .1 h\ncone e .3 h .1\n\
                    v o =\n p 0 0 0\n n 0.3 0.1 1\nring o 0.5 3\nm metal =\n rd .1\n rs .5 .1\n\
                    prism a b c d -0.3\n";

/// The light of both pictures, bit for bit.
fn renders_the_same(folder: &Folder, program: &str, from: &str, to: &str) {
    let picture = |scene: &str, name: &str| {
        let line = format!("{scene} --spp 1 --resolution 24x18 -q -o {name}");
        let run = folder.run(program, &line);
        assert_eq!(run.status, Some(0), "{line}: {}", run.err);
        traylib_io::load_exr(&folder.path().join(name)).unwrap()
    };
    let [a, b] = [picture(from, "a.exr"), picture(to, "b.exr")];
    let bits = |picture: &traylib_math::Grid<traylib_math::Rgb>| -> Vec<[u32; 3]> {
        picture.values().iter().map(|pixel| pixel.to_array().map(f32::to_bits)).collect()
    };
    assert!(a.values().iter().any(|pixel| !pixel.is_black()), "{from}");
    assert_eq!(bits(&a), bits(&b), "{from}");
}

#[test]
fn every_format_renders_to_the_same_picture() {
    let folder = Folder::new();
    folder.write("room.mgf", ROOM);
    let mut files = vec![
        ("bdpt", "cornell".to_string()),
        ("bdpt", "office-points".to_string()),
        ("bdpt", "glass".to_string()),
        ("bdpt", "bump".to_string()),
        ("bdpt", "bowl".to_string()),
        ("bdpt", "room.mgf".to_string()),
        ("trace", format!("{MODELS}/cube.3ds")),
        ("trace", format!("{DATA}/models/trimesh.obj")),
        ("trace", format!("{DATA}/models/trimesh-binary.ply")),
        ("trace", format!("{DATA}/models/trimesh.glb")),
    ];
    let mitsuba = ["shapes", "meshes", "textures", "sides", "camera-lens", "old", "included"];
    files.extend(mitsuba.map(|name| ("bdpt", format!("{DATA}/mitsuba/{name}.xml"))));
    for (index, (program, file)) in files.iter().enumerate() {
        let to = format!("{index}.ron");
        let run = folder.run("scene", &format!("convert {file} {to}"));
        assert_eq!(run.status, Some(0), "{file}: {}", run.err);
        assert!(!run.err.contains("reads back otherwise"), "{file}: {}", run.err);
        assert!(run.out.starts_with(&format!("{to}\n")), "{file}: {}", run.out);
        renders_the_same(&folder, program, file, &to);
    }
}

#[test]
fn what_is_there_is_replaced_only_on_demand() {
    let folder = Folder::new();
    folder.write("a.ron", SCENE);
    folder.write("b.ron", "by hand");
    let refused = folder.run("scene", "convert a.ron b.ron");
    assert_eq!(refused.status, Some(4), "{}", refused.err);
    assert!(refused.err.contains("b.ron: is there already") && refused.err.contains("--force"));
    assert_eq!(folder.bytes("b.ron"), b"by hand");
    let forced = folder.run("scene", "convert a.ron b.ron --force");
    assert_eq!((forced.status, forced.out.as_str()), (Some(0), "b.ron\n"), "{}", forced.err);
    // Without meshes and pictures there is no folder.
    assert_eq!(folder.names(), ["a.ron", "b.ron"]);
}

#[test]
fn nothing_is_left_of_what_fails() {
    let folder = Folder::new();
    folder.write("bad.ron", "(camera: 3)");
    for (line, status, said) in [
        ("convert bad.ron b.ron", 3, "bad.ron"),
        ("convert cornel b.ron", 3, "did you mean `cornell`"),
        ("convert cornell b.xml", 2, "scenes are written as .ron"),
        ("convert cornell nowhere/b.ron", 4, "nowhere/b.ron"),
    ] {
        let run = folder.run("scene", line);
        assert_eq!(run.status, Some(status), "{line}: {}", run.err);
        assert!(run.err.contains(said), "{line}: {}", run.err);
    }
    assert_eq!(folder.names(), ["bad.ron"]);
}
