//! Files that are cut, changed or made to do harm.

use super::scene::full;
use super::writer::{SQUARE, chunk, faces, file, group, material, node, object, still, vertices};
use super::*;
use traylib_math::Sampler;

/// Does all that is done with a file: damage may make the result empty or an error, never a panic.
fn survive(bytes: &[u8]) {
    if let Ok(mut document) = decode(bytes) {
        for mesh in &document.meshes {
            assert!(mesh.faces.len() <= bytes.len() / 8);
            let _ = smoothing::corner_normals(mesh, &mut document.warnings);
        }
        let instances = pose::stored_with_instances(&document);
        assert!(instances.iter().all(|placed| placed.place.is_finite()));
        let shown = instances.iter().filter(|placed| pose::is_shown(&document, placed)).count();
        assert!(shown <= pose::at_start(&document).len());
        assert!(Counts::of(&document).faces <= bytes.len() / 8);
    }
}

#[test]
fn every_beginning_of_a_file_is_survived() {
    for bytes in [CUBE, ENEMY, &full()] {
        for end in 0..bytes.len() {
            survive(&bytes[..end]);
        }
    }
}

#[test]
fn a_cut_file_keeps_what_is_there() {
    let bytes = full();
    let document = decode(&bytes[..bytes.len() - 1]).unwrap();
    assert_eq!((document.meshes.len(), document.lights.len()), (2, 2));
    assert!(document.warnings.count(&WarningKind::ChunkCut) > 0);
}

