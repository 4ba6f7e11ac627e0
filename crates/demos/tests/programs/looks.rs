//! Exposure and tones of pictures that a screen shows: `--exposure auto`, `--tone`.

use crate::common::Folder;
use traylib_io::{Look, TextureLimits, Tone, load_exr, load_texture, png_texts};

const TINY: &str = "cornell --resolution 24x18 --spp 2";

/// The exposure that a program says it took.
fn told(said: &str) -> String {
    let note = "note: exposure taken of the picture: --exposure ";
    let mut lines = said.lines().filter_map(|line| line.strip_prefix(note));
    let exposure = lines.next().unwrap().to_owned();
    assert_eq!(lines.next(), None, "{said}");
    exposure
}

fn text(folder: &Folder, name: &str, wanted: &str) -> Option<String> {
    let texts = png_texts(&folder.path().join(name));
    texts.into_iter().find(|(name, _)| name == wanted).map(|(_, text)| text)
}

/// The number makes the same bytes, and so does `film convert` of the light.
#[test]
fn an_exposure_that_is_taken_is_told_and_can_be_given() {
    let folder = Folder::new();
    let run = folder.run("bdpt", &format!("{TINY} --exposure auto -o a.png -o a.exr"));
    assert_eq!(run.status, Some(0), "{}", run.err);
    let exposure = told(&run.err);
    assert_eq!(text(&folder, "a.png", "exposure"), Some(exposure.clone()));
    let given = folder.run("bdpt", &format!("{TINY} --exposure {exposure} -o b.png -q"));
    assert_eq!((given.status, given.err.as_str()), (Some(0), ""));
    assert!(folder.bytes("a.png") == folder.bytes("b.png"));
    let converted = folder.run("film", "convert a.exr c.png --exposure auto");
    assert_eq!((converted.status, told(&converted.err)), (Some(0), exposure.clone()));
    assert_eq!(text(&folder, "c.png", "exposure"), Some(exposure));
    assert_eq!(shown(&folder, "c.png"), shown(&folder, "a.png"));
    let quiet = folder.run("bdpt", &format!("{TINY} --exposure auto -q"));
    assert_eq!((quiet.status, quiet.err.as_str()), (Some(0), ""));
}

/// A film keeps light: that of a program which was left the exposure is that of one which was not.
#[test]
fn a_film_knows_nothing_of_an_exposure_that_was_taken() {
    let folder = Folder::new();
    for (film, more) in [("a", "--exposure auto"), ("b", "")] {
        let options = format!("{TINY} -q --checkpoint {film}.film -o {film}.png {more}");
        assert_eq!(folder.run("bdpt", &options).status, Some(0));
    }
    assert!(folder.bytes("a.film") == folder.bytes("b.film"));
    assert_eq!(folder.run("film", "convert a.film c.png --exposure auto").status, Some(0));
    assert_eq!(shown(&folder, "c.png"), shown(&folder, "a.png"));
    assert_ne!(shown(&folder, "c.png"), shown(&folder, "b.png"));
}

fn shown(folder: &Folder, name: &str) -> Vec<[u8; 3]> {
    let image = load_texture(&folder.path().join(name), TextureLimits::default()).unwrap();
    // What a linear look makes of it are its own bytes again.
    image.pixels.values().iter().map(|&light| Look::from(1.0).bytes(light)).collect()
}

#[test]
fn tones_are_those_of_the_curve_and_are_told() {
    let folder = Folder::new();
    let options = format!("{TINY} -q --exposure 3 --tone filmic --checkpoint a.film");
    let run = folder.run("bdpt", &format!("{options} -o a.png -o a.exr"));
    assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
    let light = load_exr(&folder.path().join("a.exr")).unwrap();
    let look = Look { exposure: 3.0, tone: Tone::Filmic };
    let expected: Vec<[u8; 3]> = light.values().iter().map(|&light| look.bytes(light)).collect();
    assert_eq!(shown(&folder, "a.png"), expected);
    assert_eq!(text(&folder, "a.png", "tone").as_deref(), Some("filmic"));
    assert!(text(&folder, "a.png", "command").unwrap().contains(" --tone filmic "));
    // The film has it, too.
    assert_eq!(folder.run("film", "convert a.film b.png").status, Some(0));
    assert!(folder.bytes("b.png") == folder.bytes("a.png"));
    // Of an EXR file light is taken, and what the picture says is true of it.
    let run = folder.run("film", "convert a.exr c.png --exposure 3 --tone filmic");
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert_eq!(shown(&folder, "c.png"), expected);
    assert_eq!(folder.run("film", "convert a.exr d.png").status, Some(0));
    assert_eq!(text(&folder, "d.png", "exposure").as_deref(), Some("1"));
    assert_eq!(text(&folder, "d.png", "tone"), None);
}

#[test]
fn what_was_not_asked_for_is_as_it_was() {
    let folder = Folder::new();
    for (name, more) in [("a", ""), ("b", "--tone linear")] {
        let run = folder.run("bdpt", &format!("{TINY} -q -o {name}.png {more}"));
        assert_eq!(run.status, Some(0), "{}", run.err);
    }
    assert!(folder.bytes("a.png") == folder.bytes("b.png"));
    assert_eq!(text(&folder, "a.png", "tone"), None);
    for bad in ["--tone film", "--exposure automatic", "--exposure 0"] {
        assert_eq!(folder.run("bdpt", &format!("{TINY} {bad}")).status, Some(2), "{bad}");
    }
}
