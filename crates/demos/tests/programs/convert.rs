//! `film convert`: from any format to any, and how it refuses.

use crate::common::Folder;
use traylib_io::{TextureLimits, load_exr, load_texture, write_picture};
use traylib_math::{Grid, Rgb};

/// Light that is a byte on the sRGB curve, brighter than one and darker than zero.
const LIGHT: [Rgb; 3] =
    [Rgb::new(1.0, 0.0, 1.0), Rgb::new(4.0, -1.0, 0.25), Rgb::new(0.125, 0.5, 2.0)];

fn folder() -> Folder {
    let folder = Folder::new();
    let attributes = [("software", "bdpt 1"), ("spp", "16")].map(|(a, b)| (a.into(), b.into()));
    let picture = Grid::from_values(3, 1, LIGHT.to_vec()).unwrap();
    write_picture(&folder.path().join("a.exr"), &picture, 1.0, &attributes).unwrap();
    folder
}

fn light(folder: &Folder, name: &str) -> Vec<Rgb> {
    let found = load_texture(&folder.path().join(name), TextureLimits::default()).unwrap();
    found.pixels.values().to_vec()
}

#[test]
fn every_format_becomes_every_other() {
    let folder = folder();
    for from in ["exr", "hdr", "png", "tga", "pcx"] {
        for to in ["exr", "hdr", "png", "tga", "pcx"] {
            let run = folder.run("film", &format!("convert a.{from} b.{to}"));
            let said = match (from, to) {
                ("exr", "hdr") => {
                    "warning: b.hdr: number that is negative, infinite or none, written as the nearest\n"
                }
                _ => "",
            };
            assert_eq!((run.status, run.err.as_str()), (Some(0), said), "{from} {to}");
            assert_eq!(run.out, format!("b.{to}\n"));
            let [a, b] = [light(&folder, &format!("a.{from}")), light(&folder, &format!("b.{to}"))];
            let clipped = |a: f32| if to == "exr" { a } else { a.max(0.0) };
            let most = if ["exr", "hdr"].contains(&to) { f32::MAX } else { 1.0 };
            for (a, b) in a.iter().zip(&b) {
                let pairs = a.to_array().into_iter().zip(b.to_array());
                let off = pairs.map(|(a, b)| (clipped(a).min(most) - b).abs()).fold(0.0, f32::max);
                // A byte of the curve, and half a step of the brightest band.
                assert!(off <= 0.02, "{from} {to}: {a:?} became {b:?}");
            }
            if from == "exr" && to != "exr" {
                std::fs::rename(
                    folder.path().join(format!("b.{to}")),
                    folder.path().join(format!("a.{to}")),
                )
                .unwrap();
            }
        }
    }
    assert_eq!(load_exr(&folder.path().join("b.exr")).unwrap().width(), 3);
}

#[test]
fn exposure_is_for_formats_that_a_screen_shows() {
    let folder = folder();
    for format in ["png", "exr"] {
        let run = folder.run("film", &format!("convert a.exr b.{format} --exposure 2"));
        assert_eq!(run.status, Some(0), "{}", run.err);
    }
    assert_eq!(light(&folder, "b.exr"), LIGHT);
    let shown = light(&folder, "b.png");
    assert!((shown[1].b - 0.5).abs() < 0.005 && shown[2].g == 1.0, "{shown:?}");
}

/// The making of an EXR file is known; nothing is known of others.
#[test]
fn how_a_picture_was_made_is_kept() {
    let folder = folder();
    assert_eq!(folder.run("film", "convert a.exr b.exr").status, Some(0));
    let said = folder.run("film", "info b.exr").out;
    assert!(said.contains("    software = bdpt 1\n    spp = 16\n"), "{said}");
    assert_eq!(folder.run("film", "convert a.exr b.png").status, Some(0));
    let png = std::fs::read(folder.path().join("b.png")).unwrap();
    assert!(png.windows(6).any(|bytes| bytes == b"bdpt 1"));
    assert_eq!(folder.run("film", "convert b.png c.exr").status, Some(0));
    let said = folder.run("film", "info c.exr").out;
    assert!(said.contains("    software = film ") && !said.contains("spp"), "{said}");
}

#[test]
fn what_is_left_out_is_told() {
    let folder = Folder::new();
    // One transparent pixel.
    let gif = b"GIF89a\x01\0\x01\0\x80\0\0\xff\0\0\0\0\xff!\xf9\x04\x01\0\0\0\0,\0\0\0\0\x01\0\x01\0\0\x02\x02D\x01\0;";
    std::fs::write(folder.path().join("a.gif"), gif).unwrap();
    let run = folder.run("film", "convert a.gif b.png");
    assert_eq!((run.status, run.out.as_str()), (Some(0), "b.png\n"), "{}", run.err);
    assert_eq!(run.err, "warning: a.gif: opacity left out, no format has it here\n");
}

#[test]
fn failures_are_one_line_and_leave_what_was_there() {
    let folder = folder();
    folder.write("text.png", "no picture");
    folder.write("b.png", "before");
    for (arguments, status, words) in [
        ("text.png b.png", 3, "error: text.png: cannot be read as a picture: it begins as none of"),
        ("none.png b.png", 3, "error: none.png: cannot be read as a picture: "),
        ("a.exr no/b.png", 4, "error: no/b.png: cannot be written: "),
        ("a.exr b.jpg", 2, "error: b.jpg: pictures are written as .png, .exr,"),
    ] {
        let run = folder.run("film", &format!("convert {arguments}"));
        assert_eq!((run.status, run.out.as_str()), (Some(status), ""), "{arguments}: {}", run.err);
        assert!(run.err.starts_with(words) && run.err.lines().count() == 1, "{}", run.err);
    }
    for (arguments, words) in [
        ("a.exr", "<OUT>"),
        ("a.exr b.png --exposure 0", "wanted a number above 0"),
        ("a.exr b.png --exposure inf", "wanted a number above 0"),
    ] {
        let run = folder.run("film", &format!("convert {arguments}"));
        assert_eq!((run.status, run.out.as_str()), (Some(2), ""), "{arguments}");
        assert!(run.err.contains(words), "{arguments}: {}", run.err);
    }
    assert_eq!(std::fs::read(folder.path().join("b.png")).unwrap(), b"before");
    assert_eq!(folder.names(), ["a.exr", "b.png", "text.png"]);
}
