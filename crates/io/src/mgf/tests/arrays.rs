//! Arrays: what is read again, and what is refused before it is.

use super::*;

fn centres(text: &str) -> Vec<[f64; 3]> {
    let document = with_square(text);
    let centre = |surface: &Surface| {
        let Shape::Sphere { centre, .. } = &surface.shape else { panic!("{surface:?}") };
        centre.round().to_array()
    };
    document.surfaces.iter().map(centre).collect()
}

#[test]
fn the_text_is_read_again_for_every_copy() {
    let copies = centres("xf -a 2 -t 10 0 0 -a 2 -t 0 10 0\nsph b 1\nxf\nsph b 1");
    let expected = [[1.0, 0.0], [1.0, 10.0], [11.0, 0.0], [11.0, 10.0], [1.0, 0.0]];
    assert_eq!(copies, expected.map(|[x, y]| [x, y, 0.0]));
}

#[test]
fn what_changes_in_a_copy_is_changed_for_the_next_one() {
    let text = "m x =\nrd .5\nxf -a 3 -t 1 0 0\nf a b c\nm x\nrd .25\nxf";
    let document = with_square(text);
    let amounts: Vec<f32> =
        document.surfaces.iter().map(|s| document.materials[s.material].rd.amount).collect();
    assert_eq!(amounts, [0.5, 0.25, 0.25]);
    // A name defined by the first copy exists for the others and after them.
    assert_eq!(centres("xf -a 2 -t 0 0 5\nv e = b\nsph e 1\nxf\nsph e 1").len(), 3);
}

#[test]
fn arrays_stand_inside_arrays() {
    let text = "xf -a 2 -t 10 0 0\nxf -a 3 -t 0 1 0\no row\nsph a 1\no\nxf\nsph a 1\nxf";
    let copies = centres(text);
    assert_eq!(copies.len(), 8);
    assert_eq!((copies[2], copies[3], copies[6]), ([0.0, 2.0, 0.0], [0.0; 3], [10.0, 2.0, 0.0]));
    // The end of a copy counts, as the end of a transform does.
    let counts = with_square(text).counts;
    assert_eq!(counts.entities_after_include_and_array["xf"], 1 + 2 + 2 * (1 + 3));
}

#[test]
fn an_array_left_open_still_makes_its_copies() {
    let document = with_square("xf -a 3 -t 1 0 0\nsph a 1");
    assert_eq!(document.surfaces.len(), 3);
    assert_eq!(document.warnings.count(WarningKind::TransformLeftOpen), 3);
}

#[test]
fn explosions_are_refused_before_they_begin() {
    let limit = "more than 1000000 copies; if that is meant, `--limit surfaces=2000000` allows \
                 more";
    for (text, line) in [
        ("xf -a 1000000 -t 1 0 0 -a 1000000 -t 0 1 0\nsph a 1\nxf", 12),
        ("xf -a 18446744073709551615 -mx -a 3 -my\nxf", 12),
        ("xf -a 3000 -mx\nxf -a 3000 -mx\nxf\nxf", 13),
        ("xf -a 200 -mx\nxf -a 200 -mx\nxf -a 200 -mx\nsph a 1\nxf\nxf\nxf", 14),
    ] {
        let message = refused(&format!("{SQUARE}{text}"));
        assert_eq!(message, format!("a.mgf:{line}: xf: {limit}"));
    }
}

/// However often arguments are repeated, a copy takes no longer for it.
#[test]
fn repetitions_in_arguments_are_computed_once() {
    let turns = "-i 9999999999999999999 -my ".repeat(9000);
    assert_eq!(centres(&format!("xf -a 500 -t 1 0 0 {turns}\nsph a 1\nxf")).len(), 500);
}

#[test]
fn surfaces_polygons_work_and_transforms_are_bounded() {
    let array = format!("{SQUARE}xf -a 90 -t 1 0 0\nf a b c\nxf");
    let options = Options { max_surfaces: 100, ..Options::default() };
    let twice = format!("{array}\nxf -a 90 -t 1 0 0\nf a b c\nxf");
    assert!(refused_with(&twice, &options).contains("f: more than 100 surfaces"));
    let options = Options { max_cutting: 90 * 9 - 1, ..Options::default() };
    assert!(refused_with(&array, &options).contains("f: more than 809 squares of vertices"));
    let options = Options { max_work: 1000, ..Options::default() };
    assert!(refused_with(&array, &options).contains("more than 1000 bytes of text and other work"));
    let options = Options { max_transforms: 3, ..Options::default() };
    let deep = "xf -mx\n".repeat(4);
    assert!(refused_with(&deep, &options).starts_with("a.mgf:4: xf: more than 3 open transforms"));
    let options = Options { max_corners: 5, ..Options::default() };
    for face in ["f a b c d a b", "prism a b c d a b 1", "fh a b c - a b"] {
        let message = refused_with(&format!("{SQUARE}{face}"), &options);
        assert!(message.contains("more than 5 vertices in a polygon"), "{message}");
    }
    let options = Options { max_line: 50, ..Options::default() };
    let long = format!("# short\n# {}\\\n{}", "x".repeat(40), "y".repeat(40));
    let expected =
        "a.mgf: line 2 has more than 50 bytes; if that is meant, `--limit line=100` allows more";
    assert_eq!(refused_with(&long, &options), expected);
    let options = Options { max_memory: 10_000, ..Options::default() };
    assert!(refused_with(&array, &options).contains("f: more than 10000 bytes of memory"));
    let names = (0..99).fold(String::new(), |text, i| text + &format!("v {i} =\n"));
    assert!(refused_with(&names, &options).contains("v: more than 10000 bytes of memory"));
    let comment = "#\n".repeat(1000);
    let expected = "a.mgf: takes more memory than is left of 10000 bytes; if that is meant, \
                    `--limit memory=20000` allows more";
    assert_eq!(refused_with(&comment, &options), expected);
    let options = Options { max_bytes: 10, ..Options::default() };
    assert!(refused_with(SQUARE, &options).contains("more than 10 bytes"));
}
