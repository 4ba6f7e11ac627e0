//! Text of files does nothing to a terminal.

use crate::common::{Folder, Run, SCENE, programs};
use traylib_io::write_picture;
use traylib_math::{Grid, Rgb};

/// Clears the screen, rings, ends C strings, goes back, clears the screen in one
/// character less, and turns what follows around.
const ODD: &str = "\u{1b}[2J\u{7}\u{1}\r\u{9b}2J\u{202e}";
const SHOWN: &str = r"\u{1b}[2J\u{7}\u{1}\u{d}\u{9b}2J\u{202e}";

/// Returns the output of a program, both ways; it ended with this status.
#[track_caller]
fn prints(folder: &Folder, program: &str, arguments: &[&str], status: i32) -> Run {
    let run = Run::from(folder.command(program, "").args(arguments).output().unwrap());
    assert_eq!(run.status, Some(status), "{run:?}");
    let is_obeyed = |c: char| c != '\n' && c.is_control() || c == '\u{202e}';
    assert!(!run.out.contains(is_obeyed) && !run.err.contains(is_obeyed), "{run:?}");
    run
}

#[test]
fn names_in_scenes_are_shown() {
    let folder = Folder::new();
    folder.write("bad.ron", &SCENE.replace("\"grey\",", &format!("\"{ODD}\",")));
    let run = prints(&folder, "bdpt", &["bad.ron", "--check"], 3);
    // The report has signs of its own for most.
    assert!(run.err.contains(r"\u{9b}2J"), "{}", run.err);
    let texture = format!("reflectance: Texture(file: \"{ODD}.png\")");
    folder.write("bad.ron", &SCENE.replace("reflectance: (0.5, 0.5, 0.5)", &texture));
    prints(&folder, "bdpt", &["bad.ron", "--check"], 3);
    folder.write("bad.mgf", &format!("m a{ODD}b =\nsph {ODD} 1\n"));
    let run = prints(&folder, "bdpt", &["bad.mgf", "--check", "--stats", "-"], 3);
    assert!(run.err.contains("bad.mgf:"), "{}", run.err);
    folder.write("bad.mgf", &format!("{ODD} 1\nv c =\n p 0 0 1\nsph c 1\n"));
    prints(&folder, "bdpt", &["bad.mgf", "--check", "--stats", "-"], 0);
}

#[test]
fn names_on_the_command_line_are_shown() {
    let folder = Folder::new();
    let odd = ODD.replace('\u{1}', "x");
    let flag = format!("--{odd}");
    for (arguments, status) in [
        (vec![odd.as_str()], 3),
        (vec!["cornell", &flag], 2),
        (vec!["cornell", "--spp", &odd], 2),
        (vec!["cornell", "-o", &odd], 2),
    ] {
        let run = prints(&folder, "bdpt", &arguments, status);
        assert!(run.err.contains(r"\u{9b}2J"), "{arguments:?}: {}", run.err);
    }
}

/// Names are written as their reader needs them, where that is no terminal.
#[test]
fn a_name_that_is_a_result_is_the_name() {
    let folder = Folder::new();
    let name = format!("{ODD}.png");
    let tiny = ["cornell", "--resolution", "8x6", "--spp", "1", "-o"];
    let mut command = folder.command("bdpt", "");
    let run = Run::from(command.args(tiny).arg(&name).output().unwrap());
    assert_eq!((run.status, run.out), (Some(0), name + "\n"), "{}", run.err);
}

#[test]
fn what_a_picture_says_of_itself_is_shown() {
    let folder = Folder::new();
    let attributes = [("owner", ODD), (ODD, "a"), ("two", "a\nb")];
    let attributes = attributes.map(|(name, text)| (name.to_owned(), text.to_owned()));
    let path = folder.path().join("a.exr");
    write_picture(&path, &Grid::filled(1, 1, Rgb::WHITE), 1.0, &attributes).unwrap();
    let run = prints(&folder, "film", &["info", "a.exr"], 0);
    // The format has Latin-1 alone.
    let shown = SHOWN.replace(r"\u{202e}", "?");
    assert!(run.out.contains(&format!("    owner = {shown}\n")), "{}", run.out);
    assert!(run.out.contains(&format!("    {shown} = a\n")), "{}", run.out);
    assert!(run.out.contains("    two = a b\n"), "{}", run.out);
    let run = prints(&folder, "film", &["info", "a.exr", "--json"], 0);
    let found: serde_json::Value = serde_json::from_str(&run.out).unwrap();
    let owner = found[0]["layers"][0]["attributes"]["owner"].as_str();
    assert_eq!(owner, Some(ODD.replace('\u{202e}', "?").as_str()));
}

#[test]
fn shells_and_manuals_know_all_programs() {
    let folder = Folder::new();
    for program in programs().into_iter().chain(["film"]) {
        for (words, contains) in [
            ("--completions bash", "complete -F"),
            ("--completions fish", "complete -c"),
            ("--man", ".TH "),
        ] {
            let run = folder.run(program, words);
            assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
            assert!(run.out.contains(contains) && run.out.contains(program), "{program} {words}");
        }
        assert_eq!(folder.run(program, "--completions cmd").status, Some(2));
    }
    let list = folder.run("bdpt", "--list").out;
    assert!(list.starts_with("cornell\n") && list.lines().count() > 10, "{list}");
}
