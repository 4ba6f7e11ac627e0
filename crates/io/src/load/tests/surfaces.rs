//! Surfaces as they are once they are loaded, and what there is to warn of.

use super::*;
use traylib_geometry::Ray;
use traylib_materials::SurfaceModel;
use traylib_math::{Rgb, Vec3};

fn warnings(test: &str, inside: &str, others: &[(&str, &[u8])]) -> Vec<String> {
    let folder = std::env::temp_dir().join(format!("traylib-{}-{test}/", std::process::id()));
    let plain = |warning: &Warning| warning.to_string().replace(&*folder.to_string_lossy(), "");
    load_text(test, &lit(inside), others).unwrap().warnings.iter().map(plain).collect()
}

/// A TGA file, grey, of rows from the top.
fn grey(width: u8, bytes: &[u8]) -> Vec<u8> {
    let height = bytes.len() as u8 / width;
    let header = [0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, width, 0, height, 0, 8, 0x20];
    [&header, bytes].concat()
}

/// A picture of four pixels, looked at from six sides: the corners as they are seen,
/// bottom left, bottom right and top left.
#[test]
fn a_box_shows_its_picture_upright_on_each_wall() {
    let text = r#"
        materials: { "t": Textured(base: Lambert(reflectance: (1, 1, 1)), diffuse: "p.tga") },
        objects: [(shape: Box(min: (-1, -1, -1), max: (1, 1, 1)), material: "t")]"#;
    // Top left, top right, bottom left, bottom right.
    let picture = grey(2, &[0, 100, 200, 255]);
    let loaded = load_text("box", &lit(text), &[("p.tga", &picture)]).unwrap();
    let at = |eye: Vec3, point: Vec3| {
        let hit = loaded.scene.intersect(&Ray::new(eye, point - eye)).unwrap();
        let SurfaceModel::Lambert(lambert) = hit.model else { panic!("{:?}", hit.model) };
        (crate::srgb::encode(lambert.reflectance().g) * 255.0).round() as u8
    };
    let (x, y, z) = (Vec3::X, Vec3::Y, Vec3::Z);
    for (out, right, up) in [(z, x, y), (x, -z, y), (-z, -x, y), (-x, z, y), (y, x, -z), (-y, x, z)]
    {
        let seen = [[-0.5, 0.5], [0.5, 0.5], [-0.5, -0.5], [0.5, -0.5]]
            .map(|[a, b]| at(9.0 * out, out + a * right + b * up));
        assert_eq!(seen, [0, 100, 200, 255], "from {out}");
    }
}

