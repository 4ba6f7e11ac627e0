#!/usr/bin/env bash
# @loaders.gl/ply 4.4.5 with @loaders.gl/core 4.4.5 (npm).
#
# The guess: an element of which a PLY file holds none changes nothing.
# Observed: with `element edge 0` between the vertices and the faces the first face
# is lost, without an error: its line is taken for an edge. With two such elements
# two faces are lost. The binary form of the same file is read in full.
#
# Why the input is valid: "The PLY Polygon File Format" by Turk: a header names the
# elements and how many there are of each; a program that always writes the same
# header has some that are empty.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages @loaders.gl/core@4.4.5 @loaders.gl/ply@4.4.5

cat > check.mjs <<'JS'
import { parse } from '@loaders.gl/core';
import { PLYLoader } from '@loaders.gl/ply';

const header = (format, empty) => `ply
format ${format} 1.0
element vertex 4
property float x
property float y
property float z
${empty}element face 3
property list uchar int vertex_indices
end_header
`;
const ascii = '0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n3 1 2 3\n';
const binary = () => {
    const parts = [Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]).buffer)];
    for (const face of [[0, 1, 2], [0, 2, 3], [1, 2, 3]]) {
        parts.push(Buffer.from([3]), Buffer.from(new Int32Array(face).buffer));
    }
    return Buffer.concat(parts);
};
const edge = 'element edge 0\nproperty int vertex1\nproperty int vertex2\n';
const light = 'element light 0\nproperty float power\n';
const cases = [
    ['no empty element', header('ascii', ''), ascii, '0 1 2 0 2 3 1 2 3'],
    ['one, binary', header('binary_little_endian', edge), binary(), '0 1 2 0 2 3 1 2 3'],
    ['one, ascii', header('ascii', edge), ascii, '0 2 3 1 2 3'],
    ['two, ascii', header('ascii', edge + light), ascii, '1 2 3'],
];
for (const [name, head, body, expected] of cases) {
    const file = new Uint8Array(Buffer.concat([Buffer.from(head), Buffer.from(body)])).buffer;
    const mesh = await parse(file, PLYLoader, { worker: false });
    const corners = mesh.indices.value.join(' ');
    console.log(`${name}: corners of triangles ${corners}`);
    if (corners !== expected) {
        console.error(`changed: ${name}`);
        process.exit(1);
    }
}
JS
node check.mjs
