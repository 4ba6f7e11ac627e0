use super::mtl::{self, MapKind};
use super::*;
use traylib_math::Rgb;

fn decoded(text: &str) -> Result<Document, Error> {
    decode(text.as_bytes(), Limits::default())
}

/// Positions of a face, and the numbers of its texture coordinates and normals.
type Numbers = Vec<(u32, Option<u32>, Option<u32>)>;

fn numbers(document: &Document, face: usize) -> Numbers {
    let numbers = |c: &Corner| (c.position, c.uv.map(Index::get), c.normal.map(Index::get));
    document.corners_of(&document.faces[face]).iter().map(numbers).collect()
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.25\nvt 1 2 3\nvn 0 0 2\n";

#[test]
fn corners_name_what_they_have() {
    let text = format!(
        "{SQUARE}f 1 2 3 4\nf 1/1 2/2 3/-1\nf 1//1 2//1 3//1\nf -4/-2/-1 -3/2/1 -2/1/1 # end\n"
    );
    let document = decoded(&text).unwrap();
    assert_eq!(document.uvs, [Vec2::new(0.25, 0.0), Vec2::new(1.0, 2.0)]);
    assert_eq!(document.normals, [Vec3::new(0.0, 0.0, 2.0)]);
    assert_eq!(numbers(&document, 0), [0, 1, 2, 3].map(|p| (p, None, None)));
    assert_eq!(numbers(&document, 1), [(0, Some(0), None), (1, Some(1), None), (2, Some(1), None)]);
    assert_eq!(numbers(&document, 2), [0, 1, 2].map(|p| (p, None, Some(0))));
    assert_eq!(
        numbers(&document, 3),
        [(0, Some(0), Some(0)), (1, Some(1), Some(0)), (2, Some(0), Some(0))]
    );
    assert_eq!(document.warnings, WarningCounts::default());
}

#[test]
fn materials_and_smoothing_last_until_the_next() {
    let text = format!(
        "mtllib a b.mtl\n{SQUARE}f 1 2 3\ng x y\nusemtl Red paint #1\ns 3\nf 1 2 3\n\
         o z\nf 1 3 4\nusemtl\tb\ns off\nf 1 2 3\nusemtl Red paint #1\ns 0\nf 2 3 4\n"
    );
    let document = decoded(&text).unwrap();
    assert_eq!(document.libraries, ["a b.mtl"]);
    assert_eq!(document.materials, ["Red paint #1", "b"]);
    let found: Vec<_> = document.faces.iter().map(|f| (f.material, f.smoothing)).collect();
    assert_eq!(found, [(None, 0), (Some(0), 3), (Some(0), 3), (Some(1), 0), (Some(0), 0)]);
}

/// A line is no triangle, whatever number of vertices it has.
#[test]
fn what_is_no_polygon_is_counted() {
    let text = format!(
        "{SQUARE}v 0 0 0 1\nv 0 0 0 2\nv 0 0 0 1 0.5 0\nv 0 0 0 1 0 0 1\nvt nan 0\nvn inf 0 0\n\
         l 1 2 3\np 1\nf 1 2\nvp 1\ncurv 0 1 1 2\ns x\nlod 3\nlod 4\n\u{1}\u{2}\n"
    );
    let document = decoded(&text).unwrap();
    assert!(document.faces.is_empty() && document.corners.is_empty());
    assert_eq!((document.uvs[2], document.normals[1]), (Vec2::ZERO, Vec3::ZERO));
    let count = |kind| document.warnings.count(&kind);
    assert_eq!(count(WarningKind::VertexWeight), 1);
    assert_eq!(count(WarningKind::VertexColour), 2);
    assert_eq!(count(WarningKind::UvNotFinite), 1);
    assert_eq!(count(WarningKind::NormalNotFinite), 1);
    assert_eq!(count(WarningKind::PointOrLine), 2);
    assert_eq!(count(WarningKind::TooFewCorners), 1);
    assert_eq!(count(WarningKind::FreeForm), 2);
    assert_eq!(count(WarningKind::SmoothingGroup), 1);
    assert_eq!(count(WarningKind::Statement("lod".to_string())), 2);
    assert_eq!(count(WarningKind::Nameless), 1);
}

#[test]
fn faults_are_told_with_their_lines() {
    let fault = |text: &str| decoded(&format!("{SQUARE}\\\n{text}")).unwrap_err().to_string();
    for (text, wanted) in [
        ("f 1 2 5", "line 8: there is no vertex 5: there are 4 so far"),
        ("f 1 2 -5", "line 8: there is no vertex -5: there are 4 so far"),
        ("f 1 2 0", "line 8: there is no vertex 0: there are 4 so far"),
        ("f 1/9 2/1 3/1", "line 8: there is no texture coordinate 9: there are 2 so far"),
        ("f 1//0 2//1 3//1", "line 8: there is no normal 0: there are 1 so far"),
        (
            "f 1 2 999999999999999999999",
            "line 8: `999999999999999999999` is no corner: wanted are numbers of vertex, texture \
             coordinate and normal",
        ),
        ("v 1 2", "line 8: `v` wants three coordinates"),
        ("v 1 2 x", "line 8: `x` is no number"),
        ("v 1 2 NaN", "line 8: `NaN` is infinite or not a number"),
        ("v 1 2 1e39", "line 8: `1e39` is infinite or not a number"),
        ("vt", "line 8: `vt` wants one to three coordinates"),
    ] {
        assert_eq!(fault(text), wanted, "{text}");
    }
    for corner in ["/1", "1/1/1/1", "x", "1.5", "--1", "-", "+1"] {
        let fault = fault(&format!("f 1 2 {corner}"));
        assert!(fault.contains(&format!("`{corner}` is no corner")), "{fault}");
    }
}

#[test]
fn what_asks_for_too_much_is_refused() {
    let polygon = |corners: usize| format!("{SQUARE}f{}\n", " 1".repeat(corners));
    let within = |text: &str, limits| decode(text.as_bytes(), limits).map(|_| ());
    let usual = Limits::default();
    assert_eq!(within(&polygon(4096), usual), Ok(()));
    let fault = within(&polygon(4097), usual).unwrap_err().to_string();
    assert!(fault.ends_with("4096 corners; if that is meant, `--limit corners=8192` allows more"));
    let tight = Limits { cutting: 500, ..usual };
    assert_eq!(within(&polygon(20), tight), Ok(()));
    assert_eq!(within(&polygon(16).repeat(9), tight), Ok(()));
    let fault = within(&polygon(20).repeat(2), tight).unwrap_err().to_string();
    assert!(fault.contains("--limit cutting=1000"), "{fault}");
    assert_eq!(within("v", Limits { bytes: 0, ..usual }), Err(Error::TooLong(0)));
}

#[test]
fn text_in_any_coding_is_read() {
    let text = b"# caf\xe9 \\\nusemtl caf\xe9\nv 0 0 0\nv 1 0 0\nv 0 1 0\n\xffx\xfe 1\nf 1 2 3\n";
    let document = decode(text, Limits::default()).unwrap();
    assert_eq!(document.materials, ["caf\u{fffd}"]);
    for text in [b"\xff\xfev\0", b"\xfe\xff\0v"] {
        assert_eq!(decode(text, Limits::default()), Err(Error::Utf16));
        assert_eq!(mtl::decode(text, Limits::default()), Err(Error::Utf16));
    }
}

#[test]
fn materials_are_read_as_they_stand() {
    let text = "Kd 1 1 1\nnewmtl a b\n Kd 0.25 0.5 1\nKs 0.5\nKe 1 2 3\nNs 96.5\nNi 1.5\nTr 0.25\n\
                d -halo 0.5\nTf xyz 1 1 1\nillum 2\nKa 1 1 1\nPm 0.5\n\
                map_Kd -s 2 3 1 -o 0.5 -clamp on -mm 0 1 my wood.png\n\
                map_Bump -bm 0.5 -imfchan l C:\\work\\b.tga\nmap_Ke e.png\nmap_Ns -mm 1 2\n\
                newmtl c\n";
    let library = mtl::decode(text.as_bytes(), Limits::default()).unwrap();
    let [a, c] = &library.materials[..] else { panic!("{library:?}") };
    assert_eq!((a.name.as_str(), c.name.as_str()), ("a b", "c"));
    assert_eq!(a.diffuse, Some(Rgb::new(0.25, 0.5, 1.0)));
    assert_eq!(a.specular, Some(Rgb::splat(0.5)));
    assert_eq!(a.emission, Some(Rgb::new(1.0, 2.0, 3.0)));
    assert_eq!((a.exponent, a.index, a.illumination), (Some(96.5), Some(1.5), Some(2)));
    assert_eq!((a.dissolve, a.transparency, a.filter), (Some(0.5), Some(0.25), None));
    let [(MapKind::Diffuse, wood), (MapKind::Bump, bump), (MapKind::Emission, _)] = &a.maps[..]
    else {
        panic!("{a:?}")
    };
    assert_eq!((wood.file.as_str(), wood.clamp), ("my wood.png", true));
    assert_eq!((wood.scale, wood.offset), (Vec2::new(2.0, 3.0), Vec2::new(0.5, 0.0)));
    assert_eq!((bump.file.as_str(), bump.height), ("C:\\work\\b.tga", 0.5));
    assert_eq!(bump.channel, Some('l'));
    let found: Vec<_> = library.warnings.iter().collect();
    let wanted = [
        "colour as a spectrum or in CIE XYZ skipped",
        "halo of `d` taken for even opacity",
        "option `-mm` of a map skipped",
        "statement `Kd` skipped",
        "statement `Pm` skipped",
    ];
    assert_eq!(found, wanted.map(|what| (what.to_string(), 1)));
    let fault = mtl::decode(b"newmtl a\n\nKd 1 x 1\n", Limits::default()).unwrap_err();
    assert_eq!(fault.to_string(), "line 3: `x` is no number");
    assert!(mtl::decode(b"newmtl a\nNs\n", Limits::default()).is_err());
}
