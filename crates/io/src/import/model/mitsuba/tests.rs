//! The scenes that Mitsuba's files become, held against what the files mean.

use super::*;
use crate::import::model_part::{ModelPart, ModelSide};
use crate::import::placement::Placement;
use std::fs;
use std::path::PathBuf;
use traylib_geometry::{Facing, Primitive, Sides};
use traylib_materials::{Material, SurfaceModel};
use traylib_math::{Rgb, Vec3};
use traylib_scene::ObjectShape;

/// A folder of a test, gone with the value.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str, inner: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("traylib-mi-{}-{test}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("a.xml"), format!("<scene version='3.0.0'>{inner}</scene>")).unwrap();
        Self(folder)
    }

    fn read(&self) -> Result<(ModelFile, Vec<String>), Error> {
        let location = Location::Disk(self.0.join("a.xml"));
        let mut counter = Counter::default();
        let (file, warnings) = super::read(&location, LoadOptions::default(), &mut counter)?;
        let warnings = warnings.into_iter().chain(counter.into_warnings("a.xml"));
        Ok((file, warnings.map(|warning| warning.to_string()).collect()))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn read(test: &str, inner: &str) -> (ModelFile, Vec<String>) {
    Folder::new(test, inner).read().unwrap()
}

fn parts(file: &ModelFile) -> Vec<ModelPart> {
    file.parts(&Placement::NONE, &mut Counter::default()).unwrap()
}

/// The material of a sphere with this BSDF; what is said of it.
fn material(test: &str, bsdf: &str) -> (Material, Vec<String>) {
    let (file, warnings) = read(test, &format!("<shape type='sphere'>{bsdf}</shape>"));
    (file.materials[0].surface.clone(), warnings)
}

fn model(test: &str, bsdf: &str) -> SurfaceModel {
    let (material, warnings) = material(test, bsdf);
    assert!(warnings.is_empty(), "{warnings:?}");
    material.model
}

fn near(a: Rgb, b: [f32; 3]) {
    let off = a.to_array().into_iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(off < 1e-5, "{a:?} {b:?}");
}

#[test]
fn what_is_not_twosided_has_a_black_back() {
    let (file, _) = read("one", "<shape type='sphere'><bsdf type='diffuse' id='x'/></shape>");
    let parts = parts(&file);
    assert_eq!(
        parts.iter().map(|p| p.side).collect::<Vec<_>>(),
        [ModelSide::Front, ModelSide::Back]
    );
    let facing = |part: &ModelPart| match &part.shape {
        ObjectShape::Primitive(Primitive::Sphere(sphere)) => sphere.facing(),
        ObjectShape::Primitive(_) | ObjectShape::Mesh(_) => panic!("{part:?}"),
    };
    assert_eq!([&parts[0], &parts[1]].map(facing), [Facing::Outward, Facing::Inward]);
    let SurfaceModel::Lambert(back) = file.materials[parts[1].material].surface.model else {
        panic!()
    };
    assert_eq!((back.reflectance(), file.materials[0].name.as_str()), (Rgb::BLACK, "x"));
    let (file, _) = read(
        "two",
        "<shape type='sphere'><bsdf type='twosided'><bsdf type='diffuse'/></bsdf></shape>",
    );
    assert_eq!((self::parts(&file).len(), file.materials[0].sides), (1, Sides::Both));
}

#[test]
fn materials_are_shared_but_for_what_they_emit() {
    let lamp = "<emitter type='area'><rgb name='radiance' value='2'/></emitter>";
    let shape = "<shape type='cube'><ref id='a'/>";
    let text =
        format!("<bsdf type='diffuse' id='a'/>{shape}</shape>{shape}</shape>{shape}{lamp}</shape>");
    let (file, _) = read("shared", &text);
    assert_eq!((file.materials.len(), parts(&file).len()), (4, 36));
    assert_eq!([0, 1, 2, 3].map(|i| file.materials[i].emission.g), [0.0, 0.0, 2.0, 0.0]);
}

#[test]
fn metals_reflect_what_they_do_at_normal_incidence() {
    let SurfaceModel::Mirror(gold) =
        model("gold", "<bsdf type='conductor'><string name='material' value='Au'/></bsdf>")
    else {
        panic!()
    };
    near(gold.reflectance(), [0.966_679, 0.802_01, 0.324_121]);
    let rough = "<bsdf type='roughconductor'><rgb name='eta' value='0.2'/><rgb name='k' value='3'/><float name='alpha' value='0.2'/></bsdf>";
    let SurfaceModel::MaxPhong(metal) = model("metal", rough) else { panic!() };
    // (0.8² + 9)/(1.2² + 9); 1/(2·0.04).
    near(metal.specular(), [0.923_371_6; 3]);
    assert!((metal.exponent() - 12.5).abs() < 1e-4);
}

#[test]
fn glass_has_the_index_of_inside_over_outside() {
    let text = "<bsdf type='dielectric'><float name='int_ior' value='1.5'/><string name='ext_ior' value='water'/></bsdf>";
    let SurfaceModel::Dielectric(glass) = model("glass", text) else { panic!() };
    assert!((glass.index() - 1.5 / 1.333).abs() < 1e-6);
    let (pane, _) = material(
        "pane",
        "<bsdf type='thindielectric'><float name='int_ior' value='1.5'/><float name='ext_ior' value='1'/></bsdf>",
    );
    let SurfaceModel::Mirror(mirror) = pane.model else { panic!() };
    // 0.08/1.04.
    near(mirror.reflectance(), [0.076_923_08; 3]);
    near(pane.through, [0.923_076_9; 3]);
    let (none, _) =
        material("none", "<bsdf type='dielectric'><string name='int_ior' value='air'/></bsdf>");
    assert_eq!(none.through, Rgb::WHITE);
}

#[test]
fn plastics_are_diffuse_under_a_mirror_or_a_lobe() {
    let index = "<float name='int_ior' value='1.5'/><float name='ext_ior' value='1'/>";
    let smooth =
        format!("<bsdf type='plastic'>{index}<rgb name='diffuse_reflectance' value='0.5'/></bsdf>");
    let SurfaceModel::Mirror(smooth) = model("smooth", &smooth) else { panic!() };
    near(smooth.reflectance(), [0.04; 3]);
    near(smooth.diffuse(), [0.48; 3]);
    let rough =
        format!("<bsdf type='roughplastic'>{index}<boolean name='nonlinear' value='true'/></bsdf>");
    let SurfaceModel::Phong(rough) = model("rough", &rough) else { panic!() };
    // 0.5·(1 − k)/(1 − 0.5·k), k = 0.596 of light from inside; 1/(2·0.01).
    near(rough.specular(), [0.04; 3]);
    assert!((rough.diffuse().g - 0.96 * 0.5 * 0.404 / 0.702).abs() < 1e-3, "{rough:?}");
    assert!((rough.exponent() - 50.0).abs() < 1e-3);
}

#[test]
fn masks_let_the_rest_through() {
    let text =
        "<bsdf type='mask'><float name='opacity' value='0.25'/><bsdf type='diffuse'/></bsdf>";
    let (file, _) = read("mask", &format!("<shape type='sphere'>{text}</shape>"));
    let SurfaceModel::Lambert(part) = file.materials[0].surface.model else { panic!() };
    near(part.reflectance(), [0.125; 3]);
    assert_eq!(file.materials[0].surface.through, Rgb::splat(0.75));
    assert_eq!(file.materials[1].surface.through, Rgb::splat(0.75));
}

#[test]
fn lights_and_spectra_are_as_in_mitsuba() {
    let (file, warnings) = read(
        "lights",
        "<shape type='sphere'/>
        <emitter type='point'><spectrum name='intensity' value='10'/></emitter>
        <emitter type='spot'><transform name='to_world'><translate y='1'/></transform></emitter>
        <emitter type='directional'/>",
    );
    let lights = file.lights(&Placement::NONE, &traylib_geometry::Aabb::EMPTY);
    near(lights[0].intensity, [12.0479, 9.48291, 9.08916]);
    let cone = lights[1].cone.unwrap();
    assert_eq!((lights[1].position, cone.axis), (Vec3::Y, Vec3::Z));
    let [full, dark] = [15.0_f32, 20.0].map(|angle| angle.to_radians().cos());
    assert!((cone.cos_full - full).abs() < 1e-6 && (cone.cos_dark - dark).abs() < 1e-6);
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    assert!(warnings[1].contains("emitter `directional` skipped"), "{warnings:?}");
}

#[test]
fn skies_are_brought_in_once() {
    let constant = "<emitter type='constant'><rgb name='radiance' value='1 2 3'/></emitter>";
    let (file, warnings) = read("constant", &format!("<shape type='sphere'/>{constant}{constant}"));
    assert_eq!(file.sky().unwrap().radiance.values(), [Rgb::new(1.0, 2.0, 3.0)]);
    assert!(warnings.len() == 1 && warnings[0].contains("second sky skipped"), "{warnings:?}");

    let picture = |name: &str, more: &str| {
        let text = format!(
            "<shape type='sphere'/><emitter type='envmap'>
                <string name='filename' value='{name}'/><float name='scale' value='2'/>{more}
            </emitter>"
        );
        let folder = Folder::new("envmap", &text);
        let light = traylib_math::Grid::filled(4, 2, Rgb::new(0.5, 1.0, 2.0));
        crate::write_picture(&folder.0.join("sky.exr"), &light, 1.0, &[]).unwrap();
        folder.read().unwrap()
    };
    let (file, warnings) = picture("sky.exr", "");
    assert_eq!(file.sky().unwrap().radiance.get(3, 3), &Rgb::new(1.0, 2.0, 4.0));
    assert!(warnings.is_empty(), "{warnings:?}");
    let scaled = "<transform name='to_world'><scale value='3'/></transform>";
    let skewed =
        "<transform name='to_world'><matrix value='1 1 0 0 0 1 0 0 0 0 1 0 0 0 0 1'/></transform>";
    for (name, more, words) in [
        ("none.exr", "", "sky `none.exr` not found"),
        ("../other.exr", "", "not found"),
        ("a.xml", "", "a.xml"),
        ("sky.exr", scaled, "scale of an `envmap` skipped"),
        ("sky.exr", skewed, "skewed `to_world` of an `envmap` skipped"),
    ] {
        let (file, warnings) = picture(name, more);
        assert_eq!(file.sky().is_some(), name == "sky.exr", "{name}");
        assert!(warnings.len() == 1 && warnings[0].contains(words), "{warnings:?}");
    }
}

#[test]
fn nothing_is_passed_over_in_silence() {
    let (_, warnings) = read("silent", "<shape type='sphere'><float name='radios' value='2'/><medium type='homogeneous'/>
        <bsdf type='hair'/></shape><shape type='serialized'><string name='filename' value='x'/></shape>
        <shape type='sphere'><transform name='to_world'><scale x='2'/></transform></shape>
        <shape type='disk'><transform name='to_world'><scale x='2'/></transform></shape>
        <medium type='x'/><emitter type='projector'/>");
    for expected in [
        "`radios` of `sphere` skipped",
        "medium `homogeneous` within `sphere` skipped",
        "bsdf `hair` shown grey",
        "shape `serialized` skipped",
        "scaled unevenly left out",
        "disk that is no circle",
        "medium `x` skipped",
        "emitter `projector` skipped",
    ] {
        assert!(
            warnings.iter().any(|warning| warning.contains(expected)),
            "{expected}: {warnings:?}"
        );
    }
    assert_eq!(warnings.len(), 8, "{warnings:?}");
}

#[test]
fn files_that_are_missing_or_elsewhere_are_refused_with_their_place() {
    for name in ["x.obj", "../x.obj", "/etc/hostname"] {
        let text = format!("\n<shape type='obj'><string name='filename' value='{name}'/></shape>");
        let error = Folder::new("missing", &text).read().err().unwrap().to_string();
        assert!(
            error.contains("a.xml:2:1: ")
                && error.ends_with("there is no such file in the folder of the scene"),
            "{error}"
        );
    }
    let text = "<include filename='../a.xml'/>";
    let error = Folder::new("include", text).read().err().unwrap().to_string();
    assert!(error.contains("cannot be included"), "{error}");
}

#[test]
fn materials_within_themselves_are_refused() {
    let text = "<bsdf type='twosided' id='a'><ref id='b'/></bsdf><bsdf type='mask' id='b'><ref id='a'/></bsdf>
        <shape type='sphere'><ref id='a'/></shape>";
    let error = Folder::new("circle", text).read().err().unwrap().to_string();
    assert!(error.contains("is within itself"), "{error}");
}

#[test]
fn triangles_have_a_bound_that_counts_every_place() {
    let folder = Folder::new(
        "bound",
        &"<shape type='obj'><string name='filename' value='b.obj'/></shape>".repeat(10),
    );
    fs::write(folder.0.join("b.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let location = Location::Disk(folder.0.join("a.xml"));
    let read = |most| {
        let mut limits = crate::ReadLimits::default();
        limits.set(crate::Limit::Surfaces, most);
        super::read(
            &location,
            LoadOptions { limits, ..LoadOptions::default() },
            &mut Counter::default(),
        )
    };
    // Two sides each.
    assert!(read(20).is_ok());
    assert!(read(19).err().unwrap().to_string().contains("--limit surfaces=38"));
}
