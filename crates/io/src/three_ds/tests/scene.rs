//! A small file with something of everything, written here.

use super::writer::{
    SQUARE, chunk, faces, floats, group, list, material, node, object, still, vertices,
};
use super::*;
use traylib_math::Vec2;

fn mesh(name: &[u8], x: f32) -> Vec<u8> {
    let moved = SQUARE.map(|[a, b, c]| [a + x, b, c]);
    let axes = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, x, 0.0, 0.0];
    let uvs = list(&[[0.0_f32, 1.0]; 4], |[u, v]| {
        let mut bytes = [0; 8];
        bytes[..4].copy_from_slice(&u.to_le_bytes());
        bytes[4..].copy_from_slice(&v.to_le_bytes());
        bytes
    });
    let masks = [1, 0, 0, 0, 1, 0, 0, 0];
    let inside = [group(b"paint", &[0, 1]), chunk(0x4150, &[&masks])].concat();
    let triangles = [
        vertices(&moved),
        faces(&[[0, 1, 2], [0, 2, 3]], &[&inside]),
        chunk(0x4140, &[&uvs]),
        chunk(0x4160, &[&floats(&axes)]),
    ];
    object(name, &[&chunk(0x4100, &[&triangles.concat()]), &chunk(0x4014, &[])])
}

fn paint() -> Vec<u8> {
    let map = |id, file: &[u8]| chunk(id, &[&chunk(0xa300, &[file, &[0]])]);
    let maps = [map(0xa200, b"WOOD.TGA"), map(0xa230, b"BUMP.TGA"), map(0xa33e, b"MASK.TGA")];
    chunk(0xafff, &[&chunk(0xa000, &[b"paint\0"]), &maps.concat()])
}

fn lights() -> Vec<u8> {
    let spot = chunk(0x4610, &[&floats(&[0.0, 0.0, 0.0, 40.0, 50.0])]);
    let spot = object(
        b"spot",
        &[&chunk(0x4010, &[]), &chunk(0x4600, &[&floats(&[0.0, 0.0, 9.0]), &spot])],
    );
    [spot, object(b"omni", &[&chunk(0x4600, &[&floats(&[1.0, 2.0, 3.0])])])].concat()
}

/// Two meshes, a material, two lights, a camera; one mesh has two nodes, under a
/// group.
pub(super) fn full() -> Vec<u8> {
    let camera = chunk(0x4700, &[&floats(&[0.0, -9.0, 1.0, 0.0, 0.0, 1.0, 15.0, 48.0])]);
    let data = [
        chunk(0x3d3e, &[&[3, 0, 0, 0]]),
        chunk(0x0100, &[&floats(&[2.0])]),
        chunk(0x2100, &[&chunk(0x0010, &[&floats(&[0.5, 0.25, 0.0])])]),
        mesh(b"square", 0.0),
        mesh(b"other", 5.0),
        lights(),
        object(b"eye", &[&camera]),
        paint(),
    ];
    let none = 0xffff;
    let nodes = [
        chunk(0xb00a, &[&[5, 0], b"MAXSCENE\0", &[100, 0, 0, 0]]),
        chunk(0xb008, &[&[1, 0, 0, 0, 9, 0, 0, 0]]),
        chunk(0xb009, &[&[4, 0, 0, 0]]),
        node(b"$$$DUMMY", 0, none, &[&chunk(0xb011, &[b"group\0"])]),
        node(b"square", 1, 0, &[&chunk(0xb011, &[b"first\0"])]),
        node(b"square", 2, 0, &[&still(0xb020, &[0.0, 0.0, 7.0])]),
    ];
    let parts = [chunk(0x0002, &[&[3, 0, 0, 0]]), chunk(0x3d3d, &[&data.concat()])];
    chunk(0x4d4d, &[&parts.concat(), &chunk(0xb000, &[&nodes.concat()])])
}

#[test]
fn everything_is_counted() {
    let document = decode(&full()).unwrap();
    assert_eq!(document.warnings, Warnings::default());
    let expected = Counts {
        version: Some(3),
        mesh_version: Some(3),
        master_scale: Some(2.0),
        ambient: Some([0.5, 0.25, 0.0]),
        meshes: 2,
        vertices: 8,
        faces: 4,
        texcoords: 8,
        materials: 1,
        lights: 2,
        spot_lights: 1,
        cameras: 1,
        keyframer_nodes: 3,
        texture_files: ["BUMP.TGA", "MASK.TGA", "WOOD.TGA"].map(String::from).to_vec(),
        bbox_stored_vertices: Some([0.0, 0.0, 0.0, 6.0, 1.0, 0.0]),
        pose_at_frame_0: Some(PoseCounts {
            mesh_nodes: 2,
            meshes_without_node: 1,
            max_shift_of_a_vertex: 7.0,
            bbox_frame0: Some([0.0, 0.0, 0.0, 1.0, 1.0, 7.0]),
        }),
    };
    assert_eq!(Counts::of(&document), expected);
}

