#!/usr/bin/env bash
# gltf 1.4.1 (Rust): parts that a file may leave out, and names that it may choose.
#
# Guess: what the specification makes optional may be missing, and attributes of one's own
# are skipped.
# Found: a scene without nodes, an attribute `_BATCHID`, and an accessor of zeros, without
# a view and without sparse values, are each an error of the whole file; the same file
# without them is read.
# Valid: glTF 2.0: scene.nodes is optional (5.27.1), application-specific attribute names begin
# with an underscore (3.7.2.1), and an accessor without bufferView is all zeros (3.6.2.3).
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"

rust_program 'gltf = "=1.4.1"' <<'RUST'
fn reads(scene: &str, attributes: &str, view: &str) -> bool {
    let text = format!(
        r#"{{"asset":{{"version":"2.0"}},"scenes":[{scene}],"nodes":[{{"mesh":0}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0{attributes}}}}}]}}],
        "accessors":[{{{view}"componentType":5126,"count":3,"type":"VEC3",
        "min":[0,0,0],"max":[0,0,0]}}],
        "bufferViews":[{{"buffer":0,"byteLength":36}}],
        "buffers":[{{"byteLength":36,"uri":"zeros.bin"}}]}}"#
    );
    gltf::Gltf::from_slice(text.as_bytes()).is_ok()
}

fn main() {
    let (scene, view) = (r#"{"nodes":[0]}"#, r#""bufferView":0,"#);
    println!("plain {}", reads(scene, "", view));
    println!("scene without nodes {}", reads("{}", "", view));
    println!("attribute of one's own {}", reads(scene, r#","_BATCHID":0"#, view));
    println!("accessor of zeros {}", reads(scene, "", ""));
}
RUST

found=$(./program)
wanted="plain true
scene without nodes false
attribute of one's own false
accessor of zeros false"
[ "$found" = "$wanted" ] || { echo "changed: $found"; exit 1; }
echo "as stated: $found"