#[test]
fn what_lets_light_through_on_one_side_is_named() {
    let leaf = grey(2, &[0, 255]);
    let full = grey(2, &[255, 255]);
    let text = r#"
        materials: {
            "paper": Sheet(transmission: (diffuse: (0.8, 0.8, 0.8))),
            "card": Sheet(reflection: (diffuse: (0.8, 0.8, 0.8)), transmission: ()),
            "window": Pane(reflectance: (0.1, 0.1, 0.1), through: (0.5, 0.5, 0.5)),
            "mirror": Pane(reflectance: (0.1, 0.1, 0.1), through: (0, 0, 0)),
            "leaf": Textured(base: Lambert(reflectance: (0, 0, 0)), opacity: "leaf.tga"),
            "wall": Textured(base: Lambert(reflectance: (0, 0, 0)), opacity: "full.tga"),
            "glass": Glass(index: 1.5),
        },
        objects: ["#;
    let sphere = |material: &str, sides: &str| {
        format!("(shape: Sphere(center: (0, 0, 0), radius: 1), material: \"{material}\", {sides}),")
    };
    let pictures: [(&str, &[u8]); 2] = [("leaf.tga", &leaf), ("full.tga", &full)];
    let all = ["paper", "card", "window", "mirror", "leaf", "wall", "glass"];
    let objects = |sides: &str| all.map(|name| sphere(name, sides)).concat();
    let said = |test, objects: &str| warnings(test, &format!("{text}{objects}]"), &pictures);
    let expected = ["paper", "window", "leaf", "glass"].map(|name| {
        format!(
            "scene.ron: material `{name}` lets light through and has one side, which programs \
             that start at lamps see otherwise than those that start at the camera: give the \
             object `sides: Both`"
        )
    });
    assert_eq!(said("one", &objects("sides: Front")), expected);
    assert_eq!(said("both", &objects("")), [""; 0]);
    let twice = said("twice", &(sphere("paper", "sides: Front").repeat(2)));
    assert_eq!(twice, [format!("{} (2 times)", expected[0])]);
}

/// A closed pane is met as often from either end of a line, unless one is inside.
#[test]
fn an_empty_ball_of_glass_panes_is_no_reason_to_warn() {
    let text = r#"
        materials: {
            "window": Pane(reflectance: (0.1, 0.1, 0.1), through: (0.5, 0.5, 0.5)),
            "w": Lambert(reflectance: (0, 0, 0)),
        },
        objects: [(shape: Sphere(center: (0, 0, 0), radius: 1), material: "window", sides: Front),"#;
    let count = |test, more: &str| warnings(test, &format!("{text}{more}]"), &[]).len();
    let ball = |at: &str, radius: f32| {
        format!("(shape: Sphere(center: {at}, radius: {radius}), material: \"w\")")
    };
    assert_eq!(count("alone", ""), 0);
    assert_eq!(count("apart", &ball("(3, 0, 0)", 1.0)), 0);
    assert_eq!(count("around", &ball("(0, 0, 0)", 50.0)), 0);
    assert_eq!(count("inside", &ball("(0, 0, 0)", 0.5)), 1);
    let lamp = "], lights: [Point(position: (0, 0, 0), intensity: (1, 1, 1))";
    let text = format!("({CAMERA} {text}{lamp}])");
    assert_eq!(load_text("lamp", &text, &[]).unwrap().warnings.len(), 1);
}

const LANTERN: &str = "m paper =\n td .5\n sides 1\nv c =\n p 0 0 0\nsph c 1\n\
                       m glass =\n ts .9 0\n sides 1\n ir 1.5 0\nsph c .1\n\
                       m shade =\n td .5\n ed 100\nring d 0 1\n";

#[test]
fn the_remedy_is_that_of_the_file() {
    let lantern = LANTERN.replace("ring", "v d =\n p 0 0 2\n n 0 0 1\nring");
    let has_glass = |warning: &&String| warning.contains("clear glass");
    let objects = "objects: [(shape: Mesh(file: \"a.mgf\"))]";
    let of = |test, objects: &str| {
        let mut found = warnings(test, objects, &[("a.mgf", lantern.as_bytes())]);
        assert_eq!(found.iter().filter(has_glass).count(), 1, "{found:?}");
        found.retain(|warning| !has_glass(&warning));
        found
    };
    let found = of("mesh", objects);
    // The paper alone: solid glass has both sides, and so has a lamp of two sides.
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("scene.ron: material `paper` lets"), "{found:?}");
    assert!(found[0].ends_with("give the object `sides: Both`"), "{found:?}");
    assert_eq!(of("healed", &objects.replace("\"))", "\"), sides: Both)")), [""; 0]);
    // One side of the lamp, and the glass.
    let fronts = of("fronts", &objects.replace("\"))", "\"), sides: Front)"));
    assert_eq!(fronts.len(), 3, "{fronts:?}");
    let path = std::env::temp_dir().join(format!("traylib-{}-whole.mgf", std::process::id()));
    fs::write(&path, lantern).unwrap();
    let whole = load_scene(&path.to_string_lossy());
    fs::remove_file(&path).unwrap();
    let whole: Vec<String> = whole.unwrap().warnings.iter().map(ToString::to_string).collect();
    let about = |warning: &&String| warning.contains("one side");
    let about: Vec<&String> = whole.iter().filter(about).collect();
    assert_eq!(about.len(), 1, "{whole:?}");
    assert!(about[0].contains("`paper`") && about[0].contains("give it `sides 2`"), "{about:?}");
}

#[test]
fn a_reflectance_beside_the_picture_stays() {
    let text = r#"
        materials: { "t": Textured(base: Lambert(reflectance: (0.5, 0.5, 0.5)), diffuse: "p.tga") },
        objects: [(shape: Sphere(center: (0, 0, 0), radius: 1), material: "t")]"#;
    let loaded = load_text("sphere", &lit(text), &[("p.tga", &grey(1, &[0]))]).unwrap();
    let hit = loaded.scene.intersect(&Ray::new(9.0 * Vec3::Z, Vec3::NEG_Z)).unwrap();
    let SurfaceModel::Lambert(lambert) = hit.model else { panic!("{:?}", hit.model) };
    assert_eq!(lambert.reflectance(), Rgb::splat(0.5));
}