#[test]
fn nothing_is_counted_in_an_empty_file() {
    let counts = Counts::of(&decode(&chunk(0x4d4d, &[])).unwrap());
    assert_eq!((counts.meshes, counts.keyframer_nodes, counts.version), (0, 0, None));
    assert_eq!((counts.bbox_stored_vertices, counts.pose_at_frame_0), (None, None));
}

#[test]
fn a_mesh_has_all_its_parts() {
    let document = decode(&full()).unwrap();
    let other = &document.meshes[1];
    let expected = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::new(5.0, 0.0, 0.0)];
    assert_eq!((other.name.as_str(), other.axes), ("other", Some(expected)));
    assert_eq!(other.uvs, [Vec2::Y; 4]);
    let face = Face { corners: [0, 2, 3], smoothing: 1, material: Some(0), flags: 7 };
    assert_eq!(other.faces[1], face);
    assert!(other.flags.matte && !other.flags.hidden);
}

#[test]
fn lights_and_cameras_have_their_objects_name_and_marks() {
    let document = decode(&full()).unwrap();
    let lights: Vec<_> =
        document.lights.iter().map(|light| (light.name.as_str(), light.flags.hidden)).collect();
    assert_eq!(lights, [("spot", true), ("omni", false)]);
    let camera = &document.cameras[0];
    assert_eq!(
        (camera.name.as_str(), camera.fov_degrees(), camera.roll_degrees),
        ("eye", 50.0, 15.0)
    );
}

#[test]
fn what_is_beyond_the_limit_is_skipped() {
    for items in 0..9 {
        let document = decode_within(&full(), Limits { items, ..Limits::default() }).unwrap();
        let nodes = document.keyframer.map_or(0, |keyframer| keyframer.nodes.len());
        let (meshes, lights) = (document.meshes.len(), document.lights.len());
        let found = meshes + lights + document.cameras.len() + document.materials.len() + nodes;
        assert_eq!(found, items);
        assert_eq!(document.warnings.count(&WarningKind::TooManyItems) as usize, 9 - items);
    }
}

#[test]
fn materials_and_objects_may_stand_under_the_root_and_in_a_library() {
    for root in [0x4d4d, 0x3daa, 0xc23d] {
        let document = decode(&chunk(root, &[&material(b"a"), &mesh(b"m", 0.0)])).unwrap();
        assert_eq!((document.materials.len(), document.meshes.len()), (1, 1), "{root:x}");
    }
}

#[test]
fn a_box_map_is_data() {
    let names = chunk(0x41a0, &[b"a\0b\0c\0d\0e\0f\0"]);
    let corners = faces(&[[0, 1, 2]], &[&names]);
    let document = decode(&file(&[&vertices(&SQUARE), &corners], &[])).unwrap();
    assert_eq!(document.meshes[0].box_map, ["a", "b", "c", "d", "e", "f"]);
}

/// Vertices stand in the world whatever their axes are. Mirrored ones turn the faces of
/// three 0.187.0's TDSLoader inside out, and lib3ds 1.3 mirrors the vertices.
#[test]
fn local_axes_of_no_use_are_warned_about() {
    let with = |axes: [f32; 9]| {
        let axes = chunk(0x4160, &[&floats(&axes), &floats(&[1.0, 2.0, 3.0])]);
        decode(&file(&[&vertices(&SQUARE), &axes], &[])).unwrap()
    };
    let mirrored = with([-2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0]);
    assert_eq!(mirrored.warnings.count(&WarningKind::MatrixMirrored), 1);
    assert_eq!(mirrored.meshes[0].vertices[2], Vec3::new(1.0, 1.0, 0.0));
    let singular = with([1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    assert_eq!(singular.warnings.count(&WarningKind::MatrixSingular), 1);
    assert_eq!(singular.meshes[0].local_to_world(), Affine::IDENTITY);
    let absurd = with([f32::NAN; 9]);
    assert_eq!(absurd.warnings.count(&WarningKind::NumberNotFinite), 1);
    assert_eq!(absurd.meshes[0].axes, None);
}
