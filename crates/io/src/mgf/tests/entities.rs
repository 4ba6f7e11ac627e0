//! Single entities: what they make and what they refuse.

use super::*;
use traylib_math::Rgb;
use traylib_math::glam::DVec3;

#[test]
fn faces_keep_the_order_of_their_vertices() {
    let shape = only_shape("f a b c d");
    let square = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    assert_eq!((shape.keyword(), positions(&shape)), ("f", square.to_vec()));
}

#[test]
fn faces_may_have_holes() {
    let inner = "v e =\np .2 .2 0\nv g =\np .2 .4 0\nv h =\np .4 .2 0\n";
    let Shape::Face { outline, holes } = only_shape(&format!("{inner}fh a b c d - e g h")) else {
        panic!("no face")
    };
    assert_eq!((outline.len(), holes.len(), holes[0].len()), (4, 1, 3));
    assert_eq!(holes[0][1].position, DVec3::new(0.2, 0.4, 0.0));
}

#[test]
fn round_shapes_take_the_sign_of_their_radius_for_their_side() {
    for (text, keyword, expected) in [
        ("sph a 2", "sph", false),
        ("sph a -2", "sph", true),
        ("cyl a 2 b", "cyl", false),
        ("cyl a -2 b", "cyl", true),
        ("cone a 2 b 0", "cone", false),
        ("cone a 0 b -1", "cone", true),
        ("torus an 1 2", "torus", false),
        ("torus an -1 -2", "torus", true),
        ("torus an 0 -2", "torus", true),
    ] {
        let shape = only_shape(text);
        let inward = match shape {
            Shape::Sphere { radius, inward, .. } | Shape::Cylinder { radius, inward, .. } => {
                assert_eq!(radius, 2.0);
                inward
            }
            Shape::Cone { radii, inward, .. } => {
                assert!(radii[0] >= 0.0 && radii[1] >= 0.0);
                inward
            }
            Shape::Torus { radius, tube_radius, inward, .. } => {
                assert!(radius + tube_radius == 2.0, "{text}");
                inward
            }
            Shape::Face { .. } | Shape::Ring { .. } | Shape::Prism { .. } => panic!("{shape:?}"),
        };
        assert_eq!((shape.keyword(), inward), (keyword, expected), "{text}");
    }
}

#[test]
fn rings_lie_about_their_normal() {
    let expected = Shape::Ring { centre: DVec3::ZERO, normal: DVec3::Z, radii: [0.0, 3.0] };
    assert_eq!(only_shape("ring an 0 3"), expected);
}

#[test]
fn prisms_grow_away_from_the_face_that_is_given() {
    let Shape::Prism { offset, inward, .. } = only_shape("prism a b c d .5") else { panic!() };
    assert_eq!((offset, inward), (DVec3::new(0.0, 0.0, -0.5), false));
    let Shape::Prism { offset, inward, .. } = only_shape("prism a b c d -.5") else { panic!() };
    assert_eq!((offset, inward), (DVec3::new(0.0, 0.0, 0.5), true));
}

#[test]
fn normals_get_length_one_and_zero_is_none() {
    let text = "v x =\np 0 0 0\nn 0 3 4\nv y =\np 1 0 0\nn 0 0 0\nv z = x\np 0 1 0\nf x y z";
    let Shape::Face { outline, .. } = only_shape(text) else { panic!() };
    let normals: Vec<_> = outline.iter().map(|vertex| vertex.normal).collect();
    let [Some(first), None, last] = normals[..] else { panic!("{normals:?}") };
    assert!((first - DVec3::new(0.0, 0.6, 0.8)).length() < 1e-12 && last == Some(first));
}

#[test]
fn transforms_act_on_geometry_when_it_is_read() {
    let text = "xf -s 2 -t 0 0 1\nv e =\np 1 0 0\nf a e c\nsph b 1.5\nring an 1 2\nxf\nf a e c";
    let document = with_square(text);
    let shapes: Vec<&Shape> = document.surfaces.iter().map(|surface| &surface.shape).collect();
    assert_eq!(positions(shapes[0]), [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, 2.0, 1.0]]);
    let centre = DVec3::new(2.0, 0.0, 1.0);
    assert_eq!(*shapes[1], Shape::Sphere { centre, radius: 3.0, inward: false });
    let Shape::Ring { normal, radii, .. } = shapes[2] else { panic!() };
    assert_eq!((*normal, *radii), (DVec3::Z, [2.0, 4.0]));
    assert_eq!(positions(shapes[3])[1], [1.0, 0.0, 0.0]);
}

