#!/usr/bin/env bash
# three 0.187.0 (npm).
#
# The guess: faces of a 3D Studio mesh to which the file assigns no material are
# shown with a default material.
# Observed: three's TDSLoader builds drawing groups from the material lists only,
# so in a mesh with two materials a face of neither list is neither drawn nor hit
# by a ray: of three triangles two are left. In a mesh with one material such a
# face gets that material instead.
#
# Why the input is valid: the 3D Studio File Toolkit of Autodesk lists the faces
# of a material in MSH_MAT_GROUP (0x4130); faces in no list have the default
# material.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages three@0.187.0

cat > check.mjs <<'JS'
import { Raycaster, Vector3 } from 'three';
import { TDSLoader } from 'three/examples/jsm/loaders/TDSLoader.js';

const floats = (...values) => Buffer.from(new Float32Array(values).buffer);
const words = (...values) => Buffer.from(new Uint16Array(values).buffer);
const name = (text) => Buffer.from(`${text}\0`);
const chunk = (kind, ...parts) => {
    const head = Buffer.alloc(6);
    head.writeUInt16LE(kind, 0);
    head.writeUInt32LE(6 + parts.reduce((sum, part) => sum + part.length, 0), 2);
    return Buffer.concat([head, ...parts]);
};
const material = (text, ...rgb) => chunk(0xAFFF, chunk(0xA000, name(text)), chunk(0xA020, chunk(0x11, Buffer.from(rgb))));
// Triangles side by side at x = 0, 1 and 2; a list names the faces of a material.
const scene = (...lists) => chunk(0x4D4D, chunk(0x3D3D,
    material('red', 255, 0, 0), material('blue', 0, 0, 255),
    chunk(0x4000, name('row'), chunk(0x4100,
        chunk(0x4110, words(9), floats(...[0, 1, 2].flatMap((x) => [x, 0, 0, x + 1, 0, 0, x, 1, 0]))),
        chunk(0x4120, words(3, 0, 1, 2, 7, 3, 4, 5, 7, 6, 7, 8, 7),
            ...lists.map(([text, face]) => chunk(0x4130, name(text), words(1, face))))))));

const hits = (file) => {
    const group = new TDSLoader().parse(new Uint8Array(file).buffer, '');
    group.updateMatrixWorld(true);
    return [0, 1, 2].map((x) => new Raycaster(new Vector3(x + 0.2, 0.2, 1), new Vector3(0, 0, -1))
        .intersectObject(group, true).length).join(' ');
};
const cases = [
    ['no list', hits(scene()), '1 1 1'],
    ['red has face 0', hits(scene(['red', 0])), '1 1 1'],
    ['red has face 0, blue face 1', hits(scene(['red', 0], ['blue', 1])), '1 1 0'],
];
for (const [title, found, expected] of cases) {
    console.log(`${title}: hits ${found}`);
    if (found !== expected) {
        console.error(`changed: hits where ${title}`);
        process.exit(1);
    }
}
JS
node check.mjs
