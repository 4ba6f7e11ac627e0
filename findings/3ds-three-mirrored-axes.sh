#!/usr/bin/env bash
# three 0.187.0 (npm).
#
# The guess: a 3D Studio mesh whose local axes are mirrored looks like the same
# mesh without local axes, since its vertices are stored in world space.
# Observed: three's TDSLoader leaves the vertices in place and turns the faces
# inside out, without an error: a square that faces up is hit by a ray from above
# without the axes, and only by a ray from below with them; its normals point
# down.
#
# Why the input is valid: the 3D Studio File Toolkit of Autodesk has the chunk
# MESH_MATRIX (0x4160, three axes and an origin) beside the vertices; an object
# mirrored by the modeller has axes of negative determinant, while its vertices
# and faces are stored as they stand in the world.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages three@0.187.0

cat > check.mjs <<'JS'
import { Matrix3, Raycaster, Vector3 } from 'three';
import { TDSLoader } from 'three/examples/jsm/loaders/TDSLoader.js';

const packed = (type, values) => Buffer.from(new type(values).buffer);
const floats = (...values) => packed(Float32Array, values);
const words = (...values) => packed(Uint16Array, values);
const chunk = (kind, ...parts) => {
    const head = Buffer.alloc(6);
    head.writeUInt16LE(kind, 0);
    head.writeUInt32LE(6 + parts.reduce((sum, part) => sum + part.length, 0), 2);
    return Buffer.concat([head, ...parts]);
};
const square = (...axes) => chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, Buffer.from('square\0'), chunk(0x4100,
    chunk(0x4110, words(4), floats(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0)),
    ...axes.map((numbers) => chunk(0x4160, floats(...numbers))),
    chunk(0x4120, words(2, 0, 1, 2, 7, 0, 2, 3, 7))))));

const look = (name, file) => {
    const group = new TDSLoader().parse(new Uint8Array(file).buffer, '');
    group.updateMatrixWorld(true);
    const hits = (from, to) => new Raycaster(from, to).intersectObject(group, true).length;
    const mesh = group.children[0];
    const normal = new Vector3().fromBufferAttribute(mesh.geometry.attributes.normal, 0)
        .applyMatrix3(new Matrix3().getNormalMatrix(mesh.matrixWorld)).normalize();
    const text = `above ${hits(new Vector3(0.3, 0.2, 1), new Vector3(0, 0, -1))}, `
        + `below ${hits(new Vector3(0.3, 0.2, -1), new Vector3(0, 0, 1))}, normal ${Math.round(normal.z)}`;
    console.log(`${name}: hits from ${text}`);
    return text;
};
const changed = (what) => { console.error(`changed: ${what}`); process.exit(1); };
if (look('no axes', square()) !== 'above 1, below 0, normal 1') changed('the square without axes');
if (look('plain axes', square([1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 0, 0])) !== 'above 1, below 0, normal 1') {
    changed('the square with unmirrored axes');
}
if (look('mirrored axes', square([-1, 0, 0, 0, 1, 0, 0, 0, 1, 5, 0, 0])) !== 'above 0, below 1, normal -1') {
    changed('the square with mirrored axes');
}
JS
node check.mjs
