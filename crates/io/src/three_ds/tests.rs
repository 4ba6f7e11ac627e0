mod damage;
mod keyframer;
mod real_files;
mod scene;
pub(super) mod writer;

use super::*;
use traylib_math::Vec3;
use writer::{SQUARE, chunk, faces, file, group, list, material, vertices};

pub(super) const CUBE: &[u8] = include_bytes!("../../../../scenes/models/cube.3ds");
pub(super) const ENEMY: &[u8] = include_bytes!("../../../../scenes/models/enemy01.3ds");

#[test]
fn the_smallest_exported_cube() {
    let document = decode(CUBE).unwrap();
    let [mesh] = &document.meshes[..] else { panic!("{} meshes", document.meshes.len()) };
    assert_eq!((mesh.name.as_str(), mesh.vertices.len(), mesh.faces.len()), ("Cube", 8, 12));
    assert!(mesh.uvs.is_empty());
    assert!(mesh.faces.iter().all(|face| face.smoothing == 0 && face.material == Some(0)));
    let [material] = &document.materials[..] else { panic!("not one material") };
    assert_eq!((material.name.as_str(), material.specular), ("Material", Rgb::WHITE));
    assert!((material.diffuse.r - 0.8).abs() < 1e-3);
}

#[test]
fn a_real_mesh_with_smoothing_groups() {
    let document = decode(ENEMY).unwrap();
    let [mesh] = &document.meshes[..] else { panic!("{} meshes", document.meshes.len()) };
    assert_eq!((mesh.vertices.len(), mesh.faces.len(), mesh.uvs.len()), (392, 198, 392));
    assert_eq!(mesh.faces.iter().filter(|face| face.smoothing != 0).count(), 52);
    let top = mesh.vertices.iter().copied().reduce(Vec3::max).unwrap();
    assert!((top - Vec3::new(13.4093, 4.39588, 6.65767)).length() < 1e-4, "{top}");
    let material = &document.materials[0];
    assert_eq!((material.shininess, material.shininess_strength), (0.1, 0.0));
    let maps: Vec<_> = material.maps.iter().map(|(kind, map)| (*kind, map.file_name())).collect();
    assert_eq!(maps, [(MapKind::Texture1, "ENEMY01D.BMP"), (MapKind::Bump, "ENEMY01B.BMP")]);
    let [x, .., origin] = mesh.axes.unwrap();
    assert!((x - Vec3::X * 0.326_422).length() < 1e-6, "{x}");
    assert!((origin - Vec3::new(-0.024_363, -12.260_536, 0.0)).length() < 1e-5, "{origin}");
    let nodes = &document.keyframer.as_ref().unwrap().nodes;
    assert_eq!((nodes.len(), nodes[0].name.as_str(), nodes[0].tracks.len()), (1, "enemy01", 3));
    assert_eq!(document.warnings, Warnings::default());
}

#[test]
fn chunks_may_come_in_any_order_and_materials_last() {
    let corners = faces(&[[0, 1, 2], [0, 2, 3]], &[&group(b"late", &[1]), &group(b"LOOSE ", &[0])]);
    let bytes = file(&[&corners, &vertices(&SQUARE)], &[&material(b"loose"), &material(b"late")]);
    let document = decode(&bytes).unwrap();
    let materials: Vec<_> = document.meshes[0].faces.iter().map(|face| face.material).collect();
    assert_eq!(materials, [Some(0), Some(1)]);
    assert_eq!(document.warnings, Warnings::default());
}

#[test]
fn the_last_group_of_a_face_and_the_first_material_of_a_name_win() {
    let groups = [group(b"a", &[0]), group(b"b", &[0, 9]), group(b"none", &[])];
    let corners = faces(&[[0, 1, 2]], &[&groups.concat()]);
    let materials = [material(b"a"), material(b"b"), material(b"b")].concat();
    let document = decode(&file(&[&vertices(&SQUARE), &corners], &[&materials])).unwrap();
    assert_eq!(document.meshes[0].faces[0].material, Some(1));
    let count = |kind| document.warnings.count(&kind);
    assert_eq!(count(WarningKind::FaceInTwoGroups), 1);
    assert_eq!(count(WarningKind::GroupBeyondFaces), 1);
    assert_eq!(count(WarningKind::UnknownMaterial), 1);
}

