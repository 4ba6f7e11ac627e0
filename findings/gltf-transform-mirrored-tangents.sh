#!/usr/bin/env bash
# @gltf-transform/core and @gltf-transform/functions 4.5.1 (npm).
#
# The guess: a mesh whose mirrored node is baked into it by clearNodeTransform looks
# as before, its normal map included.
# Observed: faces and normals are turned over rightly, but the fourth number of the
# tangents keeps its sign, so the bitangent points against the direction in which v
# grows: (0, -1, 0) where the texture coordinates say (0, 1, 0). Bumps of the normal
# map become dents in one direction. Without mirroring, and with two axes mirrored,
# the bitangent is right.
#
# Why the input is valid: glTF 2.0, 3.7.2.1 Overview of meshes: TANGENT is a vector
# with w of 1 or -1 for the handedness, the bitangent is cross(normal, tangent) * w;
# 3.7.4 Instantiation allows nodes of negative determinant.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
node_packages @gltf-transform/core@4.5.1 @gltf-transform/functions@4.5.1

cat > check.mjs <<'JS'
import { Document } from '@gltf-transform/core';
import { clearNodeTransform } from '@gltf-transform/functions';

// A triangle in the xy plane with u = x and v = y.
const baked = (scale) => {
    const document = new Document();
    const buffer = document.createBuffer();
    const attribute = (type, numbers) => document.createAccessor().setType(type)
        .setArray(new Float32Array(numbers)).setBuffer(buffer);
    const primitive = document.createPrimitive()
        .setAttribute('POSITION', attribute('VEC3', [0, 0, 0, 1, 0, 0, 0, 1, 0]))
        .setAttribute('NORMAL', attribute('VEC3', [0, 0, 1, 0, 0, 1, 0, 0, 1]))
        .setAttribute('TANGENT', attribute('VEC4', [1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1]))
        .setAttribute('TEXCOORD_0', attribute('VEC2', [0, 0, 1, 0, 0, 1]))
        .setIndices(document.createAccessor().setType('SCALAR').setArray(new Uint16Array([0, 1, 2])).setBuffer(buffer));
    const node = document.createNode().setMesh(document.createMesh().addPrimitive(primitive)).setScale(scale);
    document.createScene().addChild(node);
    clearNodeTransform(node);
    const [mesh] = node.getMesh().listPrimitives();
    return (name, place) => mesh.getAttribute(name).getElement(place, []);
};
const minus = (a, b) => a.map((value, axis) => value - b[axis]);
const cross = (a, b) => [0, 1, 2].map((axis) => {
    const [second, third] = [(axis + 1) % 3, (axis + 2) % 3];
    return a[second] * b[third] - a[third] * b[second];
});
const text = (vector) => vector.map((value) => value + 0).join(' ');

for (const [scale, kept] of [[[1, 1, 1], true], [[-1, -1, 1], true], [[-1, 1, 1], false], [[1, 1, -1], false]]) {
    const get = baked(scale);
    const alongV = minus(get('POSITION', 2), get('POSITION', 0));
    const [x, y, z, w] = get('TANGENT', 0);
    const bitangent = cross(get('NORMAL', 0), [x, y, z]).map((value) => value * w);
    console.log(`scale ${text(scale)}: v grows along ${text(alongV)}, bitangent ${text(bitangent)}`);
    const expected = kept ? alongV : alongV.map((value) => -value);
    if (text(bitangent) !== text(expected)) {
        console.error(`changed: the bitangent with scale ${text(scale)}`);
        process.exit(1);
    }
}
JS
node check.mjs
