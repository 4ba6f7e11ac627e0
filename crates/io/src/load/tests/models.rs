//! 3DS and MGF files as scenes, and in scenes.

use super::*;
use crate::{Headlight, Limit, ReadLimits};
use traylib_math::Rgb;
use traylib_scene::Light;

const CUBE_FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/models/cube.3ds");
/// A lamp of two sides, a ball and a floor.
const ROOM: &str = "m lamp =\n ed 562.345\nv a =\n p 0 0 2\nv b =\n p 1 0 2\nv c =\n p 1 1 2\n\
                    v d =\n p 0 1 2\nf a b c d\nm grey =\n rd .5\nsph a .25\n\
                    v o =\n p 0 0 0\n n 0 0 1\nring o 0 3\n";

fn load_mgf(test: &str, text: &str, options: LoadOptions<'_>) -> Result<Loaded, Error> {
    let path = std::env::temp_dir().join(format!("traylib-{}-{test}.MGF", std::process::id()));
    fs::write(&path, text).unwrap();
    let loaded = load_scene_with(&path.to_string_lossy(), options);
    fs::remove_file(&path).unwrap();
    loaded
}

fn radiance(loaded: &Loaded) -> Vec<f32> {
    let area = |light: &Light| match light {
        Light::Area { radiance, .. } => Some(radiance.g),
        Light::Point(_) | Light::Sky(_) => None,
    };
    loaded.scene.lights().iter().filter_map(area).collect()
}

#[test]
fn an_mgf_file_is_a_scene_with_a_camera_of_ours() {
    let options = LoadOptions { resolution: Some((40, 20)), ..LoadOptions::default() };
    let loaded = load_mgf("whole", ROOM, options).unwrap();
    // Both sides of the lamp's two triangles, a sphere and a disk.
    assert_eq!((loaded.scene.primitive_count(), loaded.scene.lights().len()), (6, 4));
    assert_eq!((loaded.scene.camera().width(), loaded.scene.camera().height()), (40, 20));
    // 562.345/(179π) = 1.
    assert!(radiance(&loaded).iter().all(|l| (l - 1.0).abs() < 1e-5));
    let [camera, exposure] = &loaded.notes[..] else { panic!("{:?}", loaded.notes) };
    assert!(camera.contains("up: (0, 0, 1), fov: 40, resolution: (40, 20))"), "{camera}");
    // Of π W/m² on 2 m², over a box of 6 · 6 · 2 + 4 · 6 · 2.25 m²: ¼·126/2 = 15.75.
    assert_eq!(
        (exposure.as_str(), loaded.settings.exposure),
        ("no exposure in the file, taken: --exposure 16, in a scene file exposure: 16", 16.0)
    );
}

#[test]
fn an_exposure_that_is_given_is_taken_without_a_word() {
    let options = LoadOptions { exposure: Some(3.0), ..LoadOptions::default() };
    let loaded = load_mgf("exposed", ROOM, options).unwrap();
    assert_eq!(loaded.settings.exposure, 3.0);
    assert!(loaded.notes.iter().all(|note| !note.contains("exposure")), "{:?}", loaded.notes);
}

#[test]
fn the_camera_that_is_told_of_is_that_of_a_scene_file() {
    let loaded = load_mgf("told", ROOM, LoadOptions::default()).unwrap();
    let camera = loaded.notes[0].split_once("taken: ").unwrap().1;
    let text = format!("({camera}, objects: [(shape: Mesh(file: \"room.mgf\"))])");
    let again = load_text("again", &text, &[("room.mgf", ROOM.as_bytes())]).unwrap();
    assert_eq!(again.scene.camera(), loaded.scene.camera());
    assert_eq!(again.scene.primitive_count(), loaded.scene.primitive_count());
    assert_eq!(radiance(&again), radiance(&loaded));
}

