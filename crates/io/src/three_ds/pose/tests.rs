use super::super::keyframer::{Keyframer, NodeKind};
use super::super::tests::writer::{SQUARE, chunk, faces, floats, node, object, still, vertices};
use super::super::{Warnings, decode};
use super::*;
use std::f32::consts::FRAC_PI_2;
use traylib_math::Vec3;

const NONE: u16 = 0xffff;

/// A file with a square of local axes of its own, and these nodes.
fn document(axes: [f32; 12], nodes: &[Vec<u8>]) -> Document {
    let axes = chunk(0x4160, &[&floats(&axes)]);
    let triangles = [vertices(&SQUARE), faces(&[[0, 1, 2]], &[]), axes].concat();
    let mesh = object(b"square", &[&chunk(0x4100, &[&triangles])]);
    decode(&chunk(0x4d4d, &[&mesh, &chunk(0xb000, &[&nodes.concat()])])).unwrap()
}

const AT_ONE: [f32; 12] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0];

fn corners(document: &Document, placed: &Placed) -> Vec<[f32; 3]> {
    let mesh = document.meshes[placed.mesh].placed(&placed.place);
    // Rounded, and without a sign of 0.
    mesh.vertices.iter().map(|v| v.to_array().map(|x| (x * 1e4).round() / 1e4 + 0.0)).collect()
}

fn moved(id: u16, position: [f32; 3]) -> Vec<u8> {
    node(b"square", id, NONE, &[&still(0xb020, &position)])
}

#[test]
fn a_node_at_the_meshs_own_place_changes_nothing() {
    let document = document(AT_ONE, &[moved(0, [1.0, 1.0, 0.0])]);
    let [placed] = at_start(&document)[..] else { panic!("not one mesh") };
    assert_eq!((placed.mesh, placed.node), (0, Some(0)));
    assert_eq!(placed.place, Affine::IDENTITY);
}

#[test]
fn meshes_turn_about_their_pivot() {
    let pivot = chunk(0xb013, &[&floats(&[-1.0, -1.0, 0.0])]);
    let turn = still(0xb021, &[-FRAC_PI_2, 0.0, 0.0, 2.0]);
    let document = document(AT_ONE, &[node(b"square", 0, NONE, &[&pivot, &turn])]);
    let placed = at_start(&document);
    // Its first corner is the pivot and goes to 0; the turn is counter-clockwise.
    let expected = [[0.0; 3], [0.0, 1.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, 0.0, 0.0]];
    assert_eq!(corners(&document, &placed[0]), expected);
}

#[test]
fn groups_take_their_meshes_along() {
    let group = node(b"$$$DUMMY", 5, NONE, &[&still(0xb020, &[0.0, 0.0, 3.0])]);
    let child = node(b"square", 6, 5, &[&still(0xb020, &[1.0, 1.0, 0.0])]);
    let document = document(AT_ONE, &[child, group]);
    let [placed] = at_start(&document)[..] else { panic!("not one mesh") };
    assert_eq!(corners(&document, &placed)[0], [0.0, 0.0, 3.0]);
}

#[test]
fn a_mesh_that_nothing_moves_stays() {
    let still = document(AT_ONE, &[node(b"other", 0, NONE, &[])]);
    let expected = [Placed { mesh: 0, node: None, place: Affine::IDENTITY }];
    assert_eq!(at_start(&still), expected);
    assert_eq!(stored_with_instances(&still), expected);
}

#[test]
fn only_object_nodes_move_meshes() {
    let mut document = document(AT_ONE, &[moved(0, [9.0; 3])]);
    let nodes = &mut document.keyframer.as_mut().unwrap().nodes;
    nodes[0].kind = NodeKind::Light;
    assert_eq!(at_start(&document)[0].node, None);
}

#[test]
fn instances_stand_as_far_from_the_stored_mesh_as_from_the_first() {
    let document = document(AT_ONE, &[moved(0, [5.0, 0.0, 0.0]), moved(1, [5.0, 0.0, 2.0])]);
    let places = |placed: Vec<Placed>| -> Vec<[f32; 3]> {
        placed.iter().map(|placed| corners(&document, placed)[0]).collect()
    };
    assert_eq!(places(at_start(&document)), [[4.0, -1.0, 0.0], [4.0, -1.0, 2.0]]);
    assert_eq!(places(stored_with_instances(&document)), [[0.0; 3], [0.0, 0.0, 2.0]]);
}

#[test]
fn instances_of_a_flattened_first_are_left_out() {
    let flat = node(b"square", 0, NONE, &[&still(0xb022, &[0.0, 1.0, 1.0])]);
    let document = document(AT_ONE, &[flat, moved(1, [0.0; 3])]);
    assert_eq!(stored_with_instances(&document).len(), 1);
    assert_eq!(at_start(&document).len(), 2);
}

#[test]
fn a_mirroring_node_keeps_fronts_outside() {
    let mirror = node(b"square", 0, NONE, &[&still(0xb022, &[-1.0, 1.0, 1.0])]);
    let document = document(AT_ONE, &[mirror]);
    let posed = document.meshes[0].placed(&at_start(&document)[0].place);
    assert_eq!(posed.faces[0].corners, [0, 2, 1]);
    assert_eq!(posed.vertices[0], Vec3::new(1.0, -1.0, 0.0));
}

#[test]
fn hidden_meshes_are_not_shown() {
    let shown = |document: &Document| {
        at_start(document).iter().filter(|placed| is_shown(document, placed)).count()
    };
    let mut document = document(AT_ONE, &[moved(0, [0.0; 3]), moved(1, [1.0; 3])]);
    assert_eq!(shown(&document), 2);
    document.keyframer.as_mut().unwrap().nodes[0].flags[0] = 0x0800;
    assert_eq!(shown(&document), 1);
    document.meshes[0].flags.hidden = true;
    assert_eq!(shown(&document), 0);
}

#[test]
fn numbers_too_large_leave_the_mesh_where_it_is_stored() {
    let tiny = [1e-38, 0.0, 0.0, 0.0, 1e-38, 0.0, 0.0, 0.0, 1e-38, 0.0, 0.0, 0.0];
    let scales = [f32::MAX; 3];
    let parents: Vec<_> = (0..9_u16)
        .map(|id| {
            node(b"$$$DUMMY", id, id.checked_sub(1).unwrap_or(NONE), &[&still(0xb022, &scales)])
        })
        .collect();
    let child = node(b"square", 9, 8, &[]);
    let document = document(tiny, &[parents, vec![child]].concat());
    assert_eq!(document.warnings, Warnings::default());
    let [placed] = at_start(&document)[..] else { panic!("not one mesh") };
    assert!(placed.place.is_finite());
    let empty = Document { keyframer: Some(Keyframer::default()), ..Document::default() };
    assert_eq!(at_start(&empty), []);
}

#[test]
fn meshes_are_not_multiplied_without_bound() {
    let many = vec![[0.5; 3]; 1 << 15];
    let mesh = object(b"square", &[&chunk(0x4100, &[&vertices(&many)])]);
    let nodes: Vec<_> = (0..600).map(|id| moved(id, [0.0; 3])).collect();
    let bytes = chunk(0x4d4d, &[&mesh, &chunk(0xb000, &[&nodes.concat()])]);
    let document = decode(&bytes).unwrap();
    assert_eq!(at_start(&document).len(), 1 + (MOST_MULTIPLIED >> 15));
}
