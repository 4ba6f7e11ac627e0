#!/usr/bin/env bash
# three 0.187.0 (npm) and assimp-py 1.1.0 (Python, with its bundled Assimp).
#
# The guess: readers of 3D Studio files apply the master scale the same way, or
# leave it alone.
# Observed: for a triangle with a side of 1 and a master scale of 10, three's
# TDSLoader makes the side 10 and Assimp makes it 0.1: the same file loads a
# hundred times larger in one than in the other. With a scale of 1 both give 1.
#
# Why the input is valid: the 3D Studio File Toolkit of Autodesk has the chunk
# MASTER_SCALE (0x0100, one float) in the mesh data section; 3D Studio writes it
# into the files it saves.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages assimp-py==1.1.0
node_packages three@0.187.0

cat > check.py <<'PY'
import struct
import sys

import assimp_py


def chunk(kind, *parts):
    data = b"".join(parts)
    return struct.pack("<HI", kind, 6 + len(data)) + data


def scene(scale):
    vertices = struct.pack("<H9f", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0)
    faces = struct.pack("<5H", 1, 0, 1, 2, 7)
    mesh = chunk(0x4100, chunk(0x4110, vertices), chunk(0x4120, faces))
    edit = chunk(0x3D3D, chunk(0x0100, struct.pack("<f", scale)), chunk(0x4000, b"tri\0", mesh))
    return chunk(0x4D4D, edit)


def side(name):
    loaded = assimp_py.import_file(name, assimp_py.Process_PreTransformVertices)
    return max(abs(value) for value in loaded.meshes[0].vertices)


for scale, expected in ((1, 1), (10, 0.1)):
    name = f"scale{scale}.3ds"
    with open(name, "wb") as file:
        file.write(scene(scale))
    found = side(name)
    print(f"Assimp, master scale {scale}: side {found:g}")
    if abs(found - expected) > 1e-6:
        sys.exit(f"changed: Assimp uses a master scale of {scale} otherwise")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { Box3 } from 'three';
import { TDSLoader } from 'three/examples/jsm/loaders/TDSLoader.js';

for (const scale of [1, 10]) {
    const bytes = new Uint8Array(readFileSync(`scale${scale}.3ds`));
    const found = new Box3().setFromObject(new TDSLoader().parse(bytes.buffer, '')).max.x;
    console.log(`three, master scale ${scale}: side ${found}`);
    if (found !== scale) {
        console.error(`changed: three uses a master scale of ${scale} otherwise`);
        process.exit(1);
    }
}
JS
python check.py
node check.mjs
