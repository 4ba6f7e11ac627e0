use super::*;

fn decoded(bytes: &[u8]) -> Result<Document, Error> {
    decode(bytes, Limits::default())
}

const HEADER: &str = "element vertex 4\nproperty float x\nproperty double y\nproperty float z\n\
                      property uchar red\nproperty float nx\nproperty float ny\nproperty float nz\n\
                      property float s\nproperty float t\nelement edge 1\nproperty int a\n\
                      element face 2\nproperty uchar flags\nproperty list uchar int vertex_indices\n";
/// x, y, z, red, normal, texture coordinates.
const VERTICES: [[f32; 9]; 4] = [
    [0.0, 0.0, 0.0, 255.0, 0.0, 0.0, 1.0, 0.0, 0.0],
    [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0],
    [1.0, 1.0, 0.1, 0.0, 0.0, 0.0, 2.0, 1.0, 1.0],
    [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0],
];

fn as_text() -> Vec<u8> {
    let mut text =
        format!("ply\nformat ascii 1.0\ncomment caf\u{e9}\nbroken comment\n{HEADER}end_header\n");
    for vertex in VERTICES {
        text += &vertex.map(|value| value.to_string()).join(" ");
        text += "\n";
    }
    (text + "7\n\n0 4 0 1 2 3\n1 3 0\n1 2\n").into_bytes()
}

fn as_bytes(is_little: bool) -> Vec<u8> {
    let name = if is_little { "little" } else { "big" };
    let text = format!("ply\r\nformat binary_{name}_endian 1.0 \r\n{HEADER}end_header\r\n");
    let mut bytes = text.replace('\n', "\r\n").replace("\r\r", "\r").into_bytes();
    let ordered = |mut number: Vec<u8>| {
        if !is_little {
            number.reverse();
        }
        number
    };
    for vertex in VERTICES {
        for (index, value) in vertex.into_iter().enumerate() {
            bytes.extend(match index {
                1 => ordered(f64::from(value).to_le_bytes().to_vec()),
                3 => vec![value as u8],
                _ => ordered(value.to_le_bytes().to_vec()),
            });
        }
    }
    bytes.extend(ordered(7_i32.to_le_bytes().to_vec()));
    for face in [&[0_i32, 1, 2, 3][..], &[0, 1, 2]] {
        bytes.extend([0, face.len() as u8]);
        bytes.extend(face.iter().flat_map(|corner| ordered(corner.to_le_bytes().to_vec())));
    }
    bytes
}

/// Text, though its elements stand on any lines, and both orders of bytes are the same.
#[test]
fn all_codings_are_read_alike() {
    let document = decoded(&as_text()).unwrap();
    assert_eq!(document.positions, VERTICES.map(|[x, y, z, ..]| Vec3::new(x, y, z)));
    assert_eq!(document.normals[2], Vec3::new(0.0, 0.0, 2.0));
    assert_eq!(document.uvs, VERTICES.map(|[.., u, v]| Vec2::new(u, v)));
    assert_eq!(
        (&document.corners[..], &document.counts[..]),
        (&[0, 1, 2, 3, 0, 1, 2][..], &[4, 3][..])
    );
    let found: Vec<_> = document.warnings.iter().collect();
    let wanted = [
        ("line of the header that is none skipped", 1),
        ("colour of a vertex skipped", 4),
        ("property `flags` of faces skipped", 1),
        ("element `edge` skipped", 1),
    ];
    assert_eq!(found, wanted.map(|(what, count)| (what.to_string(), count)));
    for is_little in [true, false] {
        let found = decoded(&as_bytes(is_little)).unwrap();
        assert_eq!(found, Document { warnings: found.warnings.clone(), ..document.clone() });
        assert_eq!(
            found.warnings.iter().collect::<Vec<_>>(),
            document.warnings.iter().skip(1).collect::<Vec<_>>()
        );
    }
}