#[test]
fn a_file_without_a_lamp_is_refused_or_lit_from_the_camera() {
    let dark = load_scene(CUBE_FILE).unwrap_err();
    assert!(matches!(dark, Error::Unlit(_)), "{dark:?}");
    let text = dark.to_string();
    assert!(text.contains("nothing in it emits light") && text.contains("Mesh(file: "), "{text}");
    let options = LoadOptions { headlight: Headlight::WithoutLight, ..LoadOptions::default() };
    let lit = load_scene_with(CUBE_FILE, options).unwrap();
    assert!(matches!(lit.scene.lights(), [Light::Point(_)]));
    assert_eq!(lit.warnings.len(), 1);
    assert_eq!(lit.settings.exposure, 1.0);
}

/// The light at the camera shows surfaces as they are, so that nothing is to be exposed
/// for; small objects that glow do not take its place where lamps with an area do not count.
#[test]
fn what_glows_a_little_is_lit_from_the_camera_where_only_points_count() {
    let dark = "v c =\n p 0 0 1\nm grey =\n rd .5\nsph c 1\n";
    let eye = format!("{dark}m eye =\n ed 1\nv e =\n p 0 1 1\nsph e .1\n");
    let exposure = |loaded: &Loaded| loaded.settings.exposure;
    let points = |loaded: &Loaded| loaded.scene.lights().iter().filter(|l| l.is_point()).count();
    for (text, headlight, wanted) in [
        (dark, Headlight::WithoutLight, 1),
        (dark, Headlight::WithoutPointLight, 1),
        (&eye, Headlight::Never, 0),
        (&eye, Headlight::WithoutLight, 0),
        (&eye, Headlight::WithoutPointLight, 1),
    ] {
        let options = LoadOptions { headlight, ..LoadOptions::default() };
        let loaded = load_mgf("eye", text, options).unwrap();
        assert_eq!(points(&loaded), wanted, "{headlight:?}");
        assert_eq!(exposure(&loaded) == 1.0, wanted == 1, "{headlight:?}");
        assert_eq!(loaded.warnings.len(), wanted, "{:?}", loaded.warnings);
    }
}

/// A chunk of a 3DS file around some bytes.
fn chunk(id: u16, body: &[u8]) -> Vec<u8> {
    let length = u32::try_from(body.len() + 6).unwrap();
    [&id.to_le_bytes()[..], &length.to_le_bytes(), body].concat()
}

/// A 3DS file: a square floor of 2 by 2 around the origin, and an omni light above.
fn lit_floor(height: f32, multiplier: f32) -> Vec<u8> {
    let floats =
        |values: &[f32]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<_>>();
    let words =
        |values: &[u16]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<_>>();
    let corners = [-1.0, -1.0, 0.0, 1.0, -1.0, 0.0, 1.0, 1.0, 0.0, -1.0, 1.0, 0.0];
    let vertices = chunk(0x4110, &[words(&[4]), floats(&corners)].concat());
    let faces = chunk(0x4120, &words(&[2, 0, 1, 2, 7, 0, 2, 3, 7]));
    let mesh =
        chunk(0x4000, &[&b"floor\0"[..], &chunk(0x4100, &[vertices, faces].concat())].concat());
    let omni = [floats(&[0.0, 0.0, height]), chunk(0x465b, &floats(&[multiplier]))].concat();
    let light = chunk(0x4000, &[&b"omni\0"[..], &chunk(0x4600, &omni)].concat());
    chunk(0x4d4d, &chunk(0x3d3d, &[mesh, light].concat()))
}

