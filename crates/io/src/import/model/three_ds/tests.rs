use super::*;
use crate::import::model::ModelFile;
use crate::three_ds::{Face, Light, Map, MapKind, Material, Shading};
use traylib_geometry::Sides;
use traylib_materials::{Lambert, Phong, SurfaceModel};
use traylib_math::Rgb;

fn placement() -> Placement {
    Placement::new(2.0, [-90.0, 0.0, 0.0], [0.0, 1.0, 0.0]).unwrap()
}

/// A document's file, as if in a folder without pictures, and its warnings.
fn file(document: Document) -> (ModelFile, Vec<String>) {
    let (mut textures, mut counter) = (Textures::new(ReadLimits::default()), Counter::default());
    let folder = Folder::of(&Location::BuiltIn(String::new()));
    let pictures = Pictures { textures: &mut textures, counter: &mut counter };
    let file = model(document, &mut MapImporter { folder, pictures }).unwrap();
    (file, counter.into_warnings("f").map(|warning| warning.to_string()).collect())
}

/// Two triangles that meet at a right angle along x.
fn bent(smoothing: [u32; 2], materials: [Option<usize>; 2]) -> Mesh {
    let corners = [[0, 1, 2], [0, 3, 1]];
    let face = |i: usize| Face {
        corners: corners[i],
        smoothing: smoothing[i],
        material: materials[i],
        ..Face::default()
    };
    Mesh {
        name: "bent".to_string(),
        vertices: vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z],
        faces: vec![face(0), face(1)],
        ..Mesh::default()
    }
}

fn parts(mesh: Mesh, materials: Vec<Material>) -> Vec<(geometry::Mesh, Sides)> {
    let document = Document { meshes: vec![mesh], materials, ..Document::default() };
    let (file, _) = file(document);
    let parts = file.parts(&placement(), &mut Counter::default()).unwrap();
    let part = |part: ModelPart| match part.shape {
        ObjectShape::Mesh(mesh) => (mesh, file.materials[part.material].sides),
        ObjectShape::Primitive(_) => panic!(),
    };
    parts.into_iter().map(part).collect()
}

#[test]
fn vertices_are_shared_while_their_normals_agree() {
    let counts = |smoothing| parts(bent(smoothing, [None; 2]), Vec::new())[0].0.positions().len();
    assert_eq!(counts([0, 0]), 4);
    assert_eq!(counts([1, 1]), 4);
    assert_eq!(counts([1, 2]), 6);
}

#[test]
fn positions_and_normals_are_placed() {
    let (mesh, ..) = &parts(bent([1, 1], [None; 2]), Vec::new())[0];
    assert_eq!(mesh.positions()[2], Vec3::new(0.0, 1.0, -2.0));
    // (0, 1, 1)/√2 before the turn.
    let normal = mesh.shading_normal(0, 0.0, 0.0).unwrap();
    assert!((normal - Vec3::new(0.0, 1.0, -1.0).normalize()).length() < 1e-6, "{normal}");
}

#[test]
fn faces_are_split_by_material() {
    let two_sided = Material { two_sided: true, ..Material::default() };
    let parts = parts(bent([0; 2], [None, Some(0)]), vec![two_sided]);
    let sides: Vec<(usize, Sides)> = parts.iter().map(|p| (p.0.triangle_count(), p.1)).collect();
    assert_eq!(sides, [(1, Sides::Both), (1, Sides::Front)]);
}

/// The material as it is imported, and whether there was something to warn of.
fn imported(material: Material) -> (ImportedMaterial, Vec<String>) {
    let document = Document { materials: vec![material], ..Document::default() };
    let (file, warnings) = file(document);
    (file.materials[0].clone(), warnings)
}

fn glossy(diffuse: f32, strength: f32, shading: Shading) -> Material {
    Material {
        diffuse: Rgb::new(diffuse, 0.0, 0.0),
        specular: Rgb::WHITE,
        shininess: 0.3,
        shininess_strength: strength,
        shading,
        ..Material::default()
    }
}

#[test]
fn colours_become_linear_and_the_highlight_its_share() {
    let phong = |kd: [f32; 3], ks: [f32; 3]| {
        SurfaceModel::Phong(Phong::new(kd.into(), ks.into(), 8.0).unwrap())
    };
    let model = |strength, shading| imported(glossy(0.5, strength, shading)).0.surface.model;
    let side = crate::srgb::decode(0.5);
    let kd = [side, 0.0, 0.0];
    assert_eq!(model(0.25, Shading::Phong), phong(kd, [0.25; 3]));
    assert_eq!(model(0.25, Shading::Metal), phong(kd, [0.25 * side, 0.0, 0.0]));
    let lambert = SurfaceModel::Lambert(Lambert::new(kd.into()).unwrap());
    assert_eq!(model(0.0, Shading::Phong), lambert);
}

#[test]
fn energy_is_never_made() {
    for step in 0..=100 {
        let material = glossy(1.0, step as f32 / 100.0, Shading::Phong);
        assert_eq!(imported(material).1.len(), usize::from(step > 0));
    }
}

#[test]
fn transparency_lets_light_straight_through() {
    let material = Material { transparency: 0.75, ..glossy(1.0, 0.0, Shading::Phong) };
    let made = imported(material).0.surface;
    let kd = Rgb::new(0.25, 0.0, 0.0);
    assert_eq!(made.model, SurfaceModel::Lambert(Lambert::new(kd).unwrap()));
    assert_eq!(made.through, Rgb::splat(0.75));
}

#[test]
fn a_material_shines_by_itself_in_its_colour() {
    let glows = Material { self_illumination: Some(0.5), ..glossy(1.0, 0.0, Shading::Phong) };
    assert_eq!(imported(glows).0.emission, Rgb::new(0.5, 0.0, 0.0));
}

#[test]
fn maps_that_cannot_be_shown_are_warned_of() {
    let map = |kind| (kind, Map { file: "C:\\A.GIF".into(), ..Map::default() });
    let maps = vec![map(MapKind::Texture1), map(MapKind::Reflection)];
    let (material, warnings) = imported(Material { maps, ..Material::default() });
    assert_eq!(material.surface.maps, None);
    let expected = ["f: picture `A.GIF` not found, shown without", "f: reflection map skipped"];
    assert_eq!(warnings, expected);
}

#[test]
fn lights_are_as_bright_as_if_distance_did_not_count() {
    let light = Light::new(String::new(), Vec3::new(0.0, 0.0, 4.0));
    let intensity = |light: &Light| {
        // Of side 2.
        let around = Aabb { min: Vec3::NEG_ONE, max: Vec3::ONE };
        light::light(light, &Placement::NONE, &around).map(|light| light.intensity.g)
    };
    // A diffuse white surface at the middle shows π·16/(4²·π) = 1.
    assert_eq!(intensity(&light), Some(std::f32::consts::PI * 16.0));
    // In the middle it counts as a quarter of √3 off.
    let within = intensity(&Light { position: Vec3::ZERO, ..light.clone() }).unwrap();
    assert!((within / std::f32::consts::PI - 3.0 / 16.0).abs() < 1e-6, "{within}");
    assert_eq!(intensity(&Light { on: false, ..light.clone() }), None);
    assert_eq!(intensity(&Light { multiplier: -1.0, ..light }), None);
}
