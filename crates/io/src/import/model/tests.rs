use super::*;
use crate::import::model_part::ModelSide;
use crate::import::placement::Placement;
use std::fs;
use traylib_geometry::{Facing, Primitive};
use traylib_scene::ObjectShape;

/// The parts of an MGF text, its materials and what was dropped.
fn parts_of(test: &str, text: &str) -> (Vec<ModelPart>, Vec<ImportedMaterial>, usize) {
    let path = std::env::temp_dir().join(format!("traylib-{}-{test}.mgf", std::process::id()));
    fs::write(&path, text).unwrap();
    let read = ModelFile::read(&Location::Disk(path.clone()), LoadOptions::default());
    fs::remove_file(&path).unwrap();
    let (file, warnings) = read.unwrap();
    assert_eq!(warnings, []);
    let mut counter = Counter::default();
    let parts = file.parts(&Placement::NONE, &mut counter).unwrap();
    (parts, file.materials, counter.into_warnings("").count())
}

const POINTS: &str = "v a =\n p 0 0 0\nv b =\n p 1 0 0\nv c =\n p 1 1 0\nv d =\n p 0 1 0\n\
                      v e =\n p 0 0 3\n n 0 0 1\n";

#[test]
fn round_shapes_stay_round_and_flat_ones_are_a_mesh_for_each_material() {
    let text = format!(
        "{POINTS}m grey =\n rd .5\nf a b c d\nsph e -2\ncyl a 1 e\nring e .5 1\n\
         m none =\nf a b c\nm grey\nf a c d\n"
    );
    let (parts, materials, dropped) = parts_of("shapes", &text);
    assert_eq!((parts.len(), materials.len(), dropped), (5, 2, 0));
    let ObjectShape::Primitive(Primitive::Sphere(sphere)) = parts[0].shape else { panic!() };
    assert_eq!((sphere.radius(), sphere.facing()), (2.0, Facing::Inward));
    assert!(matches!(parts[1].shape, ObjectShape::Primitive(Primitive::Cone(_))));
    let ObjectShape::Primitive(Primitive::Disk(ring)) = parts[2].shape else { panic!() };
    assert_eq!([ring.inner_radius(), ring.radius()], [0.5, 1.0]);
    let triangles = parts[3..].iter().map(|part| match &part.shape {
        ObjectShape::Mesh(mesh) => (part.material, mesh.triangle_count(), mesh.positions().len()),
        ObjectShape::Primitive(_) => panic!(),
    });
    assert_eq!(triangles.collect::<Vec<_>>(), [(0, 3, 4), (1, 1, 3)]);
}

#[test]
fn lamps_of_two_sides_are_two_surfaces_unless_closed() {
    let text = format!("{POINTS}m lamp =\n ed 100\nf a b c d\nring e 0 1\nsph a 1\n");
    let (parts, _, _) = parts_of("sides", &text);
    let sides: Vec<ModelSide> = parts.iter().map(|part| part.side).collect();
    assert_eq!(
        sides,
        [ModelSide::Front, ModelSide::Back, ModelSide::Whole, ModelSide::Front, ModelSide::Back]
    );
    let normal = |part: &ModelPart| match &part.shape {
        ObjectShape::Primitive(Primitive::Disk(disk)) => disk.normal(),
        ObjectShape::Mesh(mesh) => {
            let [a, b, c] = mesh.triangles()[0].map(|i| mesh.positions()[i as usize]);
            (b - a).cross(c - a).normalize()
        }
        ObjectShape::Primitive(_) => panic!(),
    };
    assert_eq!([0, 1, 3, 4].map(|i| normal(&parts[i]).z), [1.0, -1.0, 1.0, -1.0]);
    let (single, _, _) =
        parts_of("single", &format!("{POINTS}m lamp =\n ed 1\n sides 1\nf a b c\n"));
    assert_eq!(single.len(), 1);
}

#[test]
fn normals_stay_with_the_triangles_that_have_them() {
    let text = format!("{POINTS}m grey =\n rd .5\nf a b c\nf a b e\n");
    let (parts, _, _) = parts_of("normals", &text);
    let smooth = parts.iter().map(|part| match &part.shape {
        ObjectShape::Mesh(mesh) => mesh.has_attributes(),
        ObjectShape::Primitive(_) => panic!(),
    });
    assert_eq!(smooth.collect::<Vec<_>>(), [false, true]);
}
