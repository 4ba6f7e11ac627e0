//! Nodes of real files.

use super::super::super::keyframer::{Node, NodeKind};
use super::expected::{
    check, expectations, find, folder, get, list_of, numbers, optional, text_of,
};
use ron::Value;
use std::collections::BTreeMap;

#[test]
fn every_node_agrees() {
    let Some(folder) = folder() else { return };
    for (name, document, expected) in expectations(&folder) {
        let expected = list_of(get(get(&expected, "detail"), "nodes"));
        let nodes = document.keyframer.map_or_else(Vec::new, |keyframer| keyframer.nodes);
        assert_eq!(nodes.len(), expected.len(), "{name}");
        for (node, expected) in nodes.iter().zip(expected) {
            check_node(&format!("{name}: {}", node.name), node, expected);
        }
    }
}

fn check_node(name: &str, node: &Node, expected: &Value) {
    assert_eq!(kind_name(node.kind), text_of(get(expected, "kind")), "{name}");
    assert_eq!(node.name, text_of(get(expected, "name")));
    let instance = find(expected, "instance").map(text_of).unwrap_or_default();
    assert_eq!(node.instance, instance, "{name}");
    check(name, &optional(node.id), get(expected, "id"));
    check(name, &[f32::from(node.flags[0])], get(expected, "flags1"));
    check(name, &[f32::from(node.flags[1])], get(expected, "flags2"));
    check(name, &[node.parent_id.map_or(-1.0, f32::from)], get(expected, "parent"));
    assert_eq!(node.parent.is_some(), node.parent_id.is_some(), "{name}");
    if let Some(pivot) = find(expected, "pivot") {
        check(name, &node.pivot.to_array(), pivot);
    }
    let Value::Map(tracks) = get(expected, "tracks") else { panic!("{name}: no tracks") };
    let expected: BTreeMap<String, Vec<f64>> =
        tracks.iter().map(|(id, keys)| (text_of(id), numbers(keys))).collect();
    let found = node.tracks.iter();
    let found = found.map(|t| (format!("{:04X}", t.kind.id()), vec![t.keys.len() as f64]));
    assert_eq!(found.collect::<BTreeMap<_, _>>(), expected, "{name}");
}

fn kind_name(kind: NodeKind) -> &'static str {
    match kind {
        NodeKind::Ambient => "ambient",
        NodeKind::Object => "object",
        NodeKind::Camera => "camera",
        NodeKind::CameraTarget => "camera_target",
        NodeKind::Light => "light",
        NodeKind::SpotTarget => "spot_target",
        NodeKind::SpotLight => "spot_light",
    }
}
