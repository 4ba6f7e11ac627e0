use super::*;
use crate::import::model_part::ModelPart;
use crate::import::placement::Placement;
use traylib_geometry::{Mesh, Sides};
use traylib_math::{Grid, Rgb, Vec2, Vec3};
use traylib_scene::ObjectShape;

fn read(test: &str, text: &str) -> Result<(ModelFile, Vec<String>), Error> {
    let folder = std::env::temp_dir().join(format!("traylib-ply-{}-{test}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("a.ply"), text).unwrap();
    let grey = Grid::filled(2, 2, Rgb::splat(0.25));
    crate::write_picture(&folder.join("grey.png"), &grey, 1.0, &[]).unwrap();
    let mut counter = Counter::default();
    let location = Location::Disk(folder.join("a.ply"));
    let read = super::read(&location, LoadOptions::default(), &mut counter);
    std::fs::remove_dir_all(&folder).unwrap();
    let (file, _) = read?;
    Ok((file, counter.into_warnings("a.ply").map(|warning| warning.to_string()).collect()))
}

fn mesh(file: &ModelFile) -> Mesh {
    let parts = file.parts(&Placement::NONE, &mut Counter::default()).unwrap();
    let [ModelPart { shape: ObjectShape::Mesh(mesh), .. }] = &parts[..] else {
        panic!("{parts:?}")
    };
    mesh.clone()
}

const SQUARE: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
                      property float z\nelement face 1\nproperty list uchar int vertex_indices\n";

#[test]
fn polygons_are_cut_and_grey() {
    let (file, warnings) =
        read("square", &format!("{SQUARE}end_header\n0 0 0 1 0 0 1 1 0 0 1 0 4 0 1 2 3\n"))
            .unwrap();
    let mesh = mesh(&file);
    assert_eq!((mesh.positions().len(), mesh.triangle_count()), (4, 2));
    assert_eq!(mesh.triangle(1).unwrap().normal(), Vec3::Z);
    assert!(warnings.is_empty() && file.materials[0].sides == Sides::Both);
}

#[test]
fn corners_with_texture_coordinates_of_their_own_are_split() {
    let text =
        SQUARE.replace("element vertex", "comment TextureFile C:\\x\\GREY.png\nelement vertex");
    let text = format!(
        "{text}property list uchar float texcoord\nend_header\n0 0 0 1 0 0 1 1 0 0 1 0 \
         4 0 1 2 3 8 0 0 1 0 1 1 0 1\n"
    )
    .replace("element face 1", "element face 2")
        + "3 0 1 2 6 0 0 1 0 0.5 1\n";
    let (file, warnings) = read("split", &text).unwrap();
    let mesh = mesh(&file);
    // Only one corner has others in the second face.
    assert_eq!((mesh.positions().len(), mesh.triangle_count()), (5, 3));
    assert_eq!(mesh.uv(2, 0.0, 1.0), Some(Vec2::new(0.5, 1.0)));
    assert!(warnings.is_empty(), "{warnings:?}");
    assert!(file.materials[0].surface.maps.as_ref().unwrap().diffuse.is_some());
}

#[test]
fn points_alone_are_nothing_to_see() {
    let text = SQUARE.replace("element face 1", "element face 0")
        + "end_header\n0 0 0 1 0 0 1 1 0 0 1 0\n";
    assert!(matches!(read("points", &text).map(|_| ()), Err(Error::NothingToSee(_))));
}