/// Faces are counted, not how often they are named.
#[test]
fn a_face_in_three_groups_is_one_face() {
    let groups = [group(b"a", &[0, 9]), group(b"b", &[0, 9]), group(b"a", &[0, 0, 9])];
    let corners = faces(&[[0, 1, 2]], &[&groups.concat()]);
    let materials = [material(b"a"), material(b"b")].concat();
    let document = decode(&file(&[&vertices(&SQUARE), &corners], &[&materials])).unwrap();
    let count = |kind| document.warnings.count(&kind);
    assert_eq!(count(WarningKind::FaceInTwoGroups), 1);
    assert_eq!(count(WarningKind::GroupBeyondFaces), 1);
    // The same material twice is no contradiction.
    let corners = faces(&[[0, 1, 2]], &[&[group(b"a", &[0]), group(b"a", &[0])].concat()]);
    let document = decode(&file(&[&vertices(&SQUARE), &corners], &[&material(b"a")])).unwrap();
    assert_eq!(document.warnings, Warnings::default());
}

#[test]
fn faces_that_cannot_be_drawn_are_counted_and_the_rest_keeps_its_masks() {
    let mut positions = SQUARE.to_vec();
    positions.push([f32::NAN, 0.0, 0.0]);
    let masks: Vec<u8> = [1_u32, 2, 3, 4].iter().flat_map(|m| m.to_le_bytes()).collect();
    let corners = [[0, 1, 9], [0, 1, 4], [0, 1, 1], [0, 1, 2]];
    let corners = faces(&corners, &[&chunk(0x4150, &[&masks])]);
    let document = decode(&file(&[&vertices(&positions), &corners], &[])).unwrap();
    let [face] = &document.meshes[0].faces[..] else { panic!("not one face") };
    assert_eq!(document.meshes[0].dropped_faces, 3);
    assert_eq!((face.corners, face.smoothing), ([0, 1, 2], 4));
    for kind in
        [WarningKind::FaceWithoutVertex, WarningKind::FaceNotFinite, WarningKind::FaceWithoutArea]
    {
        assert_eq!(document.warnings.count(&kind), 1, "{kind}");
    }
}

#[test]
fn texture_coordinates_are_made_to_fit() {
    let uvs = list(&[[0.5_f32, f32::NAN], [0.25, 0.75]], |uv| {
        let [u, v] = uv.map(f32::to_le_bytes);
        [u[0], u[1], u[2], u[3], v[0], v[1], v[2], v[3]]
    });
    let bytes =
        file(&[&vertices(&SQUARE), &faces(&[[0, 1, 2]], &[]), &chunk(0x4140, &[&uvs])], &[]);
    let document = decode(&bytes).unwrap();
    let uvs: Vec<[f32; 2]> = document.meshes[0].uvs.iter().copied().map(<[f32; 2]>::from).collect();
    assert_eq!(uvs, [[0.0, 0.0], [0.25, 0.75], [0.0, 0.0], [0.0, 0.0]]);
    assert_eq!(document.warnings.count(&WarningKind::UvCount), 1);
    assert_eq!(document.warnings.count(&WarningKind::UvNotFinite), 1);
}

#[test]
fn other_files_are_refused() {
    assert_eq!(decode(&[]), Err(Error::TooShort(0)));
    assert_eq!(decode(b"MM"), Err(Error::TooShort(2)));
    assert_eq!(decode(b"solid cube"), Err(Error::NotThreeDs(0x6f73)));
    // A header with a length shorter than itself holds nothing.
    assert!(decode(&[0x4d, 0x4d, 0, 0, 0, 0]).is_err());
}
