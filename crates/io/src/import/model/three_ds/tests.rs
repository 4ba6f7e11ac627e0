use super::*;
use crate::ron_scene;
use crate::three_ds::{Document, Face, Material, Mesh, Shading};

fn placement() -> Placement {
    let file = String::new();
    let (rotate, translate) = ([-90.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    Placement::new(&ron_scene::Mesh { file, scale: 2.0, rotate, translate }).unwrap()
}

/// Two squares' halves that meet at a right angle along x.
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

fn parts(mesh: Mesh, materials: Vec<Material>) -> Vec<(geometry::Mesh, SurfaceModel, Sides)> {
    let document = Document { meshes: vec![mesh], materials, ..Document::default() };
    MeshFile::new(document).unwrap().0.parts(&placement()).unwrap()
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
    let sides: Vec<(usize, Sides)> = parts.iter().map(|p| (p.0.triangle_count(), p.2)).collect();
    assert_eq!(sides, [(1, Sides::Both), (1, Sides::Front)]);
}

/// The model of a material of these properties, and whether it was scaled.
fn model(diffuse: f32, strength: f32, shading: Shading) -> (SurfaceModel, bool) {
    let material = Material {
        diffuse: Rgb::new(diffuse, 0.0, 0.0),
        specular: Rgb::WHITE,
        shininess: 0.3,
        shininess_strength: strength,
        shading,
        ..Material::default()
    };
    surface_model(&material).unwrap()
}

#[test]
fn colours_become_linear_and_the_highlight_its_share() {
    let phong = |kd: [f32; 3], ks: [f32; 3]| {
        SurfaceModel::Phong(Phong::new(kd.into(), ks.into(), 8.0).unwrap())
    };
    let half = crate::srgb::decode(0.5);
    let kd = [half, 0.0, 0.0];
    assert_eq!(model(0.5, 0.25, Shading::Phong), (phong(kd, [0.25; 3]), false));
    assert_eq!(model(0.5, 0.25, Shading::Metal), (phong(kd, [0.25 * half, 0.0, 0.0]), false));
    let lambert = SurfaceModel::Lambert(Lambert::new(kd.into()).unwrap());
    assert_eq!(model(0.5, 0.0, Shading::Phong), (lambert, false));
}

#[test]
fn energy_is_never_made() {
    for step in 0..=100 {
        let (_, scaled) = model(1.0, step as f32 / 100.0, Shading::Phong);
        assert_eq!(scaled, step > 0);
    }
}