#[test]
fn an_inner_transform_acts_first() {
    let shape = only_shape("xf -t 1 0 0\nxf -rz 90\nsph b 1\nxf\nxf");
    let Shape::Sphere { centre, .. } = shape else { panic!() };
    assert!((centre - DVec3::new(1.0, 1.0, 0.0)).length() < 1e-12);
}

#[test]
fn mirrors_keep_fronts_in_front() {
    for mirror in ["-mx", "-s -1", "-mx -my -mz", "-rx 20 -mz"] {
        // The ring's normal tells where the square's front has gone.
        let text = format!("xf {mirror}\nring an 0 1\nf a b c\nprism a b c 2\nsph b -1\nxf");
        let shapes: Vec<Shape> = with_square(&text).surfaces.into_iter().map(|s| s.shape).collect();
        let [
            Shape::Ring { normal, .. },
            Shape::Face { outline, .. },
            Shape::Prism { offset, .. },
            Shape::Sphere { inward, .. },
        ] = &shapes[..]
        else {
            panic!("{shapes:?}")
        };
        assert!((shape::newell(outline) - *normal).length() < 1e-12, "{mirror}");
        assert!((*offset + *normal * 2.0).length() < 1e-12 && *inward, "{mirror}");
    }
}

#[test]
fn geometry_without_a_material_is_black_and_two_sided() {
    let document = with_square("f a b c");
    let material = &document.materials[0];
    assert_eq!((&*material.name, material.rd.rgb()), ("", Rgb::BLACK));
    assert!(material.two_sided && !material.emits());
}

#[test]
fn a_material_takes_the_colour_that_is_current_when_a_number_is_read() {
    let document = with_square(
        "c red =\ncxy .64 .33\nm x =\nc red\nrd .5\nc\nrs .25 .1\nc red\ncxy .3 .3\nf a b c",
    );
    let material = &document.materials[0];
    assert!(material.rd.colour.r > 3.0 && material.rd.colour.b < 0.1, "{material:?}");
    assert_eq!((material.rd.amount, material.rs.amount), (0.5, 0.25));
    assert!((material.rs.colour.r - material.rs.colour.b).abs() < 1e-5);
}

#[test]
fn what_is_redefined_leaves_earlier_surfaces_alone() {
    let document = with_square("m x =\nrd .5\nf a b c\nm x =\nrd .25\nf a b c\nm x\nf a b c\n");
    let used: Vec<usize> = document.surfaces.iter().map(|surface| surface.material).collect();
    assert_eq!(used, [0, 1, 1]);
    assert_eq!(document.materials.iter().map(|m| m.rd.amount).collect::<Vec<_>>(), [0.5, 0.25]);
    assert_eq!(document.counts.materials_used_by_geometry, 1);
    assert_eq!(document.counts.material_definitions, 2);
}

#[test]
fn colours_come_from_spectra_black_bodies_and_mixtures() {
    let document = with_square(
        "c flat =\ncspec 380 780 2 2\nc warm =\ncct 2856\nc mixed =\ncmix 1 flat 1 warm\n\
         m x =\nc flat\nrd .1\nc warm\ntd .1\nc mixed\nrs .1 0\nf a b c",
    );
    let material = &document.materials[0];
    let [flat, warm, mixed] = [material.rd, material.td, material.rs].map(|part| part.colour);
    assert!((flat.r - 1.0).abs() < 1e-5 && warm.r > 1.5 && warm.b < 0.5);
    // Parts of one luminance mix as their bands do.
    assert!((mixed.r - f32::midpoint(flat.r, warm.r)).abs() < 1e-4);
}

#[test]
fn unnamed_contexts_count_by_their_default_name() {
    let document = with_square("m\ned 100\nsides 1\nf a b c\nm y =\nf a b c\nsph a 1");
    let counts = &document.counts;
    assert_eq!(counts.emitting_material_names, ["(unnamed)"]);
    assert_eq!((counts.surfaces, counts.emitting_surfaces), (3, 1));
    assert_eq!((counts.by_kind["f"], counts.by_kind["sph"]), (2, 1));
    assert_eq!(counts.entities_after_include_and_array["v"], 5);
    assert_eq!((counts.materials_used_by_geometry, counts.emitting_materials_used), (2, 1));
}

