#!/usr/bin/env bash
# three 0.187.0 and @loaders.gl/ply 4.4.5 with @loaders.gl/core 4.4.5 (npm).
#
# The guess: a face of five corners is cut into triangles, as one of four is, or
# refused.
# Observed: both readers leave it out, without an error. Of a house front of a
# pentagon, a square and a triangle there remain two triangles for the square and
# the triangle, and a hole where the pentagon was.
#
# Why the input is valid: "The PLY Polygon File Format" by Turk describes a face
# as a list of vertex indices with its own count, for polygons of any size.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages three@0.187.0 @loaders.gl/core@4.4.5 @loaders.gl/ply@4.4.5

cat > check.mjs <<'JS'
import { parse } from '@loaders.gl/core';
import { PLYLoader as LoadersGl } from '@loaders.gl/ply';
import { PLYLoader as Three } from 'three/examples/jsm/loaders/PLYLoader.js';

const text = `ply
format ascii 1.0
element vertex 7
property float x
property float y
property float z
element face 3
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0.5 1.5 0
0 1 0
2 0 0
2 1 0
5 0 1 2 3 4
4 1 5 6 2
3 2 6 3
`;
const file = new Uint8Array(Buffer.from(text)).buffer;
const found = {
    three: [...new Three().parse(file).index.array],
    'loaders.gl': [...(await parse(file, LoadersGl, { worker: false })).indices.value],
};
for (const [name, corners] of Object.entries(found)) {
    console.log(`${name}: corners of triangles ${corners.join(' ')}`);
    if (corners.length !== 9 || corners.includes(0) || corners.includes(4)) {
        console.error(`changed: the faces that ${name} gives`);
        process.exit(1);
    }
}
JS
node check.mjs
