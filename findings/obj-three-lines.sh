#!/usr/bin/env bash
# three 0.187.0 (npm).
#
# The guess: an object of an OBJ that has a polyline beside its faces becomes a mesh
# and lines.
# Observed: one `l` makes lines of the whole object, without an error: its two
# triangles are no surface any more, a ray through the middle of one of them does
# not hit, and their corners are joined in pairs across the triangles. Without the
# `l`, or with an `o` before it, the triangles are a mesh and are hit.
#
# Why the input is valid: Wavefront, Advanced Visualizer manual, appendix B1: lines
# and faces are elements, and an object or group may have several kinds of them.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages three@0.187.0

cat > check.mjs <<'JS'
import { Raycaster, Vector3 } from 'three';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';

const faces = 'o sign\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n';
const look = (name, text) => {
    const group = new OBJLoader().parse(text);
    group.updateMatrixWorld(true);
    const ray = new Raycaster(new Vector3(3, 1.5, 5), new Vector3(0, 0, -1));
    ray.params.Line.threshold = 1e-3;
    const kinds = group.children.map(({ type }) => type).join(' ');
    const found = `${kinds}, hits ${ray.intersectObject(group, true).length}`;
    console.log(`${name}: ${found}`);
    return found;
};
const expect = (name, text, expected) => {
    if (look(name, text) !== expected) {
        console.error(`changed: ${name}`);
        process.exit(1);
    }
};
expect('faces', faces, 'Mesh, hits 1');
expect('faces and a line', `${faces}l 1 3\n`, 'LineSegments, hits 0');
expect('faces, and a line in its own object', `${faces}o pole\nl 1 3\n`, 'Mesh LineSegments, hits 1');
JS
node check.mjs
