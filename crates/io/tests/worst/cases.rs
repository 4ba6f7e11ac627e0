//! The files: what each does is in its name.

use std::fmt::Write;
use std::path::Path;

type Case = (&'static str, fn(&Path));

pub(crate) const ALL: [Case; 37] = [
    ("spheres", |at| repeated(at, "sph a 1\n")),
    ("cones", |at| repeated(at, "cone a 1 b 2\n")),
    ("triangles", |at| repeated(at, "f a b c\n")),
    ("many triangles a copy", |at| repeated(at, &"f a b c\n".repeat(5000))),
    ("holes", |at| repeated(at, &format!("fh a b c{}\n", " - a b c".repeat(4)))),
    ("convex polygons", |at| polygons(at, 4000, 0.0)),
    ("star polygons", |at| polygons(at, 4000, 0.5)),
    ("knotted polygons", |at| knots(at, 4000)),
    ("middle polygons", |at| polygons(at, 300, 0.7)),
    ("small polygons", |at| polygons(at, 30, 0.7)),
    ("comb with holes", |at| combs(at, 800)),
    ("knotted prisms", |at| prisms(at, 4000)),
    ("polygons without area", |at| repeated(at, &format!("f{}\n", " a".repeat(4000)))),
    ("names of vertices", |at| names(at, "v")),
    ("names of materials", |at| names(at, "m")),
    ("names of colours", |at| names(at, "c")),
    ("materials anew", |at| repeated(at, "rd .1\nsph a 1\nrd .2\nsph a 1\n")),
    ("materials with a long name", |at| {
        let name = "m".repeat(1 << 19);
        let text =
            format!("m {name} =\nxf -a 400000 -t 1 0 0\nrd .1\nsph a 1\nrd .2\nsph a 1\nxf\n");
        write(at, &format!("{CORNERS}{text}"));
    }),
    ("objects", |at| repeated(at, &"o x\no\n".repeat(9000))),
    ("unknown words", |at| repeated(at, &"x\n".repeat(9000))),
    ("thousands of unknown words", |at| {
        let lines: String = (0..9000).fold(String::new(), |mut text, i| {
            _ = writeln!(text, "?{i}");
            text
        });
        repeated(at, &lines);
    }),
    ("short lines", |at| write(at, &"#\n".repeat(16_000_000))),
    ("long comments", |at| repeated(at, &format!("# {}\n", "x".repeat(1_000_000)))),
    ("long lines of words", |at| repeated(at, &format!("# {}\n", "x ".repeat(500_000)))),
    ("bytes that are no text", |at| {
        std::fs::write(at.join("a.mgf"), b"\xff\n".repeat(16_000_000)).unwrap();
    }),
    ("spectra", |at| repeated(at, "cspec 400 700 1 1\n")),
    ("long spectra", |at| repeated(at, &format!("cspec 400 700{}\n", " 1".repeat(500_000)))),
    ("black bodies", |at| repeated(at, "cct 3000\n")),
    ("mixtures", |at| repeated(at, &format!("cmix{}\n", " 1 k".repeat(250_000)))),
    ("numbers hard to round", |at| {
        let hard = hard_number();
        repeated(at, &format!("p {hard} {hard} {hard}\n").repeat(100));
    }),
    ("short numbers hard to round", |at| {
        repeated(
            at,
            &"p 9007199254740993.000001 9007199254740993.000001 9007199254740993.01\n".repeat(99),
        );
    }),
    ("repeated turns", |at| {
        let turns = "-i 9999999999999999999 -rx 1 ".repeat(30_000);
        write(at, &format!("{CORNERS}xf -a 4000000 -mx {turns}\nsph a 1\nxf\n"));
    }),
    ("turns", |at| repeated(at, &format!("xf {}\nxf\n", "-rx 1 ".repeat(30_000)))),
    ("deep transforms", |at| {
        repeated(at, &format!("{}{}", "xf -mx\n".repeat(1000), "xf\n".repeat(1000)));
    }),
    ("arrays of nothing", |at| {
        repeated(at, &"xf -a 2 -a 2 -a 2 -a 2 -a 2 -a 2 -a 2 -a 2\nxf\n".repeat(99));
    }),
    ("includes", includes),
    ("names of one file", |at| {
        let lines: String = (1..2000).fold(String::new(), |mut text, i| {
            _ = writeln!(text, "i {}b.mgf", "./".repeat(i));
            text
        });
        std::fs::write(at.join("b.mgf"), "").unwrap();
        repeated(at, &lines);
    }),
];

const CORNERS: &str = "c k =\nm\nv a =\np 0 0 0\nn 0 0 1\nv b =\np 1 0 0\nv c =\np 0 1 0\n";

fn write(folder: &Path, text: &str) {
    std::fs::write(folder.join("a.mgf"), text).unwrap();
}

/// Writes as many copies as there may be, and again and again.
fn repeated(folder: &Path, text: &str) {
    let array = format!("xf -a 1000000 -t 1 0 0\n{text}xf\n");
    write(folder, &format!("{CORNERS}{}", array.repeat(1 + 1_000_000 / array.len())));
}

/// Vertices of a polygon whose corners' distance from the middle alternates.
fn corners(count: usize, depth: f64) -> String {
    let mut text = String::new();
    for i in 0..count {
        let (sin, cos) = (i as f64 / count as f64 * std::f64::consts::TAU).sin_cos();
        let radius = if i % 2 == 0 { 1.0 } else { 1.0 - depth };
        _ = write!(text, "v p{i} =\np {} {} 0\n", radius * cos, radius * sin);
    }
    text
}

/// Returns an array of as many copies as can be cut, each at this cost.
fn array(cost: usize) -> String {
    format!("xf -a {} -t 1 0 0\n", (1 << 26) / cost)
}

fn polygons(folder: &Path, count: usize, depth: f64) {
    let names: String = (0..count).fold(String::new(), |text, i| text + &format!(" p{i}"));
    let text = format!("{}{}f{names}\nxf\n", corners(count, depth), array(count * count));
    write(folder, &text);
}

/// Corners in an order that crosses itself everywhere, so that nothing is an ear.
fn knot(count: usize) -> String {
    (0..count).fold(String::new(), |text, i| text + &format!(" p{}", i * 1501 % count))
}

fn knots(folder: &Path, count: usize) {
    let array = array(count * count);
    let text = format!("{}{array}f{}\nxf\n", corners(count, 0.0), knot(count));
    write(folder, &text);
}

fn prisms(folder: &Path, count: usize) {
    let shape = format!("prism{} 1", knot(count));
    let array = array(2 * count * count);
    let text = format!("{}{array}{shape}\nxf\n", corners(count, 0.0));
    write(folder, &text);
}

/// Holes one above the other in a large triangle.
fn combs(folder: &Path, count: usize) {
    let mut text = String::from("v a =\np -9 -9 0\nv b =\np 9e9 -9 0\nv c =\np -9 9e9 0\n");
    let mut face = String::from("fh a b c");
    for i in 0..count {
        for (corner, [x, y]) in ["d", "e", "g"].into_iter().zip([[0, 0], [0, 1], [1, 0]]) {
            _ = write!(text, "v {corner}{i} =\np {} {} 0\n", x * (i % 7 + 1), 2 * i + y);
        }
        _ = write!(face, " - d{i} e{i} g{i}");
    }
    _ = write!(text, "{}{face}\nxf\n", array((5 * count + 3) * (5 * count + 3)));
    write(folder, &text);
}

fn names(folder: &Path, keyword: &str) {
    let mut text = String::new();
    for i in 0..3_000_000 {
        _ = writeln!(text, "{keyword} {i:x} =");
    }
    write(folder, &text);
}

/// A little more than halfway between two numbers: all digits count. Half of the least
/// number that there is has some 750.
fn hard_number() -> String {
    let mut carry = 0;
    let least = format!("{:.1074}", f64::from_bits(1));
    let digits = least.bytes().rev().filter(u8::is_ascii_digit).map(|digit| {
        let value = 5 * (digit - b'0') + carry;
        carry = value / 10;
        char::from(b'0' + value % 10)
    });
    let half: String = digits.collect::<Vec<_>>().into_iter().rev().collect();
    // The digits of 5 · 2⁻¹⁰⁷⁴ stand for a tenth of it; one more 1 lifts it over the half.
    format!("{}1e-1076", half.trim_start_matches('0'))
}

/// Each file includes the next one twice.
fn includes(folder: &Path) {
    for level in 0..60 {
        let name = if level == 0 { "a.mgf".to_string() } else { format!("{level}.mgf") };
        let next = format!("i {}.mgf\n", level + 1);
        std::fs::write(folder.join(name), next.repeat(2)).unwrap();
    }
    std::fs::write(folder.join("60.mgf"), "").unwrap();
}
