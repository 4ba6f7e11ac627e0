//! Files that other programs wrote, held against what independent readers found
//! in them.
//!
//! They are not part of this repository: `TRAYLIB_DATA` names a folder with
//! `3ds/expected.json` and the files that it speaks of.

mod expected;
mod lights;
mod nodes;
mod surfaces;

use super::super::Counts;
use expected::{check, expectations, find, folder, get, list_of, numbers, optional, text_of};
use ron::Value;

#[test]
fn counts_and_boxes_agree() {
    let Some(folder) = folder() else { return };
    let files = expectations(&folder);
    assert_eq!(files.len(), 25);
    for (name, document, expected) in files {
        let counts = Counts::of(&document);
        let figures = [
            ("meshes", counts.meshes),
            ("vertices", counts.vertices),
            ("faces", counts.faces),
            ("texcoords", counts.texcoords),
            ("materials", counts.materials),
            ("lights", counts.lights),
            ("spot_lights", counts.spot_lights),
            ("cameras", counts.cameras),
            ("keyframer_nodes", counts.keyframer_nodes),
        ];
        for (key, found) in figures {
            assert_eq!(vec![found as f64], numbers(get(&expected, key)), "{name}: {key}");
        }
        let textures: Vec<_> =
            list_of(get(&expected, "texture_files")).iter().map(text_of).collect();
        assert_eq!(counts.texture_files, textures, "{name}");
        check(&name, &optional(counts.version), get(&expected, "version"));
        check(&name, &optional(counts.mesh_version), get(&expected, "mesh_version"));
        check(&name, &optional(counts.master_scale), get(&expected, "master_scale"));
        let ambient = counts.ambient.map_or_else(Vec::new, Vec::from);
        check(&name, &ambient, get(&expected, "ambient"));
        check(&name, &counts.bbox_stored_vertices.unwrap(), get(&expected, "bbox_stored_vertices"));
        check_pose(&name, &counts, &expected);
    }
}

/// Where lib3ds mirrors the stored vertices of an object with mirrored axes, its
/// pose is compared with that of its own vertices: both leave them in place.
fn check_pose(name: &str, counts: &Counts, expected: &Value) {
    let stored = get(expected, "bbox_stored_vertices");
    let mirrored = find(get(expected, "agreement"), "lib3ds_bbox_differs").is_some();
    let expected = get(expected, "pose_at_frame_0");
    let Some(pose) = counts.pose_at_frame_0 else {
        assert_eq!(*expected, Value::Option(None), "{name}");
        return;
    };
    check(name, &[pose.mesh_nodes as f32], get(expected, "mesh_nodes"));
    check(name, &[pose.meshes_without_node as f32], get(expected, "meshes_without_node"));
    check(name, &[pose.max_shift_of_a_vertex], get(expected, "max_shift_of_a_vertex"));
    let bounds = if mirrored { stored } else { get(expected, "bbox_frame0") };
    check(name, &pose.bbox_frame0.unwrap(), bounds);
}