#[test]
fn what_is_unknown_is_skipped_and_told_of_once_a_word() {
    let document = with_square("0 0 0\n#glued\n0 1\nfoo\nies lamp.ies -t 0 0 1\n# fine\nf a b c");
    assert_eq!((document.surfaces.len(), document.counts.unknown_entities), (1, 4));
    assert_eq!(
        warned(&document),
        [
            "a.mgf:12: unknown entity `0` skipped (2 times)",
            "a.mgf:15: unknown entity `foo` skipped",
            "a.mgf:13: `#glued` taken for a comment (a blank belongs after its #)",
            "a.mgf:16: luminaire `lamp.ies` skipped with its light (ies is not read)",
        ]
    );
}

#[test]
fn what_can_be_repaired_is_told_of() {
    let text = "m x =\nrd .9\nrs .9 0\nsph a 1\ncyl a 1 a\nf a a a\nxf -s 1e30\nxf -s 1e30\nsph b 1\n\
                o open";
    let document = with_square(text);
    assert_eq!(document.surfaces.len(), 1);
    let kinds: Vec<WarningKind> = document.warnings.iter().map(|warning| warning.kind).collect();
    let expected = [
        WarningKind::TransformLeftOpen,
        WarningKind::ObjectLeftOpen,
        WarningKind::ScattersTooMuch,
        WarningKind::NoArea,
        WarningKind::NoArea,
        WarningKind::NotFinite,
    ];
    assert_eq!(kinds, expected);
    assert_eq!(document.warnings.count(WarningKind::TransformLeftOpen), 2);
}

#[test]
fn errors_name_file_line_and_entity() {
    for (line, message) in [
        ("m x = y", "m: no material is named `y`"),
        ("c x", "c: no colour is named `x`"),
        ("f a b e", "f: no vertex is named `e`"),
        ("f a b", "f: 2 arguments where it takes 3 vertices or more"),
        ("fh a b c - a b", "fh: 2 arguments where it takes 3 vertices or more"),
        ("p 1 2", "p: 2 arguments where it takes 3 numbers"),
        ("p 1 2 x", "p: `x` is not a finite number"),
        ("n 1 2 nan", "n: `nan` is not a finite number"),
        ("p 1 2 1e999", "p: `1e999` is not a finite number"),
        ("rd 1.5", "rd: the fraction is 1.5, it must be from 0 to 1"),
        ("sph a 0", "sph: the radius is 0, it must be other than 0"),
        ("ring a 0 1", "ring: the vertex needs a normal, which gives the axis"),
        ("ring an 1 1", "ring: the radii must be 0 <= r0 < r1"),
        ("torus a 1 2", "torus: the vertex needs a normal, which gives the axis"),
        ("torus an 2 1", "torus: the radii must be 0 <= r0 < r1 or r1 < r0 <= 0"),
        ("torus an -1 2", "torus: the radii must be 0 <= r0 < r1 or r1 < r0 <= 0"),
        ("cone a 1 b -1", "cone: the radii must have one sign, and only one may be 0"),
        ("cone a 0 b 0", "cone: the radii must have one sign, and only one may be 0"),
        ("prism a b c 0", "prism: the length is 0, it must be other than 0"),
        ("prism a b 1", "prism: 2 arguments where it takes 3 vertices or more"),
        ("cmix 1 x", "cmix: 2 arguments where it takes 2 or more pairs of a weight and a colour"),
        (
            "cspec 400 700 1",
            "cspec: 3 arguments where it takes 2 wavelengths and 2 samples or more",
        ),
        ("cct 900", "cct: the temperature is 900, it must be from 1000 to 1e10 K"),
        ("xf", "xf: closes nothing that this file has opened"),
        ("o", "o: closes nothing that this file has opened"),
        ("xf -q", "xf: `-q` is no option of a transform"),
        ("xf -t 1 2", "xf: `-t` lacks a number"),
        ("i", "i: 0 arguments where it takes a file and a transform"),
        ("ies", "ies: 0 arguments where it takes a file and a transform"),
    ] {
        assert_eq!(refused(&format!("{SQUARE}{line}\n")), format!("a.mgf:12: {message}"));
    }
}
