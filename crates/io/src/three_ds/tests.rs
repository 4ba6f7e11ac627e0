use super::*;
use traylib_math::{Purpose, Rgb, Sampler, Vec3};

const CUBE: &[u8] = include_bytes!("../../../../scenes/models/cube.3ds");
const ENEMY: &[u8] = include_bytes!("../../../../scenes/models/enemy01.3ds");

fn chunk(id: u16, parts: &[&[u8]]) -> Vec<u8> {
    let body = parts.concat();
    let length = u32::try_from(body.len() + 6).unwrap();
    [&id.to_le_bytes()[..], &length.to_le_bytes(), &body].concat()
}

fn list<T, const N: usize>(values: &[T], bytes: impl Fn(&T) -> [u8; N]) -> Vec<u8> {
    let count = u16::try_from(values.len()).unwrap().to_le_bytes();
    count.into_iter().chain(values.iter().flat_map(bytes)).collect()
}

fn vertices(positions: &[[f32; 3]]) -> Vec<u8> {
    let numbers: Vec<u8> = positions.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
    let count = u16::try_from(positions.len()).unwrap().to_le_bytes();
    chunk(0x4110, &[&count, &numbers])
}

fn faces(corners: &[[u16; 3]], inside: &[&[u8]]) -> Vec<u8> {
    let entry = |&[a, b, c]: &[u16; 3]| -> [u8; 8] {
        let mut bytes = [0; 8];
        for (place, value) in bytes.chunks_mut(2).zip([a, b, c, 7]) {
            place.copy_from_slice(&value.to_le_bytes());
        }
        bytes
    };
    chunk(0x4120, &[&list(corners, entry), &inside.concat()])
}

fn group(name: &[u8], members: &[u16]) -> Vec<u8> {
    chunk(0x4130, &[name, &[0], &list(members, |m| m.to_le_bytes())])
}

fn material(name: &[u8]) -> Vec<u8> {
    chunk(0xafff, &[&chunk(0xa000, &[name, &[0]])])
}

/// A file with one object of these triangle chunks, and other chunks after it.
fn file(triangles: &[&[u8]], after: &[&[u8]]) -> Vec<u8> {
    let object = chunk(0x4000, &[b"thing\0", &chunk(0x4100, triangles)]);
    chunk(0x4d4d, &[&chunk(0x3d3d, &[&object, &after.concat()])])
}

const SQUARE: [[f32; 3]; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];

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
    assert_eq!(document.warnings.count(WarningKind::MapSkipped), 2);
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
    let count = |kind| document.warnings.count(kind);
    assert_eq!(count(WarningKind::FaceInTwoGroups), 1);
    assert_eq!(count(WarningKind::GroupBeyondFaces), 1);
    assert_eq!(count(WarningKind::UnknownMaterial), 1);
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
    assert_eq!((face.corners, face.smoothing), ([0, 1, 2], 4));
    for kind in
        [WarningKind::FaceWithoutVertex, WarningKind::FaceNotFinite, WarningKind::FaceWithoutArea]
    {
        assert_eq!(document.warnings.count(kind), 1, "{kind}");
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
    assert_eq!(document.warnings.count(WarningKind::UvCount), 1);
    assert_eq!(document.warnings.count(WarningKind::UvNotFinite), 1);
}

#[test]
fn what_is_not_read_is_said() {
    let object = |id| chunk(0x4000, &[b"x\0", &chunk(id, &[])]);
    let root = chunk(0x4d4d, &[&object(0x4600), &object(0x4700), &chunk(0xb000, &[])]);
    let document = decode(&root).unwrap();
    let kinds: Vec<WarningKind> = document.warnings.iter().map(|(kind, _)| kind).collect();
    let expected =
        [WarningKind::LightSkipped, WarningKind::CameraSkipped, WarningKind::KeyframerSkipped];
    assert_eq!(kinds, expected);
}

#[test]
fn other_files_are_refused() {
    assert_eq!(decode(&[]), Err(Error::TooShort(0)));
    assert_eq!(decode(b"MM"), Err(Error::TooShort(2)));
    assert_eq!(decode(b"solid cube"), Err(Error::NotThreeDs(0x6f73)));
    // A header with a length shorter than itself holds nothing.
    assert!(decode(&[0x4d, 0x4d, 0, 0, 0, 0]).is_err());
}

/// Decoding and smoothing, as an import does. Damage may make the result empty
/// or an error, never a panic.
fn survive(bytes: &[u8]) {
    if let Ok(mut document) = decode(bytes) {
        for mesh in &document.meshes {
            assert!(mesh.faces.len() <= bytes.len() / 8);
            let _ = smoothing::corner_normals(mesh, &mut document.warnings);
        }
    }
}

#[test]
fn every_beginning_of_a_file_is_survived() {
    for bytes in [CUBE, ENEMY] {
        for end in 0..bytes.len() {
            survive(&bytes[..end]);
        }
    }
}

#[test]
fn changed_bytes_are_survived() {
    let mut sampler = Sampler::new(3, Purpose::Test, 0, 0);
    for bytes in [CUBE, ENEMY] {
        for _ in 0..3000 {
            let mut changed = bytes.to_vec();
            for _ in 0..4 {
                let place = (sampler.next_1d() * bytes.len() as f32) as usize;
                changed[place] = (sampler.next_1d() * 256.0) as u8;
            }
            survive(&changed);
        }
    }
}

#[test]
fn absurd_lengths_and_counts_are_survived() {
    for length in [0_u32, 5, 6, 0x7fff_ffff, 0xffff_ffff] {
        for place in 0..CUBE.len() - 4 {
            let mut changed = CUBE.to_vec();
            changed[place..place + 4].copy_from_slice(&length.to_le_bytes());
            survive(&changed);
        }
    }
}
