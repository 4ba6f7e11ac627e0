//! The keyframer of files that are written here.

use super::scene::full;
use super::writer::{chunk, floats, node, still, track};
use super::*;
use crate::three_ds::keyframer::{Node, NodeKind, TrackKind, Value};

fn keyframer(chunks: &[Vec<u8>]) -> (Keyframer, Warnings) {
    let bytes = chunk(0x4d4d, &[&chunk(0xb000, &[&chunks.concat()])]);
    let document = decode(&bytes).unwrap();
    (document.keyframer.unwrap(), document.warnings)
}

#[test]
fn the_header_and_the_nodes() {
    let keyframer = decode(&full()).unwrap().keyframer.unwrap();
    assert_eq!((keyframer.revision, keyframer.name.as_str()), (Some(5), "MAXSCENE"));
    assert_eq!((keyframer.frames, keyframer.segment), (Some(100), Some([1, 9])));
    assert_eq!(keyframer.current_frame, Some(4));
    let summary = |node: &Node| (node.id, node.instance.clone(), node.parent, node.is_group());
    let nodes: Vec<_> = keyframer.nodes.iter().map(summary).collect();
    let expected = [
        (Some(0), "group".to_string(), None, true),
        (Some(1), "first".to_string(), Some(0), false),
        (Some(2), String::new(), Some(0), false),
    ];
    assert_eq!(nodes, expected);
}

#[test]
fn every_kind_of_node_is_read() {
    let chunks: Vec<_> = (0xb001..=0xb007).map(|id| chunk(id, &[])).collect();
    let kinds: Vec<NodeKind> = keyframer(&chunks).0.nodes.iter().map(|node| node.kind).collect();
    let expected = [
        NodeKind::Ambient,
        NodeKind::Object,
        NodeKind::Camera,
        NodeKind::CameraTarget,
        NodeKind::Light,
        NodeKind::SpotTarget,
        NodeKind::SpotLight,
    ];
    assert_eq!(kinds, expected);
}

#[test]
fn a_node_with_all_it_can_have() {
    let header = chunk(0xb010, &[b"arm\0", &[0, 0x48, 1, 0, 0xff, 0xff]]);
    let chunks = [
        header,
        chunk(0xb013, &[&floats(&[1.0, 2.0, 3.0])]),
        chunk(0xb014, &[&floats(&[-1.0, -2.0, -3.0, 4.0, 5.0, 6.0])]),
        chunk(0xb015, &[&floats(&[0.5])]),
        still(0xb021, &[0.25, 0.0, 0.0, 1.0]),
        chunk(0xb029, &[&track(1, &[vec![0; 6]])]),
    ];
    let (keyframer, warnings) = keyframer(&[chunk(0xb002, &[&chunks.concat()])]);
    let node = &keyframer.nodes[0];
    assert_eq!((node.name.as_str(), node.flags, node.parent_id), ("arm", [0x4800, 1], None));
    assert!(node.is_hidden() && !node.is_group());
    assert_eq!(node.pivot, Vec3::new(1.0, 2.0, 3.0));
    assert_eq!(node.bounds, Some([Vec3::new(-1.0, -2.0, -3.0), Vec3::new(4.0, 5.0, 6.0)]));
    assert_eq!(node.morph_smoothing, Some(0.5));
    let turn = &node.track(TrackKind::Rotation).unwrap().keys[0].value;
    assert_eq!(*turn, Value::Turn { angle: 0.25, axis: Vec3::Z });
    assert_eq!(node.track(TrackKind::Hide).unwrap().keys[0].value, Value::Change);
    assert_eq!(node.track(TrackKind::Morph), None);
    assert_eq!(warnings, Warnings::default());
}

#[test]
fn parents_that_make_no_sense_are_opened() {
    let nodes = [node(b"a", 0, 1, &[]), node(b"b", 1, 0, &[]), node(b"c", 2, 77, &[])];
    let (keyframer, warnings) = keyframer(&nodes);
    let parents: Vec<_> = keyframer.nodes.iter().map(|node| node.parent).collect();
    assert_eq!(parents, [Some(1), None, None]);
    assert_eq!(warnings.count(&WarningKind::ParentLoop), 1);
    assert_eq!(warnings.count(&WarningKind::ParentUnknown), 1);
}

#[test]
fn two_keyframer_sections_are_one() {
    let section = |id| chunk(0xb000, &[&node(b"x", id, 0xffff, &[])]);
    let document = decode(&chunk(0x4d4d, &[&section(0), &section(1)])).unwrap();
    assert_eq!(document.keyframer.unwrap().nodes.len(), 2);
}