/// However strong its lights are, a 3DS file is shown the same, and it is said how.
#[test]
fn the_exposure_of_a_3ds_file_is_metered() {
    let load = |height: f32, multiplier: f32| {
        let path = std::env::temp_dir().join(format!("traylib-{}-lit.3ds", std::process::id()));
        fs::write(&path, lit_floor(height, multiplier)).unwrap();
        let loaded = load_scene(&path.to_string_lossy());
        fs::remove_file(&path).unwrap();
        loaded.unwrap()
    };
    // White shows 1 below the light and less around it, by the third power of the cosine.
    // Over the floor the mean is ∫∫ h³/(x² + y² + h²)^1.5 dx dy / 4 = 0.81 for h = 2; in the
    // picture near parts are larger.
    let [weak, usual, strong] = [1e-3, 1.0, 1e3].map(|multiplier| load(2.0, multiplier));
    let exposure = usual.settings.exposure;
    assert!((exposure - 0.5 / 0.81).abs() < 0.03, "{exposure}");
    assert!((weak.settings.exposure * 1e-3 - exposure).abs() < 1e-5, "{:?}", weak.settings);
    assert!((strong.settings.exposure * 1e3 - exposure).abs() < 1e-5, "{:?}", strong.settings);
    let note = format!("no exposure in the file, taken: --exposure {exposure}, in a scene file");
    assert!(usual.notes.iter().any(|said| said.starts_with(&note)), "{:?}", usual.notes);
    // Near the floor it is a small spot that is clipped: the rest is shown.
    let near = load(0.1, 1.0).settings.exposure;
    assert!(near > 2.0, "{near}");
}

#[test]
fn files_that_make_no_scene_say_why() {
    let fault = |test: &str, text: &str| {
        load_mgf(test, text, LoadOptions::default()).unwrap_err().to_string()
    };
    assert!(fault("none", "m x =\n rd .5\n").ends_with("it has no face that can be drawn"));
    assert!(fault("name", "\nsph nowhere 1\n").contains(":2: sph: no vertex is named `nowhere`"));
    assert!(fault("file", "i none.mgf\n").contains("none.mgf"));
    let path = std::env::temp_dir().join(format!("traylib-{}-x.3ds", std::process::id()));
    fs::write(&path, "text").unwrap();
    let error = load_scene(&path.to_string_lossy()).unwrap_err();
    fs::remove_file(&path).unwrap();
    assert!(matches!(error, Error::Format { .. }), "{error:?}");
}

/// A limit that a file exceeds is named as programs know it, and can be raised, also where
/// a scene file brings the file in.
#[test]
fn limits_can_be_raised_by_the_names_that_messages_tell() {
    let limits = |limit, value| {
        let mut limits = ReadLimits::default();
        limits.set(limit, value);
        LoadOptions { limits, ..LoadOptions::default() }
    };
    // A lamp, a ball and a ring.
    let error = load_mgf("few", ROOM, limits(Limit::Surfaces, 2)).unwrap_err().to_string();
    let remedy = "more than 2 surfaces; if that is meant, `--limit surfaces=4` allows more";
    assert!(error.contains(remedy), "{error}");
    assert!(load_mgf("enough", ROOM, limits(Limit::Surfaces, 4)).is_ok());

    let picture = include_bytes!("../../../../../scenes/textures/waves.png");
    let others: [(&str, &[u8]); 2] = [("room.mgf", ROOM.as_bytes()), ("p.png", picture)];
    let text = lit(
        r#"materials: { "a": Textured(base: Lambert(reflectance: (0, 0, 0)), diffuse: "p.png") },
           objects: [(shape: Mesh(file: "room.mgf")), (shape: Mesh(file: "room.mgf"), material: "a")],"#,
    );
    let load = |limit, value| load_text_with("limits", &text, &others, limits(limit, value));
    for (limit, few, more) in [
        (Limit::Surfaces, 2, "surfaces=4"),
        (Limit::Bytes, 20, "bytes=40"),
        (Limit::Pixels, 10, "pixels=20"),
    ] {
        let error = load(limit, few).unwrap_err().to_string();
        assert!(error.contains(&format!("`--limit {more}` allows more")), "{error}");
        assert!(load(limit, 1 << 40).is_ok(), "{limit:?}");
    }
}

