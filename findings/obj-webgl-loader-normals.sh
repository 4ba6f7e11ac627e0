#!/usr/bin/env bash
# webgl-obj-loader 2.0.8 (npm).
#
# The guess: a corner that names no normal gets no normal.
# Observed: the last number of the corner is taken for the normal's, whatever it is
# the number of, without an error: in a file whose other faces have normals the
# corner `4/2` gets the second normal of the file, and the corner `4` the fourth. A
# wall whose corners give no normals is shaded by normals of other walls.
#
# Why the input is valid: Wavefront, Advanced Visualizer manual, appendix B1, f
# v1/vt1/vn1: texture and normal are optional, the first number is the vertex, the
# second the texture coordinate; faces of one file may differ in it.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages webgl-obj-loader@2.0.8

cat > check.mjs <<'JS'
import loader from 'webgl-obj-loader';

const head = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n'
    + 'vn 1 0 0\nvn 0 1 0\nvn 0 0 1\nvn 0 0 -1\nf 1/1/3 2/2/3 3/3/3\n';
const normals = (face) => {
    const { vertexNormals } = new loader.Mesh(`${head}${face}\n`);
    const found = [3, 4, 5].map((place) => vertexNormals.slice(3 * place, 3 * place + 3).join(' ')).join(', ');
    console.log(`${face}: normals ${found}`);
    return found;
};
const expect = (face, expected) => {
    if (normals(face) !== expected) {
        console.error(`changed: normals of ${face}`);
        process.exit(1);
    }
};
expect('f 1/1/4 3/3/4 4/2/4', '0 0 -1, 0 0 -1, 0 0 -1');
expect('f 1/1 3/3 4/2', '1 0 0, 0 0 1, 0 1 0');
expect('f 1 3 4', '1 0 0, 0 0 1, 0 0 -1');
JS
node check.mjs
