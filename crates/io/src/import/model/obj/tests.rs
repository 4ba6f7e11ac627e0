//! The scenes that OBJ files become, held against what the files mean.

use super::super::{Format, ModelFile};
use super::*;
use crate::import::model_part::{ModelPart, ModelSide};
use crate::import::placement::Placement;
use std::fs;
use std::path::PathBuf;
use traylib_geometry::{Mesh, Sides, Vec3};
use traylib_materials::{SurfaceModel, Tiling};
use traylib_math::{Grid, Rgb, Vec2};
use traylib_scene::ObjectShape;

/// A folder of a test, gone with the value.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str, files: &[(&str, &str)]) -> Self {
        let folder =
            std::env::temp_dir().join(format!("traylib-obj-{}-{test}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        for (name, text) in files {
            fs::write(folder.join(name), text).unwrap();
        }
        Self(folder)
    }

    fn read(&self) -> Result<(ModelFile, Vec<String>), Error> {
        let location = Location::Disk(self.0.join("a.obj"));
        let mut counter = Counter::default();
        let (file, warnings) = super::read(&location, LoadOptions::default(), &mut counter)?;
        let warnings = warnings.into_iter().chain(counter.into_warnings("a.obj"));
        Ok((file, warnings.map(|warning| warning.to_string()).collect()))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn parts(file: &ModelFile) -> Vec<ModelPart> {
    file.parts(&Placement::NONE, &mut Counter::default()).unwrap()
}

fn mesh(part: &ModelPart) -> &Mesh {
    let ObjectShape::Mesh(mesh) = &part.shape else { panic!("{part:?}") };
    mesh
}

fn area(mesh: &Mesh) -> f32 {
    (0..mesh.triangle_count()).filter_map(|i| mesh.triangle(i)).map(|t| t.area()).sum()
}

fn read(test: &str, text: &str) -> (ModelFile, Vec<String>) {
    Folder::new(test, &[("a.obj", text)]).read().unwrap()
}

/// An L is cut, whose fan from the first corner would leave the polygon.
#[test]
fn polygons_need_not_be_convex() {
    let text = "v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nf 1 2 3 4 5 6\n";
    let (file, warnings) = read("polygons", text);
    let parts = parts(&file);
    let [part] = &parts[..] else { panic!("{parts:?}") };
    assert_eq!((mesh(part).triangle_count(), area(mesh(part))), (4, 3.0));
    let normals = (0..4).map(|i| mesh(part).triangle(i).unwrap().normal());
    assert!(normals.into_iter().all(|normal| normal == Vec3::Z));
    assert!(mesh(part).normals().is_empty() && warnings.is_empty());
    assert_eq!(file.format, Format::Obj);
}

/// Two squares at a right angle.
const FOLD: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\n";

#[test]
fn smoothing_groups_smooth_what_has_no_normals() {
    let at = |text: &str, wanted: Vec3| {
        let (file, _) = read("smoothing", &format!("{FOLD}{text}"));
        let parts = parts(&file);
        let [part] = &parts[..] else { panic!("{parts:?}") };
        let mesh = mesh(part);
        let edge = mesh.positions().iter().zip(mesh.normals());
        let edge: Vec<Vec3> =
            edge.filter(|(p, _)| p.y == 0.0 && p.z == 0.0).map(|(_, &n)| n).collect();
        (edge.iter().all(|n| n.distance(wanted) < 1e-6), edge.len())
    };
    let middle = Vec3::new(0.0, 1.0, 1.0).normalize();
    // One normal for each end of the edge, which both faces share.
    assert_eq!(at("s 1\nf 1 2 3 4\nf 1 5 6 2\n", middle), (true, 2));
    // Groups apart, or a face of none: normals of each.
    assert_eq!(at("s 1\nf 1 2 3 4\ns 2\nf 1 5 6 2\n", middle).1, 4);
    // Those of the file go before groups.
    assert_eq!(
        at("vn 0 1 1\ns 1\nf 1//1 2//1 3//1 4//1\nf 1//1 5//1 6//1 2//1\n", middle),
        (true, 2)
    );
    let (file, _) = read("flat", &format!("{FOLD}s off\nf 1 2 3 4\nf 1 5 6 2\n"));
    assert!(mesh(&parts(&file)[0]).normals().is_empty());
}

#[test]
fn corners_without_texture_coordinates_take_none_of_others() {
    let text = format!(
        "{FOLD}vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nf 1 2 4\nf 1/1/1 2/2/1 3/3/1\nf 3 4 1/2\n"
    );
    let (file, _) = read("mixed", &text);
    let parts = parts(&file);
    let found: Vec<_> = parts
        .iter()
        .map(|part| {
            (mesh(part).triangle_count(), mesh(part).uvs().len(), mesh(part).normals().len())
        })
        .collect();
    assert_eq!(found, [(2, 0, 0), (1, 3, 3)]);
    assert_eq!(mesh(&parts[1]).uv(0, 0.0, 1.0), Some(Vec2::ONE));
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nmtllib m.mtl\nusemtl m\n\
                        f 1/1 2/2 3/3\n";

fn with_material(test: &str, material: &str) -> (ModelFile, Vec<String>) {
    let library = format!("newmtl m\n{material}");
    let folder = Folder::new(test, &[("a.obj", TRIANGLE), ("m.mtl", &library)]);
    let grey = Grid::filled(2, 2, Rgb::splat(0.25));
    crate::write_picture(&folder.0.join("grey.png"), &grey, 1.0, &[]).unwrap();
    folder.read().unwrap()
}

#[test]
fn materials_become_diffuse_and_phong() {
    let (file, warnings) = with_material("gloss", "Kd 0.5 0.25 0\nKs 0.25 0.25 0.25\nNs 30\n");
    let material = &file.materials[0];
    let SurfaceModel::Phong(phong) = &material.surface.model else { panic!("{material:?}") };
    assert_eq!(phong.diffuse(), Rgb::new(0.5, 0.25, 0.0));
    assert_eq!(phong.specular(), Rgb::splat(0.25));
    assert_eq!(
        *phong,
        traylib_materials::Phong::new(phong.diffuse(), phong.specular(), 30.0).unwrap()
    );
    assert_eq!(
        (material.sides, material.emission, material.name.as_str()),
        (Sides::Both, Rgb::BLACK, "m")
    );
    assert!(warnings.is_empty(), "{warnings:?}");
    let (file, _) = with_material("matt", "Kd 0.5 0.25 0\nKs 1 1 1\nillum 1\n");
    assert!(matches!(file.materials[0].surface.model, SurfaceModel::Lambert(_)));
    let (file, warnings) = with_material("bright", "Kd 1 1 1\nKs 1 1 1\nNs 1e9\nKd 1.5 1 1\n");
    let SurfaceModel::Phong(phong) = &file.materials[0].surface.model else { panic!() };
    assert_eq!(phong.diffuse(), Rgb::splat(0.5));
    assert_eq!(warnings.len(), 2, "{warnings:?}");
}

#[test]
fn what_shines_does_so_from_both_sides_of_what_is_open() {
    let (file, _) = with_material("lamp", "Ke 2 1 0.5\n");
    let parts = parts(&file);
    let sides: Vec<_> = parts.iter().map(|part| part.side).collect();
    assert_eq!(sides, [ModelSide::Back, ModelSide::Front]);
    let normals = [0, 1].map(|i| mesh(&parts[i]).triangle(0).unwrap().normal());
    assert_eq!(normals, [Vec3::NEG_Z, Vec3::Z]);
    assert_eq!(file.materials[0].emission, Rgb::new(2.0, 1.0, 0.5));
    let (file, warnings) = with_material("screen", "Ke 1 1 1\nmap_Ke grey.png\n");
    assert!(file.materials[0].emission.is_black() && warnings.len() == 1);
}

#[test]
fn opacity_is_dissolve_and_what_transparency_leaves() {
    for (material, through) in
        [("d 0.25", 0.75), ("Tr 0.25", 0.25), ("d 0.5\nTr 0.5", 0.5), ("", 0.0), ("Tr 1", 0.0)]
    {
        let (file, warnings) = with_material("clear", &format!("Kd 0.5 0.5 0.5\n{material}\n"));
        let surface = &file.materials[0].surface;
        assert_eq!(surface.through, Rgb::splat(through), "{material}");
        assert_eq!(warnings.len(), usize::from(material == "Tr 1"), "{warnings:?}");
        let SurfaceModel::Lambert(lambert) = &surface.model else { panic!() };
        let whole = traylib_materials::Lambert::new(Rgb::splat(0.5 * (1.0 - through))).unwrap();
        assert_eq!(*lambert, whole);
    }
}

#[test]
fn pictures_are_times_their_colours() {
    let text = "Kd 1 0.5 0\nmap_Kd -s 2 4 1 -o 0.5 0.25 -clamp on GREY.PNG\nd 0.5\nmap_d grey.png\nbump grey.png\n";
    let (file, warnings) = with_material("pictures", text);
    assert!(warnings.is_empty(), "{warnings:?}");
    let maps = file.materials[0].surface.maps.as_ref().unwrap();
    let diffuse = maps.diffuse.as_ref().unwrap();
    let shown = diffuse.texture.lookup(Vec2::splat(0.5), Tiling::Repeat).unwrap();
    // 137/255 is stored for a quarter.
    assert!(
        (shown.r - 0.25).abs() < 2e-3 && shown.g == 0.5 * shown.r && shown.b == 0.0,
        "{shown:?}"
    );
    assert_eq!(diffuse.tiling, Tiling::Once);
    let placed = diffuse.placement.transform_point2(Vec2::new(1.0, 1.0));
    assert_eq!(placed, Vec2::new(2.5, 4.25));
    let opacity =
        maps.opacity.as_ref().unwrap().texture.lookup(Vec2::ZERO, Tiling::Repeat).unwrap();
    assert!((opacity.r - 0.5 * 137.0 / 255.0).abs() < 1e-6, "{opacity:?}");
    assert_eq!(maps.bump.as_ref().unwrap().height, 0.01);
}

#[test]
fn what_is_not_there_is_told_once() {
    let (_, warnings) = read("lost", &TRIANGLE.replace("m.mtl", "no where.mtl"));
    let wanted = [
        "a.obj: material library `no where.mtl` not found",
        "a.obj: material `m` not found, shown grey",
    ];
    assert_eq!(warnings, wanted);
    let (_, warnings) = with_material("picture", "map_Kd ../grey.gif\nmap_Ns x.png\n");
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    let (_, warnings) = with_material("none", "map_Kd ../other.gif\n");
    assert_eq!(warnings.len(), 1, "{warnings:?}");
    assert!(warnings[0].contains("`../other.gif` not found") && warnings[0].contains("`--root`"));
    let (_, warnings) = with_material("none", "map_Kd other.gif\n");
    assert_eq!(warnings, ["a.obj: picture `other.gif` not found, shown without"]);
}

#[test]
fn several_libraries_stand_in_a_line() {
    let text = TRIANGLE.replace("m.mtl", "b.mtl m.mtl b.mtl");
    let files = [
        ("a.obj", text.as_str()),
        ("m.mtl", "newmtl m\nKd 1 1 1\n"),
        ("b.mtl", "newmtl m\nKd 0 0 0"),
    ];
    let (file, warnings) = Folder::new("several", &files).read().unwrap();
    assert!(warnings.is_empty());
    // The first of a name.
    let black = traylib_materials::Lambert::new(Rgb::BLACK).unwrap();
    assert_eq!(file.materials[0].surface.model, SurfaceModel::Lambert(black));
}

#[test]
fn faults_name_the_file_in_which_they_are() {
    let files = [("a.obj", TRIANGLE), ("m.mtl", "newmtl m\nKd 1 1 ?\n")];
    let error = Folder::new("faulty", &files).read().map(|_| ()).unwrap_err().to_string();
    assert!(error.ends_with("m.mtl: line 2: `?` is no number"), "{error}");
    let error = Folder::new("empty", &[("a.obj", "v 0 0 0\n")]).read().map(|_| ()).unwrap_err();
    assert!(matches!(error, Error::NothingToSee(_)));
}