#[test]
fn changed_bytes_are_survived() {
    let mut sampler = Sampler::numbered(3, 0);
    for bytes in [CUBE, ENEMY, &full()] {
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
    for bytes in [CUBE, &full()] {
        for length in [0_u32, 5, 6, 0x7fff_ffff, 0xffff_ffff] {
            for place in 0..bytes.len() - 4 {
                let mut changed = bytes.to_vec();
                changed[place..place + 4].copy_from_slice(&length.to_le_bytes());
                survive(&changed);
            }
        }
    }
}

/// Numbers that are none wherever a number could be.
#[test]
fn numbers_that_are_none_are_survived() {
    let bytes = full();
    for number in [f32::NAN, f32::INFINITY, f32::MAX, -f32::MIN_POSITIVE, 1e-45] {
        for place in 0..bytes.len() - 4 {
            let mut changed = bytes.clone();
            changed[place..place + 4].copy_from_slice(&number.to_le_bytes());
            survive(&changed);
        }
    }
}

/// The figures of a file with one object of these triangle chunks, and how often
/// a kind was warned about.
fn counted(triangles: &[&[u8]], kind: WarningKind) -> (Counts, u32) {
    let document = decode(&file(triangles, &[])).unwrap();
    (Counts::of(&document), document.warnings.count(&kind))
}

#[test]
fn lists_that_claim_more_than_there_is() {
    let claim = |mut chunk: Vec<u8>| {
        chunk[6..8].copy_from_slice(&u16::MAX.to_le_bytes());
        chunk
    };
    let (corners, uvs) = (faces(&[[0, 1, 2]], &[]), chunk(0x4140, &[&[1, 0], &[0; 8]]));
    let (points, cut) = (vertices(&SQUARE), WarningKind::ListCut);
    let (counts, cuts) = counted(&[&claim(points.clone()), &corners], cut);
    assert_eq!((counts.vertices, counts.faces, cuts), (4, 1, 1));
    let (counts, cuts) = counted(&[&points, &claim(corners.clone())], cut);
    assert_eq!((counts.vertices, counts.faces, cuts), (4, 1, 1));
    let (counts, cuts) = counted(&[&points, &corners, &claim(uvs)], cut);
    assert_eq!((counts.faces, counts.texcoords, cuts), (1, 4, 1));
}

#[test]
fn a_mesh_of_nothing_and_one_of_vertices_alone_keep_their_names() {
    let document = decode(&file(&[], &[])).unwrap();
    assert_eq!((document.meshes[0].name.as_str(), document.warnings.iter().count()), ("plate", 0));
    let many = vec![[0.5; 3]; usize::from(u16::MAX)];
    let (counts, _) = counted(&[&vertices(&many)], WarningKind::ListCut);
    assert_eq!((counts.meshes, counts.vertices, counts.faces), (1, 65_535, 0));
}

#[test]
fn too_few_masks_leave_the_rest_flat() {
    let masks = chunk(0x4150, &[&[1, 0, 0, 0]]);
    let corners = faces(&[[0, 1, 2], [0, 2, 3]], &[&masks]);
    let document = decode(&file(&[&vertices(&SQUARE), &corners], &[])).unwrap();
    let masks: Vec<u32> = document.meshes[0].faces.iter().map(|face| face.smoothing).collect();
    assert_eq!((masks, document.warnings.count(&WarningKind::ListCut)), (vec![1, 0], 1));
}

#[test]
fn names_may_repeat_be_long_foreign_or_without_end() {
    let triangles = chunk(0x4100, &[&vertices(&SQUARE), &faces(&[[0, 1, 2]], &[])]);
    let long: &[u8] = b"a name of far more than ten characters";
    let objects =
        [object(long, &[&triangles]), object(long, &[&triangles]), object(b"\xd6l", &[&triangles])];
    let endless = chunk(0x4000, &[b"endless"]);
    let document = decode(&chunk(0x4d4d, &[&objects.concat(), &endless])).unwrap();
    let names: Vec<&str> = document.meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    let long = "a name of far more than ten characters";
    assert_eq!(names, [long, long, "Öl"]);
}

#[test]
fn a_name_is_not_copied_without_bound() {
    let name = vec![b'n'; 20_000];
    let bodies = chunk(0x4100, &[]).repeat(3000);
    let document = decode(&chunk(0x4d4d, &[&object(&name, &[&bodies])])).unwrap();
    assert_eq!(document.meshes.len(), 3000);
    let copied: usize = document.meshes.iter().map(|mesh| mesh.name.len()).sum();
    assert!(copied < 3000 * 256, "{copied}");
}

#[test]
fn groups_of_faces_that_are_not_there_are_counted() {
    let corners = faces(&[[0, 1, 2]], &[&group(b"m", &[0, 1, 65_535])]);
    let document = decode(&file(&[&vertices(&SQUARE), &corners], &[&material(b"m")])).unwrap();
    assert_eq!(document.meshes[0].faces[0].material, Some(0));
    assert_eq!(document.warnings.count(&WarningKind::GroupBeyondFaces), 2);
}

#[test]
fn files_of_other_machines_with_the_same_ending_are_refused() {
    // A program for a handheld console begins with the size of its own header.
    assert_eq!(decode(&[0x20, 0x20, 0, 0, 1, 0]), Err(Error::NotThreeDs(0x2020)));
}

#[test]
fn keys_and_parents_without_sense_leave_the_mesh_placed() {
    let place = still(0xb020, &[f32::NAN, 0.0, 0.0]);
    let nodes = chunk(0xb000, &[&node(b"plate", 0, 0, &[&place])]);
    let bytes = chunk(0x4d4d, &[&file(&[&vertices(&SQUARE)], &[])[6..], &nodes]);
    let document = decode(&bytes).unwrap();
    let placed = pose::at_start(&document);
    assert_eq!((placed.len(), placed[0].place), (1, Affine::IDENTITY));
    for kind in [WarningKind::NumberNotFinite, WarningKind::ParentLoop] {
        assert_eq!(document.warnings.count(&kind), 1, "{kind}");
    }
}

#[test]
fn a_library_without_meshes_has_its_materials() {
    let document = decode(&chunk(0x3daa, &[&material(b"a"), &material(b"a")])).unwrap();
    assert_eq!((document.materials.len(), document.meshes.len()), (2, 0));
    assert_eq!(document.warnings, Warnings::default());
}

#[test]
fn many_things_in_little_room_stay_small() {
    let repeated = |id, body: &[u8]| chunk(id, &[body]).repeat(5000);
    let costly = [
        repeated(0xafff, &[]),
        object(b"", &[&repeated(0x4100, &[])]),
        object(b"", &[&repeated(0x4600, &[0; 12])]),
        object(b"", &[&repeated(0x4700, &[0; 24])]),
        chunk(0xb000, &[&repeated(0xb002, &[])]),
    ];
    for chunks in costly {
        let bytes = chunk(0x4d4d, &[&chunks]);
        let document = decode(&bytes).unwrap();
        let size = size_of_val(&document.meshes[..])
            + size_of_val(&document.materials[..])
            + size_of_val(&document.lights[..])
            + size_of_val(&document.cameras[..])
            + document.keyframer.map_or(0, |keyframer| size_of_val(&keyframer.nodes[..]));
        assert!((5000..64 * bytes.len()).contains(&size), "{size} of {}", bytes.len());
    }
}
