#!/usr/bin/env bash
# tobj 4.0.5: polylines and texture coordinates in part of the corners.
#
# Guess: a polyline is no face, and with `single_index` every list of a mesh that is not
# empty has an entry for each vertex, so that uvs[vertex] is the one of that vertex.
# Found: `l 1 2 3` becomes a face of three corners among the others, a triangle to whoever
# asks for triangles. Of a mesh whose first face has no texture coordinates and whose second
# one has, six positions come and three pairs of coordinates: those of the fourth vertex
# stand first.
# Valid: `l v1 v2 v3` is a polyline, and corners may be given as `v` in one face and `v/vt`
# in another (Wavefront, Advanced Visualizer manual, appendix B1).
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"

rust_program 'tobj = "=4.0.5"' <<'RUST'
use tobj::{LoadOptions, load_obj_buf};

fn mesh(text: &str) -> tobj::Mesh {
    let options = LoadOptions { triangulate: true, single_index: true, ..LoadOptions::default() };
    let none = |_: &std::path::Path| unreachable!();
    let (models, _) = load_obj_buf(&mut text.as_bytes(), &options, none).unwrap();
    models[0].mesh.clone()
}

fn main() {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    let line = mesh(&format!("{corners}f 1 2 3\nl 2 4 3\n"));
    let uvs = "vt 0.1 0\nvt 0.2 0\nvt 0.3 0\n";
    let part = mesh(&format!("{corners}{uvs}f 1 2 3\nf 2/1 4/2 3/3\n"));
    println!("faces {}", line.indices.len() / 3);
    println!("positions {} coordinates {}", part.positions.len() / 3, part.texcoords.len() / 2);
}
RUST

found=$(./program)
wanted='faces 2
positions 6 coordinates 3'
[ "$found" = "$wanted" ] || { echo "changed: $found"; exit 1; }
echo "as stated: $found"