#[test]
fn every_type_of_number_is_read() {
    let bytes = |names: [&str; 8]| {
        let mut bytes = b"ply\nformat binary_little_endian 1.0\n".to_vec();
        for name in ["x", "y", "z"] {
            let end = if name == "x" { "element vertex 1\n" } else { "" };
            bytes.extend(format!("{end}property float {name}\n").bytes());
        }
        for name in names {
            bytes.extend(format!("property {name} q\n").bytes());
        }
        bytes.extend(b"property list uint8 float64 l\nproperty float32 nx\nproperty float ny\n");
        bytes.extend(b"property float nz\nend_header\n");
        bytes.extend([0; 12 + 1 + 1 + 2 + 2 + 4 + 4 + 4 + 8]);
        bytes.extend([2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
        bytes.extend([3.0_f32, 4.0, 5.0].iter().flat_map(|value| value.to_le_bytes()));
        bytes
    };
    let old = ["char", "uchar", "short", "ushort", "int", "uint", "float", "double"];
    let new = ["int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"];
    for names in [old, new] {
        assert_eq!(decoded(&bytes(names)).unwrap().normals, [Vec3::new(3.0, 4.0, 5.0)]);
    }
}

/// The first byte of the data looks like the second half of an end of a line.
#[test]
fn lines_of_the_header_end_as_the_first() {
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\n\
                  property char y\nproperty char z\nend_header\n";
    for end in ["\n", "\r", "\r\n"] {
        let mut bytes = header.replace('\n', end).into_bytes();
        bytes.extend(b"\n\x01\xff");
        assert_eq!(decoded(&bytes).unwrap().positions, [Vec3::new(10.0, 1.0, -1.0)], "{end:?}");
    }
}

const TRIANGLE: &str = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";

fn with_faces(header: &str, body: &str) -> Result<Document, Error> {
    let text = format!(
        "ply\nformat ascii 1.0\n{TRIANGLE}{header}end_header\n0 0 0\n1. 0 0\n0 +1e0 .5\n{body}"
    );
    decoded(text.as_bytes())
}

#[test]
fn strips_are_triangles() {
    let header = "element tristrips 1\nproperty list int int vertex_indices\n";
    let document = with_faces(header, "8 0 1 2 0 -1 2 1 0\n").unwrap();
    assert_eq!(document.corners, [0, 1, 2, 2, 1, 0, 2, 1, 0]);
    assert_eq!(document.counts, [3, 3, 3]);
}

#[test]
fn corners_may_have_texture_coordinates_of_their_own() {
    let header = "comment TextureFile my wood.png\nelement face 2\n\
                  property list uchar float texcoord\nproperty list uchar uint vertex_index\n\
                  property int texnumber\n";
    let document = with_faces(header, "6 0 0 1 0 1 1 3 0 1 2 0\n2 0 0 3 2 1 0 1\n").unwrap();
    assert_eq!(document.textures, ["my wood.png"]);
    assert_eq!(document.corner_uvs[..3], [Vec2::ZERO, Vec2::X, Vec2::ONE]);
    assert_eq!(document.corner_uvs[3..], [Vec2::ZERO; 3]);
    assert_eq!(document.warnings.count(&WarningKind::UvCount), 1);
    assert_eq!(document.warnings.count(&WarningKind::OtherPicture), 1);
}

#[test]
fn faults_are_told_with_their_places() {
    let faces = "element face 1\nproperty list uchar int vertex_indices\n";
    let said = |header: &str, body: &str| with_faces(header, body).unwrap_err().to_string();
    for (header, body, wanted) in [
        (faces, "3 0 1 9", "face 0: there is no vertex 9: there are 3"),
        (faces, "3 0 1 -1", "line 13: face 0: there is no vertex -1"),
        (faces, "3 0 1 1.5", "line 13: face 0: there is no vertex 1.5"),
        (faces, "3 0 1", "line 13: face 0: the file ends"),
        (faces, "3 0 x 1", "line 13: face 0: `x` is no number"),
        (faces, "-3 0 1 2", "line 13: face 0: -3 is no length of a list"),
        (faces, "1e9 0 1 2", "line 13: face 0: 1000000000 is no length of a list"),
        (faces, "nan 0 1 2", "line 13: face 0: NaN is no length of a list"),
        (
            "element face 99999999999\nproperty list int int vertex_indices\n",
            "3 0 1 2",
            "line 12: face 0: there cannot be 99999999999 of them: 8 bytes are left",
        ),
        ("property half h\n", "", "line 7: `half` is no type of a number"),
        ("element face x\n", "", "line 7: `x` is no number"),
        ("element face\n", "", "line 7: `element face` is no line of a header"),
    ] {
        assert_eq!(said(header, body), wanted, "{header}{body}");
    }
    let said = |text: &str| decoded(text.as_bytes()).unwrap_err().to_string();
    assert_eq!(said("plz\n"), "it is no PLY file: it does not begin with `ply`");
    assert_eq!(said("ply\nformat ascii 1.0\n"), "it ends before `end_header`");
    assert_eq!(said("ply\nproperty float x\n"), "line 2: the property belongs to no element");
    assert_eq!(said("ply\nend_header\n"), "line 2: no format is named before");
    let vertex = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n";
    assert_eq!(
        said(&format!("{vertex}end_header\n0 0\n")),
        "line 7: vertex 0: vertices have no `z`"
    );
    let vertex = format!("{vertex}property float z\nend_header\n");
    let wanted = "line 8: vertex 0: a coordinate is infinite or not a number";
    assert_eq!(said(&format!("{vertex}0 0 nan\n")), wanted);
    let cut = &as_bytes(true)[..as_bytes(true).len() - 2];
    assert!(decoded(cut).unwrap_err().to_string().starts_with("byte "));
}

/// Neither time nor memory is taken for what is not there.
#[test]
fn huge_counts_are_refused() {
    let text = "ply\nformat ascii 1.0\nelement nothing 99999999999999\nend_header\n";
    assert_eq!(decoded(text.as_bytes()).unwrap().warnings.iter().count(), 1);
    for (name, is_read) in [("face", true), ("tristrips", true), ("vertex", false)] {
        let found = decoded(text.replace("nothing", name).as_bytes());
        assert_eq!(found.is_ok(), is_read, "{name}");
    }
    let polygon = |corners: usize| format!("{corners}{}\n", " 0".repeat(corners));
    let header = "element face 1\nproperty list int int vertex_indices\n";
    assert!(with_faces(header, &polygon(4096)).is_ok());
    let fault = with_faces(header, &polygon(4097)).unwrap_err().to_string();
    assert!(fault.ends_with("`--limit corners=8192` allows more"), "{fault}");
    assert_eq!(decode(b"ply\n", Limits { bytes: 3, ..Limits::default() }), Err(Error::TooLong(3)));
}
