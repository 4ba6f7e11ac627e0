//! The scenes that glTF files become, held against what the files mean.

use super::*;
use crate::import::imported_material::ImportedMaterial;
use crate::import::model_part::ModelPart;
use crate::import::placement::Placement;
use traylib_geometry::Sides;
use traylib_geometry::{Mesh, Vec3};
use traylib_materials::{Phong, SurfaceModel, Tiling};
use traylib_math::{Grid, Rgb, Vec2};
use traylib_scene::ObjectShape;

/// A triangle with texture coordinates, of a material, in a node.
fn read(test: &str, material: &str, node: &str) -> (ModelFile, Vec<String>) {
    let folder = std::env::temp_dir().join(format!("traylib-gltf-{}-{test}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let numbers = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0];
    let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    std::fs::write(folder.join("a.bin"), bytes).unwrap();
    let grey = Grid::filled(2, 2, Rgb::new(0.25, 0.5, 0.0));
    crate::write_picture(&folder.join("p.png"), &grey, 1.0, &[]).unwrap();
    let text = format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":60,"uri":"a.bin"}}],
        "bufferViews":[{{"buffer":0,"byteLength":36}},{{"buffer":0,"byteOffset":36,"byteLength":24}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}},
            {{"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}}],
        "images":[{{"uri":"p.png"}}],"textures":[{{"source":0}}],
        "materials":[{material}],"nodes":[{{"mesh":0{node}}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":1}},"material":0}}]}}]}}"#
    );
    std::fs::write(folder.join("a.gltf"), text).unwrap();
    let mut counter = Counter::default();
    let location = Location::Disk(folder.join("a.gltf"));
    let read = super::read(&location, LoadOptions::default(), &mut counter);
    std::fs::remove_dir_all(&folder).unwrap();
    let warnings = counter.into_warnings("a").map(|warning| warning.to_string());
    (read.unwrap().0, warnings.collect())
}

fn mesh(file: &ModelFile, placement: &Placement) -> Mesh {
    let parts = file.parts(placement, &mut Counter::default()).unwrap();
    let Some(ModelPart { shape: ObjectShape::Mesh(mesh), .. }) = parts.first() else { panic!() };
    mesh.clone()
}

fn phong(material: &ImportedMaterial) -> Phong {
    let SurfaceModel::Phong(phong) = material.surface.model else { panic!("{material:?}") };
    phong
}

fn pbr(test: &str, inside: &str) -> (ImportedMaterial, Vec<String>) {
    let (file, warnings) = read(test, &format!(r#"{{"pbrMetallicRoughness":{{{inside}}}}}"#), "");
    (file.materials[0].clone(), warnings)
}

fn near(a: Rgb, b: Rgb) -> bool {
    a.to_array().iter().zip(b.to_array()).all(|(a, b)| (a - b).abs() < 4e-3)
}

#[test]
fn metal_and_roughness_become_diffuse_and_phong() {
    let c = r#""baseColorFactor":[1,0.5,0.25,1],"roughnessFactor":0.5"#;
    let (plastic, warnings) = pbr("plastic", &format!(r#"{c},"metallicFactor":0"#));
    assert!(warnings.is_empty() && plastic.sides == Sides::Front);
    let wanted = Phong::new(Rgb::new(1.0, 0.5, 0.25) * 0.96, Rgb::splat(0.04), 8.0).unwrap();
    assert_eq!(phong(&plastic), wanted);
    let (metal, _) = pbr("metal", c);
    assert_eq!(phong(&metal), Phong::new(Rgb::BLACK, Rgb::new(1.0, 0.5, 0.25), 8.0).unwrap());
    let (half, _) = pbr("half", &format!(r#"{c},"metallicFactor":0.5"#));
    assert!(near(phong(&half).specular(), Rgb::new(0.52, 0.27, 0.145)));
    let exponent = |r: &str| phong(&pbr("sharp", &format!(r#""roughnessFactor":{r}"#)).0);
    assert_eq!(exponent("0"), Phong::new(Rgb::BLACK, Rgb::WHITE, 1e6).unwrap());
    assert_eq!(exponent("1"), Phong::new(Rgb::BLACK, Rgb::WHITE, 1.0).unwrap());
}

/// The picture is the specular part of a metal, and of anything else the diffuse one.
#[test]
fn pictures_show_in_both_parts() {
    let at = |layer: &Option<traylib_materials::Layer>| {
        layer.as_ref().unwrap().texture.lookup(Vec2::splat(0.5), Tiling::Repeat).unwrap()
    };
    let c = r#""baseColorFactor":[1,1,0.5,1],"baseColorTexture":{"index":0}"#;
    let (half, _) = pbr("half picture", &format!(r#"{c},"metallicFactor":0.5"#));
    let maps = half.surface.maps.as_ref().unwrap();
    assert!(near(at(&maps.diffuse), Rgb::new(0.25, 0.5, 0.0) * 0.48));
    assert!(near(at(&maps.specular), Rgb::new(0.25, 0.5, 0.0)));
    assert_eq!(maps.specular.as_ref().unwrap().strength, 0.5);
    assert_eq!(phong(&half).specular(), Rgb::splat(0.04));
    let (plastic, _) = pbr("plastic", &format!(r#"{c},"metallicFactor":0"#));
    assert!(plastic.surface.maps.as_ref().unwrap().specular.is_none());
    // Green and blue as stored, 188/255 and 0.
    let mean = r#""metallicRoughnessTexture":{"index":0},"roughnessFactor":0.5"#;
    let (mean, warnings) = pbr("mean", mean);
    assert_eq!(warnings.len(), 1);
    let slope = (0.5_f32 * 188.0 / 255.0).powi(2);
    let wanted = Phong::new(Rgb::splat(0.96), Rgb::splat(0.04), 0.5 / (slope * slope)).unwrap();
    assert!(near(phong(&mean).diffuse(), wanted.diffuse()), "{mean:?}");
}

#[test]
fn alpha_is_opacity_where_it_is_blended_or_masked() {
    let through = |rest: &str| {
        let pbr = r#""pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.25]}"#;
        let (file, _) = read("alpha", &format!("{{{pbr}{rest}}}"), "");
        file.materials[0].surface.through.g
    };
    assert_eq!(through(""), 0.0);
    assert_eq!(through(r#","alphaMode":"BLEND""#), 0.75);
    assert_eq!(through(r#","alphaMode":"MASK""#), 1.0);
    assert_eq!(through(r#","alphaMode":"MASK","alphaCutoff":0.25"#), 0.0);
}

#[test]
fn texture_coordinates_go_up_here() {
    let (file, _) = read("uv", "{}", "");
    let mesh = mesh(&file, &Placement::NONE);
    assert_eq!(mesh.uvs(), [Vec2::ZERO, Vec2::X, Vec2::Y]);
    let transform = r#""KHR_texture_transform":{"offset":[0.25,0.5],"rotation":0.5,"scale":[2,4]}"#;
    let picture = format!(r#""baseColorTexture":{{"index":0,"extensions":{{{transform}}}}}"#);
    let (material, _) = pbr("transform", &picture);
    let layer = material.surface.maps.unwrap().diffuse.unwrap();
    // As Khronos' own viewer does, with v down: scaled, then turned counter-clockwise as seen
    // on the picture, then moved.
    let (u, v) = (0.3_f32, 0.1_f32);
    let (sin, cos) = 0.5_f32.sin_cos();
    let (x, y) = (2.0 * u, 4.0 * v);
    let theirs = Vec2::new(cos * x + sin * y + 0.25, -sin * x + cos * y + 0.5);
    let ours = layer.placement.transform_point2(Vec2::new(u, 1.0 - v));
    assert!(ours.distance(Vec2::new(theirs.x, 1.0 - theirs.y)) < 1e-6, "{ours} {theirs}");
}

#[test]
fn mirrored_instances_keep_their_fronts() {
    let (file, _) = read("mirrored", "{}", r#","scale":[-2,1,1],"translation":[0,0,1]"#);
    let mesh = mesh(&file, &Placement::new(2.0, [0.0; 3], [0.0; 3]).unwrap());
    assert_eq!(mesh.triangle(0).unwrap().normal(), Vec3::Z);
    assert_eq!(
        mesh.positions(),
        [Vec3::new(0.0, 0.0, 2.0), Vec3::new(-4.0, 0.0, 2.0), Vec3::new(0.0, 2.0, 2.0)]
    );
}

#[test]
fn what_is_not_rendered_is_told_once() {
    let material = r#"{"emissiveFactor":[1,1,1],"emissiveTexture":{"index":0},
        "normalTexture":{"index":0},"occlusionTexture":{"index":0},
        "extensions":{"KHR_materials_unlit":{}}}"#;
    let (file, warnings) = read("skipped", material, "");
    assert_eq!(warnings.len(), 4, "{warnings:?}");
    assert!(file.materials[0].emission.is_black());
}
