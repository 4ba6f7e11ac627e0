//! Published scenes against what Radiance's parser makes of them. They are not
//! part of the project: the folder with `mgf/expected.json` is named by the
//! environment variable `TRAYLIB_DATA`.

use super::*;
use crate::mgf::shape::newell;
use serde_json::Value;
use traylib_math::glam::{DMat3, DVec3};

fn data() -> Option<(PathBuf, Value)> {
    let Some(folder) = std::env::var_os("TRAYLIB_DATA") else {
        println!("skipped: TRAYLIB_DATA names no folder of test scenes");
        return None;
    };
    let folder = Path::new(&folder).join("mgf");
    let text = fs::read_to_string(folder.join("expected.json")).unwrap();
    Some((folder, serde_json::from_str(&text).unwrap()))
}

fn options(root: &Path) -> Options {
    Options { root: Some(root.to_path_buf()), ..Options::default() }
}

#[test]
fn every_scene_has_the_surfaces_that_radiance_finds() {
    let Some((folder, expected)) = data() else { return };
    let scenes = expected["scenes"].as_array().unwrap();
    assert_eq!(scenes.len(), 73);
    let mut wrong = Vec::new();
    for scene in scenes {
        let names: Vec<&str> =
            scene["files"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
        let files: Vec<PathBuf> = names.iter().map(|name| folder.join(name)).collect();
        let differences = match (decode(&files, &options(&folder)), &scene["parser_stopped_with"]) {
            (Ok(document), Value::Null) => compare(&document, scene),
            (Err(error), stop @ Value::Object(_)) => compare_error(&error, stop),
            (Ok(_), _) => vec!["was read".to_string()],
            (Err(error), _) => vec![error.to_string()],
        };
        wrong.extend(differences.into_iter().map(|what| format!("{names:?}: {what}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The defaults leave real scenes room.
#[test]
fn no_scene_needs_more_than_five_sixths_of_a_bound() {
    let Some((folder, expected)) = data() else { return };
    let most = options(&folder);
    let less = Options {
        max_depth: most.max_depth / 2,
        max_transforms: most.max_transforms / 2,
        max_surfaces: most.max_surfaces / 2,
        max_corners: most.max_corners / 2,
        max_cutting: most.max_cutting / 2,
        max_line: most.max_line / 2,
        max_bytes: most.max_bytes / 2,
        max_work: most.max_work / 6 * 5,
        max_memory: most.max_memory / 2,
        root: most.root,
    };
    for scene in expected["scenes"].as_array().unwrap() {
        let names = scene["files"].as_array().unwrap().iter().filter_map(Value::as_str);
        let files: Vec<PathBuf> = names.map(|name| folder.join(name)).collect();
        let limit =
            |error: &Error| matches!(error, Error::Entity { cause: Cause::Limit { .. }, .. });
        let exceeded = decode(&files, &less).err().filter(limit);
        assert!(exceeded.is_none(), "{files:?}: {exceeded:?}");
    }
}

fn compare(document: &Document, scene: &Value) -> Vec<String> {
    let mut wrong = Vec::new();
    let found = serde_json::to_value(&document.counts).unwrap();
    for (key, expected) in scene["expanded"].as_object().unwrap() {
        if found[key] != *expected {
            wrong.push(format!("{key} is {}, not {expected}", found[key]));
        }
    }
    if let Some(expected) = scene["tessellated_5_divisions_per_quarter_circle"].as_object() {
        let cut = Cut::of(document);
        let numbers = [
            ("faces", cut.faces),
            ("triangles", cut.triangles),
            ("emitting_faces", cut.emitting_faces),
            ("area_m2", cut.area),
            ("emitting_area_m2", cut.emitting_area),
            ("flux_one_side_lm", cut.flux),
        ];
        for (key, found) in numbers {
            let expected = expected[key].as_f64().unwrap();
            if (found - expected).abs() > 1e-6 * expected.abs() {
                wrong.push(format!("{key} is {found}, not {expected}"));
            }
        }
        // Not every polygon is flat.
        if (cut.area_of_triangles - cut.area).abs() > 1e-5 * cut.area {
            wrong.push(format!("triangles of {}, polygons of {}", cut.area_of_triangles, cut.area));
        }
        if cut.faces > 0.0 {
            wrong.extend(compare_box(&cut, &expected["bbox"]));
        }
    }
    wrong
}

fn compare_box(cut: &Cut, expected: &Value) -> Option<String> {
    let expected: Vec<f64> =
        expected.as_array().unwrap().iter().map(|value| value.as_f64().unwrap()).collect();
    let found = [cut.low.to_array(), cut.high.to_array()].concat();
    let size = (cut.high - cut.low).max_element();
    let near = found.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= 1e-5 * size);
    (!near).then(|| format!("box is {found:?}, not {expected:?}"))
}

/// The sums over all shapes, cut up.
struct Cut {
    faces: f64,
    triangles: f64,
    emitting_faces: f64,
    area: f64,
    area_of_triangles: f64,
    emitting_area: f64,
    flux: f64,
    low: DVec3,
    high: DVec3,
}

impl Cut {
    fn of(document: &Document) -> Self {
        let mut cut = Self {
            faces: 0.0,
            triangles: 0.0,
            emitting_faces: 0.0,
            area: 0.0,
            area_of_triangles: 0.0,
            emitting_area: 0.0,
            flux: 0.0,
            low: DVec3::INFINITY,
            high: DVec3::NEG_INFINITY,
        };
        for surface in &document.surfaces {
            let material = &document.materials[surface.material];
            let divisions = tessellate::DEFAULT_DIVISIONS;
            for polygon in tessellate::polygons(&surface.shape, divisions) {
                cut.add(&polygon, f64::from(material.ed.amount));
            }
            for triangle in tessellate::triangles(&surface.shape, divisions) {
                cut.area_of_triangles += newell(&triangle).length() / 2.0;
            }
        }
        cut
    }

    fn add(&mut self, polygon: &[Vertex], emittance: f64) {
        let area = newell(polygon).length() / 2.0;
        self.faces += 1.0;
        self.triangles += polygon.len() as f64 - 2.0;
        self.area += area;
        if emittance > 0.0 {
            self.emitting_faces += 1.0;
            self.emitting_area += area;
            self.flux += area * emittance;
        }
        for vertex in polygon {
            self.low = self.low.min(vertex.position);
            self.high = self.high.max(vertex.position);
        }
    }
}

fn compare_error(error: &Error, stop: &Value) -> Vec<String> {
    let expected = stop["where"].as_str().unwrap();
    let Error::Entity { place, cause: Cause::Undefined { .. }, .. } = error else {
        return vec![format!("{error}, not {expected}")];
    };
    let name = place.file.file_name().unwrap().to_string_lossy();
    let found = format!("{name}: {}: Undefined reference", place.line);
    if expected.starts_with(&found) { vec![] } else { vec![format!("{found}, not {expected}")] }
}

#[test]
fn spectra_have_their_published_chromaticities() {
    let Some((folder, expected)) = data() else { return };
    let mut compared = 0;
    for (file, colours) in expected["colours"].as_object().unwrap() {
        let use_one = |name: &String| format!("m\nc {name}\nrd 1\nsph a 1\n");
        let uses: String = colours.as_object().unwrap().keys().map(use_one).collect();
        let text = format!("v a =\n{uses}");
        let use_them = Folder::new(&[("a.mgf", &text)]);
        let files = [folder.join(file), use_them.0.join("a.mgf")];
        let document = decode(&files, &options(&folder)).unwrap();
        let materials = document.surfaces.iter().map(|s| &document.materials[s.material]);
        for ((name, expected), material) in colours.as_object().unwrap().iter().zip(materials) {
            compared += u32::from(compare_colour(name, expected, material));
        }
    }
    assert!(compared >= 70, "only {compared} colours can be shown");
}

/// Back from the bands to x and y; not for colours that the primaries cannot show.
fn compare_colour(name: &str, expected: &Value, material: &Material) -> bool {
    let to_bands = DMat3::from_cols_array_2d(&[
        [3.146_658, -0.995_522, 0.063_595],
        [-1.666_464, 1.955_757, -0.214_563],
        [-0.480_194, 0.039_765, 1.150_968],
    ]);
    let bands = material.rd.colour.to_array().map(f64::from);
    if bands.iter().any(|&band| band <= 0.0) {
        return false;
    }
    let xyz = to_bands.inverse() * DVec3::from(bands);
    let found = [xyz.x, xyz.y].map(|part| part / xyz.element_sum());
    for (axis, found) in found.into_iter().enumerate() {
        let expected = expected["xy"][axis].as_f64().unwrap();
        assert!((found - expected).abs() < 0.002, "{name}: {found}, not {expected}");
    }
    true
}
