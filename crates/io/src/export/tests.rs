use super::*;
use crate::import::SceneParts;
use std::fs;
use std::path::PathBuf;

/// A folder of a test, gone with the value.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let folder =
            std::env::temp_dir().join(format!("traylib-export-{}-{test}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// What a scene is built of, before and after it is written.
    fn both(&self, text: &str) -> [SceneParts; 2] {
        fs::write(self.path("a.ron"), text).unwrap();
        let converted = self.convert("a.ron", "b.ron").unwrap();
        let again = |warning: &Warning| warning.what.contains("reads back otherwise");
        assert!(!converted.warnings.iter().any(again), "{:?}", converted.warnings);
        ["a.ron", "b.ron"].map(|name| {
            let name = self.path(name).to_string_lossy().into_owned();
            crate::load::load_parts(&name, LoadOptions::default()).unwrap().0
        })
    }

    fn convert(&self, from: &str, to: &str) -> Result<Converted, Error> {
        let from = self.path(from).to_string_lossy().into_owned();
        convert_scene(&from, &self.path(to), LoadOptions::default(), false)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

const CAMERA: &str =
    "camera: (position: (0, 1, 4), target: (0.1, 1, 0), fov: 40, resolution: (40, 30)),";

#[test]
fn skies_read_back_as_they_were() {
    let ball = r#"materials: { "grey": Lambert(reflectance: (0.5, 0.5, 0.5)) },
        objects: [(shape: Sphere(center: (0, 0, 0), radius: 1), material: "grey")],"#;
    let folder = Folder::new("sky");
    let [constant, again] =
        folder.both(&format!("({CAMERA} {ball} sky: Constant(radiance: (1, 0.3, 0.1)))"));
    assert!(constant.sky.is_some() && constant.sky == again.sky);
    // A picture, twice as bright and turned: what is written has that in its texels.
    let folder = Folder::new("sky-picture");
    let light = traylib_math::Grid::from_fn(4, 2, |i| traylib_math::Rgb::splat(0.1 * i as f32));
    crate::write_picture(&folder.path("sky.exr"), &light, 1.0, &[]).unwrap();
    let sky = "sky: Picture(file: \"sky.exr\", scale: 2, turn: 33.3)";
    let [picture, again] = folder.both(&format!("({CAMERA} {ball} {sky})"));
    let sky = picture.sky.unwrap();
    assert_eq!(sky.radiance.pixels().get(3, 1).g, 1.4);
    assert_eq!(Some(sky), again.sky);
}

#[test]
fn every_shape_material_and_light_reads_back_as_it_was() {
    let text = format!(
        r#"({CAMERA} exposure: 0.3, spp: 7,
        materials: {{
            "a \"b\"": Phong(diffuse: (0.1, 0.2, 0.3), specular: (0.3, 0.3, 0.3), exponent: 12.5),
            "metal": MaxPhong(specular: (0.9, 0.8, 0.7), exponent: 1e5),
            "mirror": Mirror(reflectance: (0.5, 0.5, 0.5), diffuse: (0.1, 0.1, 0.1)),
            "sheet": Sheet(transmission: (diffuse: (0.2, 0.2, 0.2), exponent: 20)),
            "glass": Glass(index: 1.5),
            "pane": Pane(reflectance: (0.1, 0.1, 0.1), through: (0.8, 0.8, 0.7)),
            "gauze": Gauze(base: Lambert(reflectance: (0.3, 0.3, 0.3)), through: (0.5, 0.6, 0.7)),
            "lamp": Lambert(reflectance: (0, 0, 0)),
        }},
        objects: [
            (shape: Quad(corner: (-1, 0, 0), edge_u: (1, 0.1, 0), edge_v: (0, 1, 0.3)), material: "gauze"),
            (shape: Triangle(a: (0, 0, 0), b: (1, 0, 0), c: (0, 0.7, 0)), material: "metal", sides: Front),
            (shape: Disk(center: (1, 2, 3.5), normal: (1, 2, 3), radius: 2, inner: 0.5), material: "mirror"),
            (shape: Disk(center: (1, 2, 3), normal: (0.3, -0.2, 0.7), radius: 2), material: "sheet"),
            (shape: Sphere(center: (0, 5, 0), radius: 0.3, facing: Inward), material: "glass"),
            (shape: Cone(ends: ((0, 0, 0), (1, 1, 1)), radii: (0.5, 0.25), facing: Inward), material: "pane"),
            (shape: Box(min: (7, 7, 7), max: (8, 8, 9)), material: "a \"b\""),
            (shape: Sphere(center: (0, 9, 0), radius: 0.1), material: "lamp", emission: (4, 5, 6.1)),
        ],
        lights: [
            Point(position: (0, 2, 0.1), intensity: (1, 2, 3)),
            Spot(position: (0.3, 2, 0.1), target: (0.7, -0.3, 0.2), intensity: (1, 2, 3), full: 33.3, dark: 55.1),
        ])"#
    );
    let [a, b] = Folder::new("all").both(&text);
    assert_eq!((a.objects.len(), compare::differences(&a, &b)), (13, 0));
    let names = |parts: &SceneParts| -> Vec<String> {
        parts.materials.iter().map(|(name, _)| name.clone()).collect()
    };
    assert_eq!(names(&a), names(&b));
}

#[test]
fn pictures_and_meshes_stand_beside_and_read_back() {
    let folder = Folder::new("beside");
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");
    for name in ["models/trimesh.obj", "models/trimesh.mtl", "mitsuba/quarters.png"] {
        fs::copy(format!("{data}/{name}"), folder.path(name.rsplit('/').next().unwrap())).unwrap();
    }
    let text = format!(
        r#"({CAMERA} materials: {{ "a": Textured(base: Phong(diffuse: (0.5, 0.5, 0.5), specular: (0.1, 0.1, 0.1), exponent: 9),
            diffuse: (file: "quarters.png", matrix: (2, 0.1, 0, -1, 0.5, 1), tiling: Mirror, strength: 0.5),
            opacity: (file: "quarters.png", scale: (3, 2)), bump: (file: "quarters.png", height: 0.1)) }},
        objects: [(shape: Mesh(file: "trimesh.obj", rotate: (10, 20, 30)), material: "a"),
            (shape: Quad(corner: (-1, 0, 0), edge_u: (1, 0, 0), edge_v: (0, 1, 0)), material: "a", emission: (1, 1, 1))])"#
    );
    let [a, b] = folder.both(&text);
    assert_eq!(compare::differences(&a, &b), 0);
    let mut names: Vec<String> = fs::read_dir(folder.path("b-files"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    // Colours and opacity are other numbers of one picture.
    assert_eq!(names, ["mesh-1.ply", "picture-1.exr", "picture-2.exr"]);
    assert!(matches!(folder.convert("a.ron", "b.ron"), Err(Error::Exists(_))));
    // No more is left than was there.
    assert_eq!(fs::read_dir(&folder.0).unwrap().count(), 6);
}

#[test]
fn materials_of_one_name_get_numbers() {
    let grey = "newmtl x\nKd .5 .5 .5\n";
    let folder = Folder::new("names");
    fs::write(folder.path("a.mtl"), grey).unwrap();
    fs::write(folder.path("a.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl x\nf 1 2 3\n")
        .unwrap();
    fs::write(folder.path("c.obj"), "mtllib a.mtl\nv 0 0 1\nv 1 0 1\nv 0 1 1\nusemtl x\nf 1 2 3\n")
        .unwrap();
    let text = format!(
        "({CAMERA} objects: [(shape: Mesh(file: \"a.obj\")), (shape: Mesh(file: \"c.obj\"))], lights: [Point(position: (0, 2, 0), intensity: (1, 1, 1))])"
    );
    let [a, b] = folder.both(&text);
    assert_eq!(compare::differences(&a, &b), 0);
    let names: Vec<&str> = b.materials.iter().take(4).map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["x", "material", "x 2", "material 2"]);
}