#[test]
fn includes_stay_in_the_folder_unless_allowed() {
    let folder = std::env::temp_dir().join(format!("traylib-{}-root", std::process::id()));
    fs::create_dir_all(folder.join("in")).unwrap();
    fs::write(folder.join("out.mgf"), ROOM).unwrap();
    fs::write(folder.join("in/a.mgf"), "i ../out.mgf\n").unwrap();
    let file = folder.join("in/a.mgf").to_string_lossy().into_owned();
    let kept_in = load_scene(&file);
    let allowed = LoadOptions { root: Some(&folder), ..LoadOptions::default() };
    let let_out = load_scene_with(&file, allowed);
    fs::remove_dir_all(&folder).unwrap();
    assert!(matches!(kept_in, Err(Error::Mgf(_))));
    assert_eq!(let_out.unwrap().scene.primitive_count(), 6);
}

/// What a scene file makes of the room, with an object's further fields.
fn with(test: &str, in_mesh: &str, in_object: &str) -> Loaded {
    let text = lit(&format!(
        "materials: {{ \"red\": Lambert(reflectance: (0.5, 0, 0)) }},
         objects: [(shape: Mesh(file: \"room.mgf\", {in_mesh}), {in_object})],"
    ));
    load_text(test, &text, &[("room.mgf", ROOM.as_bytes())]).unwrap()
}

#[test]
fn a_scene_file_has_the_last_word() {
    let count = |loaded: &Loaded| (loaded.scene.primitive_count(), radiance(loaded));
    assert_eq!(count(&with("glow", "glow: 0", "")), (6, Vec::new()));
    assert_eq!(count(&with("double", "scale: 2, glow: 2", "")).1.len(), 4);
    assert_eq!(radiance(&with("emission", "", "emission: (3, 3, 3)")), [3.0; 6]);
    // Only the fronts, so not the lamp's back.
    let fronts = with("front", "", "sides: Front");
    assert_eq!((fronts.scene.primitive_count(), radiance(&fronts).len()), (4, 2));
    let red = with("red", "materials: {\"grey\": \"red\"}", "");
    assert_eq!(count(&red).1.len(), 4);
    let seen = red.scene.intersect(&traylib_geometry::Ray::new(
        traylib_math::Vec3::new(2.5, 0.0, 1.0),
        traylib_math::Vec3::NEG_Z,
    ));
    let traylib_materials::SurfaceModel::Lambert(lambert) = seen.unwrap().model else { panic!() };
    assert_eq!(lambert.reflectance(), Rgb::new(0.5, 0.0, 0.0));
}

#[test]
fn materials_that_a_file_has_not_are_refused_with_those_it_has() {
    let text = lit(r#"materials: { "red": Lambert(reflectance: (0.5, 0, 0)) },
        objects: [(shape: Mesh(file: "room.mgf", glow: -1, materials: {"gray": "red", "lamp": "rod"}))],"#);
    let shown = report("names", &text, &[("room.mgf", ROOM.as_bytes())]);
    for part in [
        "the file has no material named `gray`",
        "did you mean `grey`?",
        "its materials are `lamp`, `grey`",
        "no material is named `rod`",
        "the factor must be finite and not negative",
    ] {
        assert!(shown.contains(part), "missing: {part}\nin:\n{shown}");
    }
}

#[test]
fn materials_with_pictures_and_glass_are_understood() {
    let picture = include_bytes!("../../../../../scenes/textures/waves.png");
    let text = lit(r#"materials: {
        "a": Textured(base: Phong(diffuse: (0.5, 0.5, 0.5), specular: (0, 0, 0), exponent: 9),
            diffuse: "p.png", specular: (file: "p.png", tiling: Once, strength: 0.5),
            opacity: "p.png", bump: (file: "p.png", height: 0.1, scale: (2, 3), tiling: Mirror)),
        "b": Sheet(transmission: (diffuse: (0.5, 0.5, 0.5))),
        "c": Glass(index: 1.5), "d": Pane(reflectance: (0.5, 0, 0), through: (0.5, 1, 1)) },"#);
    let loaded = load_text("pictures", &text, &[("p.png", picture)]).unwrap();
    let maps = loaded.scene.materials()[0].maps.as_ref().unwrap();
    let specular = maps.specular.as_ref().unwrap();
    assert_eq!((specular.tiling, specular.strength), (traylib_materials::Tiling::Once, 0.5));
    assert_eq!(maps.bump.as_ref().unwrap().height, 0.1);
    assert_eq!(loaded.scene.materials()[3].through, Rgb::new(0.5, 1.0, 1.0));
    let faulty = text
        .replace("p.png", "q.png")
        .replace("index: 1.5", "index: 1")
        .replace("0.5, 1, 1)", "0.6, 1, 1)")
        .replace("strength: 0.5", "strength: 2");
    let shown = report("faulty", &faulty, &[]);
    for part in [
        "q.png: cannot be read",
        "the strength must be from 0 to 1",
        "index 1 must lie between 0.1 and 10 and not be 1",
        "`reflectance` and `through` must be from 0 to 1, also their sum",
    ] {
        assert!(shown.contains(part), "missing: {part}\nin:\n{shown}");
    }
    let unknown = report("unknown", &text.replace("tiling: Once", "tilling: Once"), &[]);
    assert!(unknown.contains("did you mean `tiling`?"), "{unknown}");
    let glassy = text.replace(
        "base: Phong(diffuse: (0.5, 0.5, 0.5), specular: (0, 0, 0), exponent: 9)",
        "base: Glass(index: 2)",
    );
    let shown = report("glassy", &glassy, &[("p.png", picture)]);
    assert!(shown.contains("a picture for `diffuse` wants a Lambert or Phong base"), "{shown}");
}

#[test]
fn spot_lights_have_cones_that_make_sense() {
    let spot = |angles: &str| {
        lit("").replace(
            "Point(position: (0, 9, 0), intensity: (1, 1, 1))",
            &format!(
                "Spot(position: (0, 2, 0), target: (0, 0, 0), intensity: (1, 1, 1), {angles})"
            ),
        )
    };
    let loaded = load_text("spot", &spot("full: 60, dark: 90"), &[]).unwrap();
    let [Light::Point(light)] = loaded.scene.lights() else { panic!() };
    let cone = light.cone.unwrap();
    assert_eq!(cone.axis, traylib_math::Vec3::NEG_Y);
    assert!((cone.cos_full - 0.75_f32.sqrt()).abs() < 1e-6, "{cone:?}");
    for angles in ["full: 60, dark: 30", "full: 0", "full: 400", "full: NaN"] {
        let shown = report("cone", &spot(angles), &[]);
        assert!(shown.contains("the angles must obey"), "{shown}");
    }
}

/// A folder of real files, or why there is none.
fn data() -> Option<PathBuf> {
    let folder = std::env::var_os("TRAYLIB_DATA").map(PathBuf::from);
    if folder.is_none() {
        println!("skipped: TRAYLIB_DATA names no folder of real files");
    }
    folder
}

fn files_in(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files_in(&path, ending, found);
        } else if path.extension().is_some_and(|e| e.eq_ignore_ascii_case(ending)) {
            found.push(path);
        }
    }
    found.sort();
}

/// Every real file is a scene, has no light or nothing to see, or is an MGF file
/// that its own reader refuses.
#[test]
fn real_files_are_scenes_or_say_why_not() {
    let Some(data) = data() else { return };
    let mut files = Vec::new();
    files_in(&data.join("3ds"), "3ds", &mut files);
    files_in(&data.join("mgf"), "mgf", &mut files);
    let mut scenes = 0;
    for file in &files {
        let collection = file.strip_prefix(data.join("mgf")).ok().and_then(|f| f.iter().next());
        let root = collection.map(|name| data.join("mgf").join(name));
        let options = LoadOptions { root: root.as_deref(), ..LoadOptions::default() };
        match load_scene_with(&file.to_string_lossy(), options) {
            Ok(_) => scenes += 1,
            Err(Error::Unlit(_) | Error::NothingToSee(_) | Error::Mgf(_)) => {}
            Err(other) => panic!("{}: {other}", file.display()),
        }
    }
    println!("{} files, {scenes} scenes", files.len());
    assert!(scenes > 30, "{scenes} of {}", files.len());
}
