#!/usr/bin/env bash
# three 0.187.0, @loaders.gl/obj 4.4.5 with @loaders.gl/core 4.4.5 (npm),
# trimesh 5.2.0, meshio 5.3.5, mitsuba 3.9.1 and assimp-py 1.1.0 (Python, with its
# bundled Assimp).
#
# The guess: a comment behind the corners of a face is skipped.
# Observed: only Mitsuba reads `f 1 2 3 # left wall` as one triangle. three and
# loaders.gl take the three words of the comment for corners and give four
# triangles, three of them with corners that are not numbers, without an error.
# trimesh, meshio and Assimp refuse the file.
#
# Why the input is valid: Wavefront, Advanced Visualizer manual, appendix B1,
# comments: they may stand anywhere in the file.
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"
python_packages trimesh==5.2.0 meshio==5.3.5 mitsuba==3.9.1 assimp-py==1.1.0 numpy==2.4.6
node_packages three@0.187.0 @loaders.gl/core@4.4.5 @loaders.gl/obj@4.4.5

printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 # left wall\n' > wall.obj
cat > check.py <<'PY'
import sys

import assimp_py
import meshio
import mitsuba
import trimesh

mitsuba.set_variant("scalar_rgb")
readers = {
    "mitsuba": lambda: mitsuba.load_dict({"type": "obj", "filename": "wall.obj"}).face_count(),
    "trimesh": lambda: len(trimesh.load("wall.obj", process=False).faces),
    "meshio": lambda: len(meshio.read("wall.obj").cells[0].data),
    "assimp": lambda: len(assimp_py.import_file("wall.obj", assimp_py.Process_Triangulate).meshes[0].indices) // 3,
}
for name, read in readers.items():
    try:
        found = read()
    except (RuntimeError, ValueError) as error:
        found = str(error)
    print(f"{name}: {found}")
    if (found == 1) != (name == "mitsuba"):
        sys.exit(f"changed: what {name} makes of the comment")
PY
cat > check.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { parse } from '@loaders.gl/core';
import { OBJLoader as LoadersGl } from '@loaders.gl/obj';
import { OBJLoader as Three } from 'three/examples/jsm/loaders/OBJLoader.js';

const text = readFileSync('wall.obj', 'utf8');
const found = {
    three: new Three().parse(text).children[0].geometry.attributes.position.array,
    'loaders.gl': (await parse(text, LoadersGl, { worker: false })).attributes.POSITION.value,
};
for (const [name, values] of Object.entries(found)) {
    const broken = values.filter(Number.isNaN).length / 3;
    console.log(`${name}: ${values.length / 9} triangles, ${broken} corners not numbers`);
    if (values.length !== 36 || broken !== 5) {
        console.error(`changed: what ${name} makes of the comment`);
        process.exit(1);
    }
}
JS
python check.py
node check.mjs
